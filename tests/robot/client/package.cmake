# Installs the client alone, and builds the examples with it as a team's own project.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE talk ERROR_VARIABLE talk)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${talk}")
  endif()
endfunction()

file(REMOVE_RECURSE ${FOLDER})
run(${CMAKE_COMMAND} --install ${BUILD} --component client --prefix ${FOLDER}/installed)
run(${CMAKE_COMMAND} -S ${EXAMPLES} -B ${FOLDER}/build -DCMAKE_PREFIX_PATH=${FOLDER}/installed
  -DCMAKE_C_COMPILER=${C_COMPILER} -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_C_FLAGS=${FLAGS} -DCMAKE_CXX_FLAGS=${FLAGS})
run(${CMAKE_COMMAND} --build ${FOLDER}/build)
# no runtime is there: the examples must end and report their losses
foreach(example example_team_framework example_vortex example_truth)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env FORESIGHT_DOOR=${FOLDER}/none ${FOLDER}/build/${example} 0.05
    OUTPUT_VARIABLE talk RESULT_VARIABLE status)
  if(NOT status EQUAL 0 OR NOT talk MATCHES "lost: ")
    message(FATAL_ERROR "${example} ended with ${status}: ${talk}")
  endif()
endforeach()
