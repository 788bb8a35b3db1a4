// The file a picture is saved to.
#pragma once
#include <filesystem>
#include <string>

namespace mv {

// The path for a picture of that name in the current folder (or the folder the name has), with ".png" added where it
// is missing. A file that is there is never replaced: "cube-cull-1.png" becomes "cube-cull-1-2.png", "-3" ...
std::filesystem::path freePicturePath(const std::string& name);

}  // namespace mv
