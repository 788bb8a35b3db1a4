#include "mv/demo/file_knob.h"

#include <algorithm>
#include <atomic>

#include "mv/image/load.h"

namespace mv {

PictureFile::PictureFile(Demo* owner, Literal name, Literal sample, Literal help)
    : Knob(owner, name, help, ""), sample_(sample) {}

void PictureFile::parse(std::string_view text) {
    const auto isControl = [](char c) { return (static_cast<unsigned char>(c) < 0x20) || c == 0x7F; };
    if (std::any_of(text.begin(), text.end(), isControl))
        throw Error("--" + name(), "must be a file without control characters in its name; rename it");
    if (text.empty()) throw refused(text);
    file_ = text;
}

const PictureFile::Read& PictureFile::read() const {
    if (!isSet()) throw Error("--" + name(), "must be set before its picture is asked for");
    try {
        const std::string stamp = pictureStamp(file_);
        const auto known = std::find_if(reads_.begin(), reads_.end(), [&](const Read& one) {
            return one.file == file_ && one.stamp == stamp && !stamp.empty();
        });
        if (known != reads_.end()) {
            std::rotate(reads_.begin(), known, known + 1);
            return reads_.front();
        }
        static std::atomic<int> versions = 0;
        Read made{file_, stamp, std::make_shared<const Picture>(loadPicture(file_)), ++versions};
        if (reads_.size() > 1) reads_.pop_back();
        return *reads_.insert(reads_.begin(), std::move(made));
    } catch (const Error& error) {
        throw Error("--" + name(), error.what());
    }
}

const Picture& PictureFile::picture() const { return *read().picture; }

int PictureFile::version() const { return isSet() ? read().version : 0; }

void PictureFile::check() const {
    if (isSet()) read();
}

}  // namespace mv
