# Installs the library into a folder of its own, builds examples/library against it outside the
# source tree, and runs that. Variables: BUILD, SOURCE, WORK, BODY (folder of body.lfb), COMPILER.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nexit code ${code}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --component library)
file(COPY ${SOURCE}/examples/library DESTINATION ${WORK})
run(${CMAKE_COMMAND} -S ${WORK}/library -B ${WORK}/build -DCMAKE_CXX_COMPILER=${COMPILER}
  -DCMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/build)

file(WRITE ${WORK}/shirt.toml "[garment]\npattern = \"tank-top\"\n[donning]\nmovements = []\n\
[simulation]\nedge_length = 0.040\n")
run(${CMAKE_COMMAND} -E env ${WORK}/build/shirt ${WORK}/shirt.toml ${BODY})
if(NOT output MATCHES "vertices.*holds.*largest distance from the body: [0-9.]+ mm")
  message(FATAL_ERROR "the example printed\n${output}")
endif()

# A folder without data ends in an error that tells where was looked.
execute_process(COMMAND ${WORK}/build/shirt ${WORK}/shirt.toml ${WORK}/nowhere
  RESULT_VARIABLE code ERROR_VARIABLE complaint)
if(NOT code EQUAL 2 OR NOT complaint MATCHES "nowhere/body.lfb: found no body data.*looked in")
  message(FATAL_ERROR "exit code ${code}\n${complaint}")
endif()
file(REMOVE_RECURSE ${WORK})
