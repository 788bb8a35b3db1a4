// For tests of what the system refuses, run in a child process (EXPECT_EXIT).
#pragma once
#include <grp.h>
#include <unistd.h>

namespace mv {

// Gives up the superuser's rights for good, or ends the process with status 3. Two reasons:
// - The superuser is refused nothing, so that a test of permissions would test nothing.
// - Tests write to real devices such as /dev/full. Code that wrongly renamed a file over one would, as superuser,
//   take the device from the whole machine; so no test may touch a device before it has called this.
inline void becomeNobody() {
    constexpr uid_t nobody = 65534;
    if (geteuid() != 0) return;
    if (setgroups(0, nullptr) != 0 || setresgid(nobody, nobody, nobody) != 0 || setresuid(nobody, nobody, nobody) != 0)
        _exit(3);
    if (geteuid() == 0) _exit(3);
}

}  // namespace mv
