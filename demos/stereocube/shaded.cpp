// A still life for two eyes: each sees shaded surfaces in their colours, and one picture is made of both.
#include <glm/matrix.hpp>

#include "mv/gl/functions.h"
#include "mv/math/transform.h"
#include "shared/scenes.h"
#include "stereocube.h"

namespace mv::stereocube {

// Draw a picture for each eye, then make one of both, since a channel may need the colours of both eyes.
void drawAnaglyph(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right, const Frame& frame) {
    const auto paper = float(s.background == Paper::white);
    glEnable(GL_DEPTH_TEST);
    glClearColor(paper, paper, paper, 1);
    for (const auto& [eye, target] : {std::pair(&left, &gpu.ofLeft), std::pair(&right, &gpu.ofRight)}) {
        const char* const name = eye == &left ? "left eye" : "right eye";
        if (!target->fit(frame.width(), frame.height(), {.depth = true, .texture = true}, name)) target->bind();
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        drawSurfaces(gpu, s, *eye, frame);
    }

    // Mix the two pictures by two matrices. With one eye closed, show what the other sees through its glass
    frame.bindTarget();
    glDisable(GL_DEPTH_TEST);
    const Mixing mixing = mixingOf(s.mix);
    gpu.mix->use();
    gpu.ofLeft.bindColor(0);
    gpu.ofRight.bindColor(1);
    gpu.mix->set("leftEye", 0);
    gpu.mix->set("rightEye", 1);
    gpu.mix->set("fromLeft", mixing.fromLeft);
    gpu.mix->set("fromRight", mixing.fromRight);
    gpu.mix->set("seenThrough", seenThrough(s.eyes));
    gpu.mix->set("brightness", brightnessThrough(s.eyes));
    gpu.cover->draw();
}

void drawSurfaces(Gpu& gpu, const Settings& s, const Eye& eye, const FrameInfo&) {
    const Scene scene = stillLifeOf(s);
    gpu.things.follow(scene);
    gpu.surface->use();
    gpu.surface->set("light", scene.lights[0].position);
    for (const auto& [object, mesh] : gpu.things.of(scene)) {
        gpu.surface->set("clipFromObject", eye.clipFromEye * eye.eyeFromWorld * object.worldFromObject);
        gpu.surface->set("worldFromObject", object.worldFromObject);
        gpu.surface->set("color", object.color);
        mesh.draw();
    }
}

// The still life that shadow demos show, with a red ball and a blue box, in the eyes' world: smaller, about the origin, and
// turned round, since the eyes look along +z.
Scene stillLifeOf(const Settings& s) {
    static const Scene still = [] {
        Scene scene = stillLife(1);
        for (SceneObject& object : scene.objects) {
            if (object.name == "sphere") object.color = {0.85, 0.12, 0.10};
            if (object.name == "box") object.color = {0.15, 0.30, 0.85};
        }
        return scene;
    }();
    Scene scene = still;
    const mat4 worldFromStill = worldFromModelOf(s) * rotateY(180) * scale(0.64) * translate(-0.2, -0.62, 0.4);
    for (SceneObject& object : scene.objects) object.worldFromObject = worldFromStill * object.worldFromObject;
    for (SceneLight& light : scene.lights) light.position = worldFromStill * light.position;
    return scene;
}

// What is asked for its parallax, in the world: the corners of a cube, and of the still life all points of what stands on
// the floor.
std::vector<vec3> pointsOf(const Settings& s) {
    std::vector<vec3> points;
    const auto add = [&](const MeshData& mesh, const mat4& worldFromObject) {
        for (const fvec3& at : mesh.positions) points.emplace_back(worldFromObject * vec4(vec3(at), 1));
    };
    if (!isShaded(s)) {
        add(wireOf(s), worldFromModelOf(s));
        return points;
    }
    for (const SceneObject& object : stillLifeOf(s).objects)
        if (object.casts) add(object.mesh, object.worldFromObject);
    return points;
}

}  // namespace mv::stereocube
