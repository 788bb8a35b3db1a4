// Files that the user's own programs open.
#pragma once
#include <filesystem>

namespace mv {

// Opens the file by the program that the desktop has for its kind, which then lives on by itself. Error: there is no xdg-open,
// and so nobody to ask; the sentence names the file.
void openByDesktop(const std::filesystem::path& file);

}  // namespace mv
