# Each <demo>.txt here is one line of a demo, and what a student could have written instead: a wrong sign, a wrong order, a state that
# is not set. mvgl_make_twin(<demo>) makes the object library twin-<demo> with that change, of demos/<demo>/<demo>.cpp; MVGL_TWIN_OBJECTS
# gets it and the demo's other objects. The file's lines:
#   golden <the golden picture that the twin must not match>
#   - <a line of the demo, or a part of one that occurs once>
#   + <what a student could have written instead>
function(mvgl_make_twin demo)
  set(recipe "${CMAKE_CURRENT_SOURCE_DIR}/twins/${demo}.txt")
  set(source "${PROJECT_SOURCE_DIR}/demos/${demo}/${demo}.cpp")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${recipe}" "${source}")
  file(READ "${recipe}" recipeText)
  if(NOT recipeText MATCHES "\n- ([^\n]+)\n\\+ ([^\n]*)\n$")
    message(FATAL_ERROR "${recipe}: must end with a line '- old' and a line '+ new'")
  endif()
  set(old "${CMAKE_MATCH_1}")
  set(new "${CMAKE_MATCH_2}")
  file(READ "${source}" text)
  string(FIND "${text}" "${old}" first)
  string(FIND "${text}" "${old}" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    message(FATAL_ERROR "${recipe}: the '-' line must occur once in ${source}")
  endif()
  string(REPLACE "${old}" "${new}" changed "${text}")
  set(twin "${CMAKE_CURRENT_BINARY_DIR}/twin-${demo}.cpp")
  file(CONFIGURE OUTPUT "${twin}" CONTENT "${changed}" @ONLY)
  add_library(twin-${demo} OBJECT "${twin}")
  target_link_libraries(twin-${demo} PRIVATE mvgl-test-support)
  target_compile_options(twin-${demo} PRIVATE ${testOptions})
  target_precompile_headers(twin-${demo} REUSE_FROM mvgl-test-support)
  target_include_directories(twin-${demo} PRIVATE "${PROJECT_SOURCE_DIR}/demos/${demo}")
  set(objects "${MVGL_TWIN_OBJECTS}" $<TARGET_OBJECTS:twin-${demo}>
    $<FILTER:$<TARGET_OBJECTS:demo-${demo}>,EXCLUDE,/${demo}/${demo}\\.cpp>)
  set(MVGL_TWIN_OBJECTS "${objects}" PARENT_SCOPE)
endfunction()

# All demos, those three with their change.
set(MVGL_TWIN_OBJECTS "")
foreach(demo IN LISTS MVGL_DEMO_NAMES)
  if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/twins/${demo}.txt")
    mvgl_make_twin(${demo})
  else()
    list(APPEND MVGL_TWIN_OBJECTS $<TARGET_OBJECTS:demo-${demo}>)
  endif()
endforeach()
