#include "mv/error.h"
#include "mv/gl/version.h"
#include "mv/host/context.h"
#include "mv/host/library.h"
#include "mv/host/trial.h"

namespace mv {

std::unique_ptr<Context> openHeadless(HostKind kind, ContextRequest request, std::vector<std::string>& notes) {
    // No host's fault, so it is said once and by itself.
    if (!request.es) (void)versionsToAskFor(request.version);
    const auto osmesa = [&] { return openTried("OSMesa", [&] { return openOsmesa(request); }); };
    const auto egl = [&](bool surfaceless) {
        // A child's notes are its own.
        return openTried("EGL", [&] { return openEgl(request, surfaceless, notes); });
    };
    if (kind == HostKind::osmesa) return osmesa();
    if (kind == HostKind::eglDevice) return egl(false);
    if (kind == HostKind::egl || request.es) return egl(true);
    std::string reason;
    std::optional<ScarceError> scarce;
    try {
        return osmesa();
    } catch (const ScarceError& error) {
        scarce = error;
        reason = error.what();
    } catch (const Error& error) {
        reason = error.what();
    }
    try {
        auto context = egl(true);
        notes.push_back("using " + context->name() + ", since " + reason);
        return context;
    } catch (const ScarceError&) {
        throw;
    } catch (const Error& error) {
        if (scarce) throw *scarce;
        throw Error("headless", "must have OSMesa or EGL (packages libosmesa6, libegl1 and libgl1-mesa-dri)",
                    reason + "; " + error.what());
    }
}

}  // namespace mv
