# Compiles overload_trap.cpp once with right calls, which must succeed, and once for each wrong one, which the compiler
# must refuse as deleted: any other error would prove nothing.
foreach(trap RANGE 0 13)
  execute_process(COMMAND "${COMPILER}" -std=c++20 "-I${INCLUDE}" "-DMVGL_TRAP=${trap}" -fsyntax-only "${SOURCE}"
    RESULT_VARIABLE status ERROR_VARIABLE errors)
  if(trap EQUAL 0 AND NOT status EQUAL 0)
    message(FATAL_ERROR "the right calls must compile:\n${errors}")
  endif()
  if(trap GREATER 0 AND (status EQUAL 0 OR NOT errors MATCHES "deleted"))
    message(FATAL_ERROR "the wrong call ${trap} must be refused as deleted:\n${errors}")
  endif()
endforeach()
message("1 source with right calls compiles, 13 with wrong calls do not")
