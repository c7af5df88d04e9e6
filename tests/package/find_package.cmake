include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
install_strata()
build_consumer(find_package -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix)

# An extension that is not there is refused by name.
expect_refusal("strata was built without the extension 'knots'; extensions that it has: scene, bsp, .*openscad"
  -S ${CONSUMER}/find_package -B ${SCRATCH}/refused -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${CXX}
  -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix -D MORE_COMPONENTS=knots)
