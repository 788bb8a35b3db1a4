// Picture files in a page: the browser has read them.
#include "pictures.h"

#include <filesystem>
#include <map>
#include <string>

#include "mv/error.h"
#include "mv/image/load.h"

namespace mv {
namespace {

struct Given {
    Picture picture;
    int version = 0;
};

std::map<std::string, Given>& pictures() {
    static std::map<std::string, Given> all;
    return all;
}

}  // namespace

std::uint8_t* receivePicture(const std::string& name, int width, int height) {
    Given& given = pictures()[name];
    given.picture = Picture(width, height);
    ++given.version;
    return given.picture.rgba.data();
}

// What the library asks of files.

std::string pictureStamp(const std::filesystem::path& path) {
    const auto found = pictures().find(path.string());
    return found == pictures().end() ? "" : std::to_string(found->second.version);
}

Picture loadPicture(const std::filesystem::path& path) {
    const auto found = pictures().find(path.string());
    if (found == pictures().end())
        throw Error(path.string(), "must be chosen in this page, which cannot open files by itself");
    return found->second.picture;
}

}  // namespace mv
