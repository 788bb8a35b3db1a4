# cmake --install: programs, library, window module, headers and the package that find_package(mvgl) finds.
include(CMakePackageConfigHelpers)
set(packageDir "${CMAKE_INSTALL_LIBDIR}/cmake/mvgl")
set(MVGL_DATA_DIR "${CMAKE_INSTALL_DATADIR}/mvgl")

install(TARGETS mv mvgl-demo EXPORT mvglTargets FILE_SET HEADERS)
install(EXPORT mvglTargets NAMESPACE mvgl:: DESTINATION "${packageDir}")
install(TARGETS mvgl ${MVGL_DEMOS})
if(TARGET mvgl-window)
  # Beside the library, which looks for it there.
  install(TARGETS mvgl-window LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
endif()
install(FILES common/mv/run/main.cpp DESTINATION "${MVGL_DATA_DIR}")
configure_package_config_file(cmake/mvglConfig.cmake.in "${CMAKE_CURRENT_BINARY_DIR}/mvglConfig.cmake"
  INSTALL_DESTINATION "${packageDir}" PATH_VARS MVGL_DATA_DIR)
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/mvglConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/mvglConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/mvglConfigVersion.cmake"
  cmake/MvglDemo.cmake cmake/EmbedShaders.cmake DESTINATION "${packageDir}")
