# cmake --install: programs, library, window module, headers and the package that find_package(mvgl) finds.
include(CMakePackageConfigHelpers)
set(packageDir "${CMAKE_INSTALL_LIBDIR}/cmake/mvgl")

install(TARGETS mv mv-base mv-geometry mv-motion mvgl-demo mvgl-demo-and-mv EXPORT mvglTargets FILE_SET HEADERS)
install(EXPORT mvglTargets NAMESPACE mvgl:: DESTINATION "${packageDir}")
if(MVGL_DEMOS)
  install(TARGETS mvgl ${MVGL_DEMO_TARGETS})
endif()
if(TARGET mvgl-window)
  # Beside the library, which looks for it there.
  install(TARGETS mvgl-window LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
endif()
configure_package_config_file(cmake/mvglConfig.cmake.in "${CMAKE_CURRENT_BINARY_DIR}/mvglConfig.cmake"
  INSTALL_DESTINATION "${packageDir}")
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/mvglConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/mvglConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/mvglConfigVersion.cmake"
  cmake/MvglDemo.cmake cmake/EmbedShaders.cmake common/mv/run/main.cpp DESTINATION "${packageDir}")
