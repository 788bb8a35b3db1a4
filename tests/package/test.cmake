# Installs mvgl into an empty folder, moves it, and builds and runs a consumer outside the tree against it.
set(work "${BUILD}/package-test")
file(REMOVE_RECURSE "${work}")
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed (${status}): ${ARGN}\n${out}")
  endif()
  set(output "${out}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install "${BUILD}" --prefix "${work}/first")
# Nothing in the package may know where it was installed.
file(RENAME "${work}/first" "${work}/installed")
file(GLOB sources "${CONSUMER}/*")
file(COPY ${sources} DESTINATION "${work}/consumer")
run(${CMAKE_COMMAND} -G Ninja -S "${work}/consumer" -B "${work}/build" "-DCMAKE_PREFIX_PATH=${work}/installed" -DCMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build "${work}/build")

run("${work}/build/maths")
if(NOT output STREQUAL "0.500 0.500 0.500\n")  # tan 45 deg = 1, depth 2 between 1 and 3: (4 - 6/2)/2
  message(FATAL_ERROR "maths printed ${output}")
endif()
run("${work}/build/triangle" --shot "${work}/a.png" --size 64x64 --report)
if(NOT EXISTS "${work}/a.png" OR NOT output MATCHES "1 draws, 1 triangles")
  message(FATAL_ERROR "triangle printed ${output}")
endif()
# The installed programs run from where they were moved to.
run("${work}/installed/bin/cube-cull" --shot "${work}/b.png")
file(GLOB_RECURSE window "${work}/installed/*/mvgl-window.so")
message("installed, moved, consumer built and run; window module: ${window}")
