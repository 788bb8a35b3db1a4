# Included by the tests of the package.

# run(<command>...): what it prints is in `output`; it must succeed.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed (${status}): ${ARGN}\n${out}")
  endif()
  set(output "${out}" PARENT_SCOPE)
endfunction()

# refused(<sentence> <command>...): it must fail with that sentence, a regular expression.
function(refused sentence)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  string(REGEX REPLACE "[ \n]+" " " out "${out}")
  if(status EQUAL 0 OR NOT out MATCHES "${sentence}")
    message(FATAL_ERROR "must be refused with '${sentence}' (${status}): ${ARGN}\n${out}")
  endif()
endfunction()

# has_line(<file> <line>): a regular expression for one whole line.
function(has_line file line)
  file(STRINGS "${file}" lines REGEX "^${line}$")
  if(NOT lines)
    message(FATAL_ERROR "${file}: must have a line '${line}'")
  endif()
endfunction()

# checks_triangle(<program> <folder>): the consumers' demo runs, and follows its shader where that is edited.
function(checks_triangle program source)
  run("${program}" --shot "${source}/a.png" --size 64x64 --report)
  if(NOT EXISTS "${source}/a.png" OR NOT output MATCHES "1 draws, 1 triangles")
    message(FATAL_ERROR "triangle printed ${output}")
  endif()
  file(WRITE "${source}/triangle.frag" "out vec4 fragColor;\nvoid main() { fragColor = vec4(0.0, 0.6, 1.0, 1.0); }\n")
  run("${program}" --shot "${source}/edited.png" --size 64x64)
  file(SHA256 "${source}/a.png" before)
  file(SHA256 "${source}/edited.png" after)
  if(before STREQUAL after)
    message(FATAL_ERROR "${program}: must read the shader where it was edited, ${source}/triangle.frag")
  endif()
endfunction()
