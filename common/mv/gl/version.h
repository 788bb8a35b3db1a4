// Which core version of OpenGL is asked for: the newest first, by every host alike.
//
// A driver may give exactly what it is asked for (NVIDIA) or the newest it has (Mesa). So 3.3 is not asked for where more is to
// be had: a stage of 4.0 would be missing on a driver that has it. The demo's declaration (`needs`) says what it may
// call.
#pragma once
#include <string>
#include <vector>

namespace mv {

// "4.3" of 43.
std::string versionText(int version);

// The newest version that may be asked for and used, 10 * major + minor: 4.6, or what the environment variable MVGL_GL
// says ("3.3"), so that a newer driver can be met as if it were an older one.
// Error: MVGL_GL is no version of OpenGL from 3.3 to 4.6.
int newestVersion();

// The versions to ask for, one after the other until one is given: from newestVersion() down to `least`, which alone is asked for
// where it is newer than any known one. Error: as newestVersion(); MVGL_GL is below `least`.
std::vector<int> versionsToAskFor(int least);

}  // namespace mv
