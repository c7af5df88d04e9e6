# Lists of extensions: what they use is built as well, what there is not is refused. Configures only.
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
file(REMOVE_RECURSE ${SCRATCH})
file(WRITE ${SCRATCH}/list.cmake "set(STRATA_EXTENSIONS planar convex CACHE STRING \"\")\n")
file(WRITE ${SCRATCH}/refused.cmake "set(STRATA_EXTENSIONS planar knots CACHE STRING \"\")\n")
set(library -S ${SOURCE} -G ${GENERATOR} -C ${OPTIONS} -D CMAKE_CXX_COMPILER=${CXX} -D STRATA_BUILD_TESTS=OFF
  -D STRATA_BUILD_TOOLS=OFF)

run(${CMAKE_COMMAND} ${library} -C ${SCRATCH}/list.cmake -B ${SCRATCH}/list)
foreach(sentence "extension convex uses the extension bsp" "extension bsp uses the extension scene")
  if(NOT run_output MATCHES "${sentence}, which is built as well")
    message(FATAL_ERROR "expected '${sentence}' in: ${run_output}")
  endif()
endforeach()
file(READ ${SCRATCH}/list/strataConfig.cmake config)
if(NOT config MATCHES "strata_extensions scene;bsp;planar;convex\\)")
  message(FATAL_ERROR "unexpected extensions: ${config}")
endif()
expect_refusal("there is no extension 'knots'; these are known: +scene, bsp," ${library} -C ${SCRATCH}/refused.cmake
  -B ${SCRATCH}/refused)
