# mvgl_add_demo(<name> [TARGET <target>] [SOURCE <file>] [SHADERS <folder>] [LIBRARIES <library>...])
#
# Makes the program <name> of one demo: all <name>/*.cpp in the current folder, a lesson; or <name>.cpp there (or SOURCE) with
# <name>.study.cpp, where there is one. Built in are the shader files of the folder SHADERS (default: ../shaders beside the
# current folder, else the current folder): all of its folder <name>, or <name>.vert, <name>.frag, <name>.<variant>.vert
# ...; its include/*.glsl; and the committed studies, where ../docs/errors-and-times beside the shaders has some.
# It links LIBRARIES (default: mvgl::demo, the library and all of mv).
# The program is the target <target> (default: <name>); the demo's objects are demo-<target>, for programs of several demos.
#
# Built programs read the shaders where they are edited. Installed ones must not: so no path is built in. It stands in a file
# mvgl-shaders/demo-<target> in the folder of the library, or of the program where the library is an installed one.
function(mvgl_embed_shaders target name folder)
  file(GLOB files CONFIGURE_DEPENDS
    "${folder}/${name}.vert" "${folder}/${name}.frag" "${folder}/${name}.geom" "${folder}/${name}.tesc"
    "${folder}/${name}.tese" "${folder}/${name}.comp" "${folder}/${name}.*.vert" "${folder}/${name}.*.frag" "${folder}/${name}.*.geom"
    "${folder}/${name}.*.tesc" "${folder}/${name}.*.tese" "${folder}/${name}.*.comp" "${folder}/${name}/*.*" "${folder}/include/*.glsl")
  if(NOT files)
    message(FATAL_ERROR "${name}: no shader files ${name}.vert, ${name}.frag in ${folder}")
  endif()
  file(GLOB studies CONFIGURE_DEPENDS "${folder}/../docs/errors-and-times/${name}.*.csv")
  set(output "${CMAKE_CURRENT_BINARY_DIR}/${target}-shaders.cpp")
  add_custom_command(OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${output}" "-DFILES=${files}" "-DROOT=${folder}" "-DGROUP=${target}"
      "-DSTUDIES=${studies}" "-DNAME=${name}"
      -P "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/EmbedShaders.cmake"
    DEPENDS ${files} ${studies} "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/EmbedShaders.cmake" VERBATIM
    COMMENT "Embedding the shaders of ${name}")
  target_sources(${target} PRIVATE "${output}")
  set_source_files_properties("${output}" PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endfunction()

# mvgl_demo_sources(<variable> <name> <source>): the files of that demo.
function(mvgl_demo_sources variable name source)
  if(NOT source AND EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${name}/${name}.cpp")
    file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp")
  else()
    if(NOT source)
      set(source "${CMAKE_CURRENT_SOURCE_DIR}/${name}.cpp")
    endif()
    # What measures it, where there is such a file.
    cmake_path(REPLACE_EXTENSION source LAST_ONLY ".study.cpp" OUTPUT_VARIABLE study)
    file(GLOB study CONFIGURE_DEPENDS "${study}")
    set(sources "${source}" ${study})
  endif()
  set(${variable} ${sources} PARENT_SCOPE)
endfunction()

function(mvgl_add_demo name)
  cmake_parse_arguments(PARSE_ARGV 1 demo "" "TARGET;SOURCE;SHADERS" "LIBRARIES")
  if(NOT demo_TARGET)
    set(demo_TARGET ${name})
  endif()
  if(NOT demo_LIBRARIES)
    set(demo_LIBRARIES mvgl::demo)
  endif()
  if(NOT demo_SHADERS)
    set(demo_SHADERS "${CMAKE_CURRENT_SOURCE_DIR}/../shaders")
    if(NOT IS_DIRECTORY "${demo_SHADERS}")
      set(demo_SHADERS "${CMAKE_CURRENT_SOURCE_DIR}")
    endif()
  endif()
  # Compiled once in mvgl's own build; else in the source tree, or installed beside this file.
  set(main "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/main.cpp")
  if(TARGET mvgl-main)
    set(main $<TARGET_OBJECTS:mvgl-main>)
  elseif(NOT EXISTS "${main}")
    set(main "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../common/mv/run/main.cpp")
  endif()
  set(objects demo-${demo_TARGET})
  mvgl_demo_sources(sources ${name} "${demo_SOURCE}")
  add_library(${objects} OBJECT ${sources})
  target_link_libraries(${objects} PUBLIC ${demo_LIBRARIES})
  mvgl_embed_shaders(${objects} ${name} "${demo_SHADERS}")
  add_executable(${demo_TARGET} ${main} $<TARGET_OBJECTS:${objects}>)
  set_target_properties(${demo_TARGET} PROPERTIES OUTPUT_NAME ${name})
  target_link_libraries(${demo_TARGET} PRIVATE ${demo_LIBRARIES})

  set(place "$<TARGET_FILE_DIR:${demo_TARGET}>")
  if(TARGET mvgl-demo)
    set(place "$<TARGET_FILE_DIR:mvgl-demo>")
  endif()
  cmake_path(ABSOLUTE_PATH demo_SHADERS NORMALIZE)
  # Relative to that file: a tree can be moved.
  file(GENERATE OUTPUT "${place}/mvgl-shaders/${objects}"
    CONTENT "$<PATH:RELATIVE_PATH,${demo_SHADERS},${place}/mvgl-shaders>\n")
endfunction()
