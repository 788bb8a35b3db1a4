# mvgl_add_demo(<name> [SOURCE <file>] [SHADERS <folder>])
#
# Makes the program <name> of one demo: <name>.cpp in the current folder (or SOURCE), with the shader files
# <name>.vert, <name>.frag, <name>.<variant>.vert ... of the folder SHADERS (default: ../shaders beside the current
# folder, else the current folder) built in, and the folder's include/*.glsl with them; and the demo's committed study,
# where ../docs/errors-and-times beside the shaders has one.
# The demo's objects are the target demo-<name>, for programs of several demos.
function(mvgl_embed_shaders target name folder)
  file(GLOB files CONFIGURE_DEPENDS
    "${folder}/${name}.vert" "${folder}/${name}.frag" "${folder}/${name}.geom" "${folder}/${name}.tesc"
    "${folder}/${name}.tese" "${folder}/${name}.*.vert" "${folder}/${name}.*.frag" "${folder}/${name}.*.geom"
    "${folder}/${name}.*.tesc" "${folder}/${name}.*.tese" "${folder}/include/*.glsl")
  if(NOT files)
    message(FATAL_ERROR "${name}: no shader files ${name}.vert, ${name}.frag in ${folder}")
  endif()
  file(GLOB study CONFIGURE_DEPENDS "${folder}/../docs/errors-and-times/${name}.json")
  set(output "${CMAKE_CURRENT_BINARY_DIR}/${target}-shaders.cpp")
  add_custom_command(OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${output}" "-DFILES=${files}" "-DPATHS=${MVGL_SHADERS_FROM_SOURCE}"
      "-DSTUDY=${study}" "-DNAME=${name}"
      -P "${MVGL_CMAKE_DIR}/EmbedShaders.cmake"
    DEPENDS ${files} ${study} "${MVGL_CMAKE_DIR}/EmbedShaders.cmake" VERBATIM
    COMMENT "Embedding the shaders of ${name}")
  target_sources(${target} PRIVATE "${output}")
endfunction()

function(mvgl_add_demo name)
  cmake_parse_arguments(PARSE_ARGV 1 demo "" "SOURCE;SHADERS" "")
  if(NOT demo_SOURCE)
    set(demo_SOURCE "${CMAKE_CURRENT_SOURCE_DIR}/${name}.cpp")
  endif()
  if(NOT demo_SHADERS)
    set(demo_SHADERS "${CMAKE_CURRENT_SOURCE_DIR}/../shaders")
    if(NOT IS_DIRECTORY "${demo_SHADERS}")
      set(demo_SHADERS "${CMAKE_CURRENT_SOURCE_DIR}")
    endif()
  endif()
  add_library(demo-${name} OBJECT "${demo_SOURCE}")
  target_link_libraries(demo-${name} PUBLIC mvgl::demo)
  mvgl_embed_shaders(demo-${name} ${name} "${demo_SHADERS}")
  add_executable(${name} "${MVGL_MAIN_FILE}" $<TARGET_OBJECTS:demo-${name}>)
  target_link_libraries(${name} PRIVATE mvgl::demo)
endfunction()
