// Files of pictures and models in a page: the browser has read them.
#include "pictures.h"

#include <filesystem>
#include <map>
#include <string>

#include "mv/error.h"
#include "mv/image/file.h"
#include "mv/image/load.h"

namespace mv {
namespace {

struct Given {
    Picture picture;
    std::string text;
    int version = 0;
};

std::map<std::string, Given>& files() {
    static std::map<std::string, Given> all;
    return all;
}
Given& received(const std::string& name) {
    Given& given = files()[name];
    const int version = given.version + 1;
    given = {.version = version};
    return given;
}
const Given& givenAs(const std::filesystem::path& path) {
    const auto found = files().find(path.string());
    if (found == files().end())
        throw Error(path.string(), "must be chosen in this page, which cannot open files by itself");
    return found->second;
}

}  // namespace

std::uint8_t* receivePicture(const std::string& name, int width, int height) {
    Given& given = received(name);
    given.picture = Picture(width, height);
    return given.picture.rgba.data();
}

char* receiveText(const std::string& name, std::size_t bytes) {
    Given& given = received(name);
    given.text.assign(bytes, ' ');
    return given.text.data();
}

// What the library asks of files.

std::string pictureStamp(const std::filesystem::path& path) {
    const auto found = files().find(path.string());
    return found == files().end() ? "" : std::to_string(found->second.version);
}

Picture loadPicture(const std::filesystem::path& path) {
    const Given& given = givenAs(path);
    if (given.picture.rgba.empty()) throw Error(path.string(), "must be a PNG or JPEG file");
    return given.picture;
}

const std::string& givenText(const std::filesystem::path& path) { return givenAs(path).text; }

}  // namespace mv
