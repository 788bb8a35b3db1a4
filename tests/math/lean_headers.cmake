# How many lines of code the compiler reads for the three headers that nearly every demo includes, each below a bound: a demo is compiled
# again whenever it is edited, and most of that time is spent on headers. What a bound is made of, in lines of g++ 12's library (newer
# ones have up to a fifth more): strings, vectors, <cmath> and GLM's matrices 40,000, std::function 11,000, owning pointers 11,000, and
# 8,000 of mvgl's own, optional values and the names of OpenGL. <filesystem> would add 9,000, <iostream> 1,300, <random> 6,400, and no
# demo needs them of these headers.
set(bound_mv/demo/demo.h 84000)
set(bound_mv/gl/gl.h 84000)
set(bound_mv/math/transform.h 33000)
foreach(header IN ITEMS mv/demo/demo.h mv/gl/gl.h mv/math/transform.h)
  execute_process(COMMAND "${COMPILER}" -std=c++20 -I "${INCLUDE}" -E -P -x c++ -include "${header}" /dev/null
    OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE "[^\n]" "" ends "${text}")
  string(LENGTH "${ends}" lines)
  message(STATUS "${header}: ${lines} lines")
  if(lines GREATER bound_${header})
    message(SEND_ERROR "${header}: must be below ${bound_${header}} lines with all that it includes, ${lines}")
  endif()
  if(text MATCHES "namespace filesystem\n|class random_device|extern ostream cout")
    message(SEND_ERROR "${header}: must include none of <filesystem>, <iostream> and <random>, ${CMAKE_MATCH_0}")
  endif()
endforeach()
