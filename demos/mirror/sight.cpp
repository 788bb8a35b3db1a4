// The room of mirror, the mirrors that are in view, and the objects that no mirror shows.
#include <algorithm>

#include "mirror.h"
#include "mv/demo/seen.h"
#include "mv/geometry/bounds.h"

namespace mv::mirror {

MirrorRoom roomOf(const Settings& s) {
    return {s.turn, s.count == Count::two, s.eye, {s.ball.x, MirrorRoom::ballRadius, s.ball.y}};
}
Scene sceneOf(const Settings& s, const FrameInfo& frame) { return roomOf(s).scene(frame.aspect()); }

static std::vector<std::array<vec4, 8>> boxesOf(const Scene& scene) {
    std::vector<std::array<vec4, 8>> boxes;
    for (const SceneObject& object : scene.objects) {
        const auto box = boundsOf(object.mesh, object.worldFromObject).corners();
        std::array<vec4, 8>& corners = boxes.emplace_back();
        std::transform(box.begin(), box.end(), corners.begin(), [](const vec3& p) { return vec4(p, 1); });
    }
    return boxes;
}

Sight sightOf(const Settings& s, const Frame& frame) {
    Scene scene = seen(sceneOf(s, frame), frame);
    const std::vector<Mirror> mirrors = roomOf(s).mirrors();
    // The last mirror of a chain shows nothing
    auto chains = mirrorChains(mirrors, scene.clipFromWorld(), s.bounces + 1);
    auto boxes = boxesOf(scene);
    return {std::move(scene), mirrors, std::move(chains), std::move(boxes)};
}

// Whether the object is certainly out of view.
static bool isBeyond(const Settings& s, const Sight& sight, std::size_t object, const View& view) {
    const std::array<vec4, 8>& box = sight.boxes[object];
    std::array<vec4, 8> clip{};
    std::transform(box.begin(), box.end(), clip.begin(),
                   [&](const vec4& corner) { return view.clipFromWorld * corner; });
    return areBeyond(clip, view.edges) ||
           (view.bounce > 0 && s.near != Near::none && areBeyond(box, {&view.before, 1}));
}

// The indices of the objects to draw. A mirror hides its own frame, which is right behind it.
std::vector<std::size_t> shownIn(Gpu& gpu, const Settings& s, const Sight& sight, const View& view) {
    const bool isMirrored = view.bounce > 0;
    std::vector<std::size_t> shown;
    int leftOut = 0;
    for (std::size_t i = 0; i < sight.scene.objects.size(); ++i) {
        if (isMirrored && i == view.frame.index) continue;
        const bool isLeftOut = (s.leaveOut || !isMirrored) && isBeyond(s, sight, i, view);
        leftOut += isLeftOut;
        if (!isLeftOut) shown.push_back(i);
    }
    if (isMirrored) {
        ++gpu.work.passes;
        gpu.work.drawn += static_cast<int>(shown.size());
        gpu.work.leftOut += leftOut;
    }
    return shown;
}

}  // namespace mv::mirror
