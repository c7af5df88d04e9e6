# Builds the rooms that the program needs once more, without optimisation; the build folder is kept for the next run.
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
build_consumer(add_subdirectory -D STRATA_SOURCE=${SOURCE} -D STRATA_EXTENSIONS=none -D STRATA_PRECOMPILED=ON
  -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_FLAGS_DEBUG=-O0)
