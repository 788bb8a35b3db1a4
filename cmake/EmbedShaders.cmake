# Run as a script: writes OUTPUT, a C++ file that adds each of FILES to the embedded shaders. It includes nothing: there is one for
# each demo, and headers would take longer than all the rest of it.
# STUDIES are the committed studies of the demo NAME, a machine each; none where they are empty.
# The name of a file is its path from the folder ROOT: "include/light.glsl", "cube-cull/cube-cull.vert". GROUP names the file that
# says where they are edited.
# With BARE they are without comments and indents, each line at its number.
set(code "// Generated from shader files; do not edit.\nnamespace mv {\nbool addBuiltShader(const char* group, const char* name, const char* text);\nbool addStudyFile(const char* demo, const char* text);\n}\n\n")
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
    "    for (const auto& file : files) mv::addBuiltShader(\"${GROUP}\", file[0], file[1]);\n"
    "    return true;\n}();\n")
endif()
set(number 0)
foreach(study IN LISTS STUDIES)
  file(READ "${study}" text)
  if(number EQUAL 0)
    # Longer than the 65,536 characters that the standard wants of every compiler.
    string(PREPEND code "#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n")
  endif()
  string(APPEND code "static const bool addedStudy${number} = mv::addStudyFile(\"${NAME}\", R\"csv(${text})csv\");\n")
  math(EXPR number "${number} + 1")
endforeach()
file(WRITE "${OUTPUT}" "${code}")
