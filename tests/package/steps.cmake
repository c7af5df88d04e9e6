# What the package tests share.

# Runs a command; its failure is the test's failure.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${out}\n${err}")
  endif()
  set(run_output "${out}" PARENT_SCOPE)
endfunction()

# Installs the build into SCRATCH/prefix.
function(install_strata)
  file(REMOVE_RECURSE ${SCRATCH})
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix --config ${CONFIG})
endfunction()

# The program removes a tetrahedron of volume 27/6 from one of volume 64/6.
function(expect_answer program)
  run(${program})
  if(NOT run_output MATCHES "volume 37/6\n$")
    message(FATAL_ERROR "unexpected output: ${run_output}")
  endif()
endfunction()

# Configures, builds and runs the consumer in the folder CONSUMER/<way>.
function(build_consumer way)
  run(${CMAKE_COMMAND} -S ${CONSUMER}/${way} -B ${SCRATCH}/build -G ${GENERATOR} -C ${OPTIONS}
    -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_CXX_FLAGS=${FLAGS} ${ARGN})
  run(${CMAKE_COMMAND} --build ${SCRATCH}/build -j 2)
  expect_answer(${SCRATCH}/build/program)
endfunction()

# Configures a project, which must fail and say so.
function(expect_refusal sentence)
  execute_process(COMMAND ${CMAKE_COMMAND} ${ARGN} RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE err)
  string(REGEX REPLACE "[ \n]+" " " err "${err}")
  if(status EQUAL 0 OR NOT err MATCHES "${sentence}")
    message(FATAL_ERROR "expected '${sentence}', found exit status ${status}: ${err}")
  endif()
endfunction()
