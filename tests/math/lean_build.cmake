# One demo's program waits for what it takes: cube-ortho's for the one file of demos/shared that it includes, and no geometry, no motion,
# no other demo.
execute_process(COMMAND "${NINJA}" -C "${BUILD}" -t inputs cube-ortho OUTPUT_VARIABLE inputs COMMAND_ERROR_IS_FATAL ANY)
if(NOT inputs MATCHES "demo-cube-ortho" OR NOT inputs MATCHES "libmv-base" OR NOT inputs MATCHES "lesson-view_figure")
  message(FATAL_ERROR "cube-ortho: must have its own files, mv-base and view_figure among what it is made of\n${inputs}")
endif()
string(REGEX REPLACE "[^\n]*view_figure[^\n]*" "" inputs "${inputs}")
string(REGEX MATCHALL "[^\n]*(lesson-|mv-motion|mv-geometry|demos/shared/|mvgl-window)[^\n]*" others "${inputs}")
if(others)
  message(FATAL_ERROR "cube-ortho: must wait for nothing that it does not include\n${others}")
endif()
