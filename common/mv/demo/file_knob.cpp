#include "mv/demo/file_knob.h"

#include <algorithm>

namespace mv {

void FileKnob::parse(std::string_view text) {
    const auto isControl = [](char c) { return (static_cast<unsigned char>(c) < 0x20) || c == 0x7F; };
    if (std::any_of(text.begin(), text.end(), isControl))
        throw Error("--" + name(), "must be a file without control characters in its name; rename it");
    if (text.empty()) throw refused(text);
    file_ = text;
}

void FileKnob::check() const {
    if (text() == none) return;
    try {
        kind_.check(file_);
    } catch (const Error& error) {
        throw Error("--" + name(), error.what());
    }
}

bool FileKnob::takes(std::string_view file) const {
    std::string small(file);
    for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return std::any_of(kind_.endings.begin(), kind_.endings.end(),
                       [&](std::string_view ending) { return small.ends_with(ending); });
}

std::string FileKnob::endings() const {
    std::string list;
    for (const Literal ending : kind_.endings) list += (list.empty() ? "" : ",") + std::string(ending);
    return list;
}

}  // namespace mv
