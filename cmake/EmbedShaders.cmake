# Run as a script: writes OUTPUT, a C++ file that adds each of FILES to the embedded shaders. It includes nothing: there is one for
# each demo, and headers would take longer than all the rest of it.
# STUDY, where it exists, is the committed study of the demo NAME.
# A file in a folder called include keeps that folder in its name. GROUP names the file that says where they are edited.
# With BARE they are without comments and indents, each line at its number.
set(code "// Generated from shader files; do not edit.\nnamespace mv {\nbool addBuiltShader(const char* group, const char* name, const char* text);\nbool addStudyFile(const char* demo, const char* text);\n}\n\n")
set(entries "")
foreach(file IN LISTS FILES)
  file(READ "${file}" text)
  if(BARE)
    string(REGEX REPLACE "[ \t]*//[^\n]*" "" text "${text}")
    string(REGEX REPLACE "\n[ \t]+" "\n" text "${text}")
  endif()
  get_filename_component(name "${file}" NAME)
  get_filename_component(folder "${file}" DIRECTORY)
  get_filename_component(folder "${folder}" NAME)
  if(folder STREQUAL "include")
    set(name "include/${name}")
  endif()
  string(APPEND entries "{\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
if(entries)
  string(APPEND code "static const char* const files[][2] = {  // names and texts\n${entries}};\n"
    "static const bool added = [] {\n"
    "    for (const auto& file : files) mv::addBuiltShader(\"${GROUP}\", file[0], file[1]);\n"
    "    return true;\n}();\n")
endif()
if(STUDY AND EXISTS "${STUDY}")
  file(READ "${STUDY}" text)
  # Longer than the 65,536 characters that the standard wants of every compiler.
  string(PREPEND code "#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n")
  string(APPEND code "static const bool addedStudy = mv::addStudyFile(\"${NAME}\", R\"json(${text})json\");\n")
endif()
file(WRITE "${OUTPUT}" "${code}")
