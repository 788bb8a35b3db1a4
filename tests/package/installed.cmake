# Installs mvgl into an empty folder, moves it, and builds and runs a consumer outside the tree against it.
include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/runpath.cmake")
set(work "${BUILD}/package-test")
file(REMOVE_RECURSE "${work}")

run(${CMAKE_COMMAND} --install "${BUILD}" --prefix "${work}/first")
# Nothing in the package may know where it was installed, nor where it was built, nor of what.
file(RENAME "${work}/first" "${work}/installed")
foreach(path IN ITEMS "${BUILD}" "${SOURCE}")
  execute_process(COMMAND grep -rlF "${path}/" "${work}/installed" OUTPUT_VARIABLE files RESULT_VARIABLE status)
  if(NOT status EQUAL 1)
    message(FATAL_ERROR "what is installed must not name ${path}/, in\n${files}")
  endif()
endforeach()
checks_runpaths(3 "${work}/installed")
# A header that is installed finds those that it includes, whether the consumer below asks for it or not.
file(GLOB_RECURSE headers "${work}/installed/include/mv/*")
foreach(header IN LISTS headers)
  file(STRINGS "${header}" lines REGEX "^#include \"mv/")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^#include \"([^\"]*)\".*" "\\1" included "${line}")
    if(NOT EXISTS "${work}/installed/include/${included}")
      message(FATAL_ERROR "${header}: must find ${included}; common/CMakeLists.txt lists what is installed")
    endif()
  endforeach()
endforeach()
# What shows and measures demos is no user's to include: of run/ what the main function needs, of hosts and windows nothing.
file(GLOB_RECURSE inner RELATIVE "${work}/installed/include/mv" "${work}/installed/include/mv/run/*" "${work}/installed/include/mv/host/*"
  "${work}/installed/include/mv/show/*"
  "${work}/installed/include/mv/paper/*" "${work}/installed/include/mv/study/*" "${work}/installed/include/mv/window/*" "${work}/installed/include/mv/gl/layer.h")
if(NOT inner STREQUAL "run/run.h")
  message(FATAL_ERROR "installed headers of run/, show/, paper/, study/, host/, window/: must be run/run.h alone, ${inner}")
endif()
file(GLOB sources "${CMAKE_CURRENT_LIST_DIR}/*")
file(COPY ${sources} DESTINATION "${work}/consumer")
run(${CMAKE_COMMAND} -G Ninja -S "${work}/consumer" -B "${work}/build" "-DCMAKE_PREFIX_PATH=${work}/installed" -DCMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build "${work}/build")

run("${work}/build/maths")
if(NOT output STREQUAL "0.500 0.500 0.500\n")  # tan 45 deg = 1, depth 2 between 1 and 3: (4 - 6/2)/2
  message(FATAL_ERROR "maths printed ${output}")
endif()
checks_triangle("${work}/build/triangle" "${work}/consumer")
# The installed programs run from where they were moved to.
run("${work}/installed/bin/cube-cull" --shot "${work}/b.png")
file(GLOB_RECURSE window "${work}/installed/*/mvgl-window.so")
message("installed, moved, consumer built and run; window module: ${window}")
