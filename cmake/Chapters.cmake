# Which demos stand in a chapter, by the line `.chapter = "..."` of one of their files. For browsers a module is a chapter; there and for
# the sanitizers its demos are compiled as one, in two thirds of the time or less.

# mvgl_chapter_of(<variable> <file>...): of a demo's files; "Viewing and projection" as viewing-and-projection.
function(mvgl_chapter_of variable)
  foreach(file IN LISTS ARGN)
    file(STRINGS "${file}" line REGEX "^ *\\.chapter = ")
    if(line)
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
      string(REGEX REPLACE ".*\"(.*)\".*" "\\1" chapter "${line}")
      string(TOLOWER "${chapter}" chapter)
      string(REGEX REPLACE "[^a-z0-9 ]" "" chapter "${chapter}")
      string(REPLACE " " "-" chapter "${chapter}")
      set(${variable} "${chapter}" PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "${ARGN}: must have a line .chapter = \"...\" in one of them")
endfunction()
