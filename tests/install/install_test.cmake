# Installs the build into an empty prefix, moves the prefix, and builds and runs a project that uses the package there.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${status}:\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})
run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/first --config ${config})
file(RENAME ${work}/first ${work}/moved)

# Every header that is installed must compile, whichever is included first.
file(GLOB_RECURSE headers RELATIVE ${work}/moved/include ${work}/moved/include/*.h)
list(LENGTH headers count)
if(count LESS 20)
  message(FATAL_ERROR "only ${count} headers were installed")
endif()
list(SORT headers)
foreach(order forward backward)
  set(text "")
  foreach(header IN LISTS headers)
    string(REGEX REPLACE "^pliant/formats/" "formats/" header ${header})
    string(APPEND text "#include \"${header}\"\n")
  endforeach()
  file(WRITE ${work}/${order}.cpp "${text}")
  list(REVERSE headers)
endforeach()

run(${CMAKE_COMMAND} -S ${consumer} -B ${work}/build -G ${generator} -D CMAKE_PREFIX_PATH=${work}/moved
    -D CMAKE_BUILD_TYPE=${config} -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_CXX_FLAGS=${flags}
    -D headers=${work}/forward.cpp\;${work}/backward.cpp)
run(${CMAKE_COMMAND} --build ${work}/build --config ${config})
run(${work}/build/consumer)
