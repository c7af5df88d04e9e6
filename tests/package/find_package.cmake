include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
install_strata()
build_consumer(find_package -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix)
