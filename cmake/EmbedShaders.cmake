# Run as a script: writes OUTPUT, a C++ file that adds each of FILES to the embedded shaders.
# STUDY, where it exists, is the committed study of the demo NAME.
# The name of a file is its path from the folder ROOT: "include/light.glsl", "cube-cull/cube-cull.vert". GROUP names the file that says where they are edited.
# With BARE they are without comments and indents, each line at its number.
set(code "// Generated from shader files; do not edit.\n#include \"mv/gl/shader_folder.h\"\n\n")
set(entries "")
foreach(file IN LISTS FILES)
  file(READ "${file}" text)
  if(BARE)
    string(REGEX REPLACE "[ \t]*//[^\n]*" "" text "${text}")
    string(REGEX REPLACE "\n[ \t]+" "\n" text "${text}")
  endif()
  file(RELATIVE_PATH name "${ROOT}" "${file}")
  string(APPEND entries "{\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
if(entries)
  string(APPEND code "static const char* const files[][2] = {  // names and texts\n${entries}};\n"
    "static const bool added = [] {\n"
    "    for (const auto& [name, text] : files) mv::addBuiltShader(\"${GROUP}\", name, text);\n"
    "    return true;\n}();\n")
endif()
if(STUDY AND EXISTS "${STUDY}")
  file(READ "${STUDY}" text)
  # Longer than the 65,536 characters that the standard wants of every compiler.
  string(PREPEND code "#include \"mv/run/study_data.h\"\n#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n")
  string(APPEND code "static const bool addedStudy = mv::addStudyFile(\"${NAME}\", R\"json(${text})json\");\n")
endif()
file(WRITE "${OUTPUT}" "${code}")
