#include "mv/error.h"
#include "mv/host/context.h"

namespace mv {

std::unique_ptr<Context> openHeadless(HostKind kind, ContextRequest request, std::vector<std::string>& notes) {
    if (kind == HostKind::osmesa) return openOsmesa(request);
    if (kind == HostKind::egl || request.es) return openEgl(request, notes);
    std::string reason;
    try {
        return openOsmesa(request);
    } catch (const Error& error) {
        reason = error.what();
    }
    try {
        auto context = openEgl(request, notes);
        notes.push_back("using " + context->name() + ", since " + reason);
        return context;
    } catch (const Error& error) {
        throw Error("headless", "must have OSMesa or EGL (packages libosmesa6, libegl1 and libgl1-mesa-dri)",
                    reason + "; " + error.what());
    }
}

}  // namespace mv
