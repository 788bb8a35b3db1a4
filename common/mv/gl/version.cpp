#include "mv/gl/version.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include "mv/error.h"

namespace mv {
namespace {

constexpr std::array known{46, 45, 44, 43, 42, 41, 40, 33};

}  // namespace

std::string versionText(int version) { return std::to_string(version / 10) + "." + std::to_string(version % 10); }

int newestVersion() {
    const char* ceiling = std::getenv("MVGL_GL");
    if (!ceiling) return known.front();
    for (const int version : known) {
        if (versionText(version) == ceiling) return version;
    }
    throw Error("MVGL_GL", "must be a core version of OpenGL: 3.3, or from 4.0 to 4.6", ceiling);
}

std::vector<int> versionsToAskFor(int least) {
    const int newest = newestVersion();
    if (std::getenv("MVGL_GL") && newest < least) {
        throw Error("MVGL_GL", "must be at least the version that is needed, " + versionText(least),
                    versionText(newest));
    }
    std::vector<int> versions;
    for (const int version : known) {
        if (version <= newest && version >= least) versions.push_back(version);
    }
    if (versions.empty()) versions.push_back(least);
    return versions;
}

}  // namespace mv
