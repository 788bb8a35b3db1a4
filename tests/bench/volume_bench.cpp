// The cost of a shadow: none, by the matrix that flattens the caster onto the floor, and by a volume in the stencil buffer.
// One scene, a cube on a floor, at 640 x 480.
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/benches.h"
#include "mv/error.h"
#include "mv/gl/gl.h"
#include "mv/gl/scene_meshes.h"
#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"
#include "mv/run/render.h"
#include "shared/scenes.h"

namespace mv::bench {
namespace {

constexpr int width = 640, height = 480;
const vec4 floorPlane(0, 1, 0, 0);

// The scene of shadow-volume with the same shaders, without shadow or with the flattened cube.
class Planar {
  public:
    Planar()
        : program_("shadow-volume"),
          flatProgram_("shadow-volume", "volume"),
          scene_(cubeOnPlane(double(width) / height)) {
        meshes_.follow(scene_);
        scene_.clipFromView = infinitePerspective(40, double(width) / height, 0.1);
    }

    void draw(bool shadow) const {
        glDepthMask(GL_TRUE);
        glClearColor(0.70F, 0.77F, 0.85F, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        glDisable(GL_STENCIL_TEST);
        const vec4 light = scene_.lights[0].position;
        program_.use();
        program_.set("light", light);
        program_.set("lit", 1.0);
        for (const auto& [object, mesh] : meshes_.of(scene_)) {
            program_.set("clipFromObject", scene_.clipFromWorld() * object.worldFromObject);
            program_.set("worldFromObject", object.worldFromObject);
            program_.set("worldFromNormal", normalMatrix(object.worldFromObject));
            program_.set("color", object.color);
            mesh.draw();
        }
        if (!shadow) return;
        const auto [cube, cubeMesh] = meshes_.of(scene_)[cubeOnThePlane.index];
        flatProgram_.use();
        // A millimetre above the floor, in the colour that the floor has without the light
        const mat4 shadowFromWorld = translate(0, 1e-3, 0) * shadowProjection(light, floorPlane);
        flatProgram_.set("clipFromObject", scene_.clipFromWorld() * shadowFromWorld * cube.worldFromObject);
        flatProgram_.set("color", vec4(0.3 * scene_.objects[0].color, 1));
        cubeMesh.draw();
    }

  private:
    Program program_, flatProgram_;
    Scene scene_;
    SceneMeshes meshes_;
};

long darkPixels(const Picture& picture) {
    long dark = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) dark += picture.at(x, y).green < 70 ? 1 : 0;
    }
    return dark;
}

}  // namespace

std::vector<Row> volumeBench(int rounds) {
    HeadlessStage headless;
    Stage& stage = headless.stage;
    stage.open(findDemo("shadow-volume"), width, height);
    stage.demo().knob("scene").parse("cube");
    stage.demo().knob("show").parse("shadow");
    constexpr int repeats = 4;
    const auto several = [&](const auto& frame) {
        return [&frame] {
            for (int i = 0; i < repeats; ++i) {
                frame();
                glFinish();
            }
        };
    };
    std::vector<Row> rows{{"volumes: z-fail in the stencil buffer / planar shadow", {}, 2.2},
                          {"volumes: planar shadow / no shadow", {}, 1.15}};
    {
        const Planar planar;
        const auto byVolume = [&] { stage.draw(1); };
        const auto byMatrix = [&] { planar.draw(true); };
        const auto without = [&] { planar.draw(false); };
        byVolume();
        const long darkByVolume = darkPixels(stage.picture());
        stage.front().bind();
        byMatrix();
        const long darkByMatrix = darkPixels(stage.picture());
        if (darkByVolume == 0 || std::abs(darkByVolume - darkByMatrix) > darkByVolume / 50) {
            throw Error("bench", "must make the same shadow by volume and by matrix, but for 2 % of its pixels",
                        std::to_string(darkByVolume) + " and " + std::to_string(darkByMatrix));
        }
        rows[0].ratio = interleaved(several(byVolume), several(byMatrix), rounds);
        rows[1].ratio = interleaved(several(byMatrix), several(without), rounds);
    }
    stage.close();
    return rows;
}

}  // namespace mv::bench
