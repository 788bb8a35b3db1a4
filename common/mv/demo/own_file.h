// A file of the user's own, as a setting of a lesson: by its flag, dropped onto the window, chosen in the page.
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "mv/demo/literal.h"
#include "mv/geometry/obj.h"
#include "mv/image/picture.h"

namespace mv {

// "none" at first. The setting is the file's name alone: what is in the file is read when it is asked for. A lesson asks
// before it draws, and tells a file that is missing, or of another kind, by its flag (the row `file` in mv/demo/row.h).
//     OwnFile<Picture> picture = {};
//     if (gpu.imageFor.changed(s.picture.version())) gpu.image = Texture(*s.picture.content());
template <class Inside>
struct OwnFile {
    using Content = Inside;
    std::string name = "none";

    bool isSet() const { return name != "none"; }
    // The contents of the file as it is now; the last two that were read are kept, since a window draws two settings
    // that are compared in turn. Error: none is set; as loadPicture, or as meshFromObj.
    std::shared_ptr<const Content> content() const;
    // Another number for each content that was read; 0 where none is set. Error: as content().
    int version() const;
};

// A knob's words about the files that it takes.
struct FileKind {
    Literal range;                           // for people: "none or a PNG or JPEG file"
    std::vector<Literal> endings;            // of their names, in small letters: ".png"
    void (*check)(const std::string& name);  // Error: it cannot be read
};

// The kind of files that have such content: PNG and JPEG files are pictures, OBJ files are meshes. Another one is an entry of
// own_file.cpp.
template <class Content>
const FileKind& fileKind();

template <>
const FileKind& fileKind<Picture>();
template <>
const FileKind& fileKind<ObjMesh>();
extern template struct OwnFile<Picture>;
extern template struct OwnFile<ObjMesh>;

// An OBJ file holds at most so many bytes: a mesh takes a few times as many.
inline constexpr std::size_t maximumModelFileBytes = std::size_t{32} << 20U;

}  // namespace mv
