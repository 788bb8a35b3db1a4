# mvgl inside another project, which keeps its names, flags and build type; and what a user chooses is kept or refused. With WHOLE
# the other project's programs are built there and run, a demo too, which takes all of the library; without, one source of each side.
include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")
set(work "${BUILD}/subproject-test")
set(targets "${work}/consumer/maths.cpp^" "${SOURCE}/common/mv/math/clip.cpp^")  # to Ninja: what is made of them
if(WHOLE)
  set(targets maths triangle)
  string(APPEND work "-whole")
endif()
# The objects stay: compiling the library is most of the time.
file(REMOVE_RECURSE "${work}/consumer" "${work}/fetched" "${work}/chosen")
file(REMOVE "${work}/build/CMakeCache.txt")
file(GLOB sources "${CMAKE_CURRENT_LIST_DIR}/*")
file(COPY ${sources} DESTINATION "${work}/consumer")
set(parent "${work}/consumer/subproject")
set(configure ${CMAKE_COMMAND} -G Ninja "-DMVGL=${SOURCE}" -DMVGL_WINDOW=OFF)

# By add_subdirectory: the parent's build type and flags are as they would be without.
run(${configure} -S "${parent}" -B "${work}/build")
has_line("${work}/build/CMakeCache.txt" "CMAKE_BUILD_TYPE:STRING=")
has_line("${work}/build/CMakeCache.txt" "CMAKE_CXX_FLAGS_RELEASE:STRING=-O3 -DNDEBUG")
run(${CMAKE_COMMAND} --build "${work}/build" --target ${targets})
if(WHOLE)
  run("${work}/build/maths")
  if(NOT output STREQUAL "0.500 0.500 0.500\n")
    message(FATAL_ERROR "maths printed ${output}")
  endif()
  checks_triangle("${work}/build/triangle" "${work}/consumer")
endif()
# Neither demos nor anything to install, unless they are asked for.
run(${CMAKE_COMMAND} --build "${work}/build" --target help)
if(output MATCHES "mvgl-shadow-map:|cube-cull:")
  message(FATAL_ERROR "inside another project no demo is built unasked\n${output}")
endif()
run(${CMAKE_COMMAND} --install "${work}/build" --prefix "${work}/nothing")
if(EXISTS "${work}/nothing")
  message(FATAL_ERROR "inside another project nothing is installed unasked")
endif()

# By FetchContent, with the demos beside the parent's targets of their names.
run(${configure} -DFETCH=ON "-DFETCHCONTENT_SOURCE_DIR_MVGL=${SOURCE}" -DMVGL_DEMOS=ON -DMVGL_INSTALL=ON
  -S "${parent}" -B "${work}/fetched")
run(${CMAKE_COMMAND} --build "${work}/fetched" --target help)
if(NOT output MATCHES "mvgl-shadow:")
  message(FATAL_ERROR "the demos must be targets mvgl-NAME\n${output}")
endif()

# Alone, a user's own flags and newer standard stay.
set(configure ${CMAKE_COMMAND} -G Ninja -DMVGL_TESTS=OFF -DMVGL_WINDOW=OFF -S "${SOURCE}" -B "${work}/chosen")
run(${configure} "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -g1" -DCMAKE_CXX_STANDARD=23)
has_line("${work}/chosen/compile_commands.json" " *\"command\": .* -O1 -g1 .*-std=c\\+\\+2[3b] .*/mv-base[.]dir/.*")
# What changes the numbers, or is too old, is refused.
foreach(flag IN ITEMS -ffast-math -Ofast -funsafe-math-optimizations)
  refused("CMAKE_CXX_FLAGS: must not have a flag that changes what is computed; take it out, ${flag}"
    ${configure} "-DCMAKE_CXX_FLAGS=-g1 ${flag}")
endforeach()
refused("CMAKE_CXX_STANDARD: must be 20 or newer, 17" ${configure} -DCMAKE_CXX_FLAGS= -DCMAKE_CXX_STANDARD=17)
message("inside another project: built; flags kept or refused")
