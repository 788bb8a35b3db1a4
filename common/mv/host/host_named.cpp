#include "mv/host/context.h"

namespace mv {

std::optional<HostKind> hostNamed(std::string_view name) {
    if (name == "osmesa") return HostKind::osmesa;
    if (name == "egl") return HostKind::egl;
    if (name == "egl-device") return HostKind::eglDevice;
    return {};
}

}  // namespace mv
