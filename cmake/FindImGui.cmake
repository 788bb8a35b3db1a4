# Dear ImGui with its GLFW and OpenGL 3 backends, as Debian's libimgui-dev has it (which brings no CMake files).
# Target: ImGui::ImGui
find_path(ImGui_INCLUDE_DIR imgui.h PATH_SUFFIXES imgui)
find_library(ImGui_LIBRARY imgui)
# Debian's ImGui takes its fonts and packing from the stb library instead of its own copies; static like itself.
find_library(ImGui_STB_LIBRARY NAMES libstb.a stb)
include(FindPackageHandleStandardArgs)
if(ImGui_INCLUDE_DIR)
  file(STRINGS "${ImGui_INCLUDE_DIR}/imgui.h" version_line REGEX "#define IMGUI_VERSION ")
  string(REGEX MATCH "[0-9]+\\.[0-9.]+" ImGui_VERSION "${version_line}")
endif()
find_package_handle_standard_args(ImGui REQUIRED_VARS ImGui_LIBRARY ImGui_INCLUDE_DIR VERSION_VAR ImGui_VERSION)
if(ImGui_FOUND AND NOT TARGET ImGui::ImGui)
  add_library(ImGui::ImGui UNKNOWN IMPORTED)
  set_target_properties(ImGui::ImGui PROPERTIES IMPORTED_LOCATION "${ImGui_LIBRARY}"
    INTERFACE_LINK_LIBRARIES "$<$<BOOL:${ImGui_STB_LIBRARY}>:${ImGui_STB_LIBRARY}>"
    INTERFACE_INCLUDE_DIRECTORIES "${ImGui_INCLUDE_DIR};${ImGui_INCLUDE_DIR}/backends")
endif()
mark_as_advanced(ImGui_INCLUDE_DIR ImGui_LIBRARY ImGui_STB_LIBRARY)
