# Builds the whole library once more, unoptimised to be quick; the build folder is kept for the next run.
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
build_consumer(add_subdirectory -D STRATA_SOURCE=${SOURCE} -D STRATA_WITH_ASSIMP=OFF -D CMAKE_BUILD_TYPE=None)
