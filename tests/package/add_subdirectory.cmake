# Builds the whole library once more, from the compiler cache if there is one; the build folder is kept for the next run.
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
find_program(CCACHE ccache)
set(launcher "")
if(CCACHE)
  set(launcher -D CMAKE_CXX_COMPILER_LAUNCHER=${CCACHE})
  set(ENV{CCACHE_NOHASHDIR} 1)
endif()
build_consumer(add_subdirectory -D STRATA_SOURCE=${SOURCE} ${launcher})
