#include "mv/demo/own_file.h"

#include <algorithm>
#include <mutex>

#include "mv/error.h"
#include "mv/image/file.h"
#include "mv/image/load.h"

namespace mv {
namespace {

// The reader of a kind of files.
template <class Content>
Content contentOf(const std::string& name);
template <>
Picture contentOf<Picture>(const std::string& name) {
    return loadPicture(name);
}
template <>
ObjMesh contentOf<ObjMesh>(const std::string& name) {
    return meshFromObj(readTextFile(name, maximumModelFileBytes), name);
}

template <class Content>
struct Read {
    std::string name, stamp;
    std::shared_ptr<const Content> content;
    int version;
};

template <class Content>
Read<Content> read(const OwnFile<Content>& file) {
    static std::mutex mutex;
    static std::vector<Read<Content>> reads;  // the last first
    static int versions = 0;
    if (!file.isSet()) throw Error("own file", "must be set before its content is asked for");
    const std::lock_guard lock(mutex);
    const std::string stamp = pictureStamp(file.name);
    const auto known = std::find_if(reads.begin(), reads.end(), [&](const Read<Content>& one) {
        return one.name == file.name && one.stamp == stamp && !stamp.empty();
    });
    if (known != reads.end()) {
        std::rotate(reads.begin(), known, known + 1);
    } else {
        Read<Content> made{file.name, stamp, std::make_shared<const Content>(contentOf<Content>(file.name)),
                           ++versions};
        if (reads.size() > 1) reads.pop_back();
        reads.insert(reads.begin(), std::move(made));
    }
    return reads.front();
}

template <class Content>
void check(const std::string& name) {
    (void)OwnFile<Content>{name}.version();
}

}  // namespace

template <class Content>
std::shared_ptr<const Content> OwnFile<Content>::content() const {
    return read(*this).content;
}

template <class Content>
int OwnFile<Content>::version() const {
    return isSet() ? read(*this).version : 0;
}

template <>
const FileKind& fileKind<Picture>() {
    static const FileKind kind{"none or a PNG or JPEG file", {".png", ".jpg", ".jpeg"}, check<Picture>};
    return kind;
}
template <>
const FileKind& fileKind<ObjMesh>() {
    static const FileKind kind{"none or an OBJ file", {".obj"}, check<ObjMesh>};
    return kind;
}
template struct OwnFile<Picture>;
template struct OwnFile<ObjMesh>;

}  // namespace mv
