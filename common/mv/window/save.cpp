#include "mv/window/save.h"

#include "mv/error.h"

namespace mv {

std::filesystem::path freePicturePath(const std::string& name) {
    std::filesystem::path wanted(name);
    if (wanted.extension() != ".png") wanted += ".png";
    std::filesystem::path path = wanted;
    for (int number = 2; number < 10000; ++number) {
        std::error_code problem;
        const auto status = std::filesystem::symlink_status(path, problem);
        if (!std::filesystem::exists(status)) {
            path = std::filesystem::absolute(path, problem);
            if (!problem) return path;
            throw Error(wanted.string(),
                        "must be in a folder that is there; where the program was started is none now");
        }
        path = wanted.parent_path() / (wanted.stem().string() + "-" + std::to_string(number) + ".png");
    }
    throw Error(wanted.string(), "must have a free number up to 9999; choose another name");
}

}  // namespace mv
