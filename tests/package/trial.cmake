# Installs `build` under a fresh prefix, configures and builds the consumer against it alone, and runs both programs.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "${command}\nfailed (${status}):\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${work})
run(${CMAKE_COMMAND} --install ${build} --config ${config} --prefix ${work}/prefix)
# moved, so that a path frozen at install time would show
file(RENAME ${work}/prefix ${work}/moved)
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${work}/consumer -G Ninja
    -D CMAKE_PREFIX_PATH=${work}/moved -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_BUILD_TYPE=Debug)
run(${CMAKE_COMMAND} --build ${work}/consumer)
run(${work}/consumer/consumer)
run(${work}/moved/bin/sundrape --version)
# fabrics are found from the executable: this one is nowhere else
file(COPY_FILE ${work}/moved/share/sundrape/fabrics/cotton-twill.toml ${work}/moved/share/sundrape/fabrics/trial.toml)
run(${work}/moved/bin/sundrape check ${work}/moved/share/sundrape/cases/swing.toml --set material.fabric=trial)
foreach(file share/sundrape/cases/tablecloth.toml share/sundrape/fabrics/cotton-twill.toml
             share/sundrape/postproc/sundrape_postproc/__main__.py)
  if(NOT EXISTS ${work}/moved/${file})
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()
