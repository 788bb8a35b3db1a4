# One demo's program waits for what it takes: cube-cull's for no file that lessons share, no motion, no other demo.
execute_process(COMMAND "${NINJA}" -C "${BUILD}" -t inputs cube-cull OUTPUT_VARIABLE inputs COMMAND_ERROR_IS_FATAL ANY)
if(NOT inputs MATCHES "demo-cube-cull" OR NOT inputs MATCHES "libmv-base")
  message(FATAL_ERROR "cube-cull: must have its own files and mv-base among what it is made of\n${inputs}")
endif()
string(REGEX MATCHALL "[^\n]*(lesson-|mv-motion|mv-geometry|demos/shared/|mvgl-window)[^\n]*" others "${inputs}")
if(others)
  message(FATAL_ERROR "cube-cull: must wait for nothing that it does not include\n${others}")
endif()
