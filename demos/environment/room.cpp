// The surroundings of the body in environment: a room, drawn into the faces of a cube map and into the picture, or a sky.
#include <glm/matrix.hpp>
#include <utility>

#include "environment.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv::environment {
namespace {

constexpr int walls = -1;  // takes the place of a ball's number

void useRoom(Gpu& gpu, const Room& room) {
    glEnable(GL_CULL_FACE);
    gpu.roomProgram->use();
    gpu.roomProgram->set("room", room.size);
    gpu.roomProgram->set("ballColor", Room::ballColors());
}

void drawObject(Gpu& gpu, int number, const mat4& clipFromWorld, const mat4& worldFromObject) {
    gpu.roomProgram->set("clipFromObject", clipFromWorld * worldFromObject);
    gpu.roomProgram->set("worldFromObject", worldFromObject);
    gpu.roomProgram->set("ball", number);
    (number == walls ? *gpu.box : *gpu.ballMesh).draw();
}

// Draw the walls that face the eye, and the visible balls: an eye outside does not see the balls behind the sphere.
void drawRoom(Gpu& gpu, const mat4& clipFromWorld, const Room& room, const std::optional<vec3>& eye = {}) {
    // Three mirrors turn the box inside out, so that its front faces are inside.
    drawObject(gpu, walls, clipFromWorld, scale(-room.halfSize()));
    const auto places = room.ballPlaces();
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!room.isBallInView(i, clipFromWorld) || (eye && room.isBallHidden(i, *eye))) continue;
        drawObject(gpu, static_cast<int>(i), clipFromWorld, translate(places.at(i)) * scale(room.ballRadius()));
    }
}

}  // namespace

// Draw the faces that have changed: all faces of another room, else those that the ball is in or was in. Returns their number.
int drawFaces(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Room room = roomOf(s, frame);
    const Room before{room.size, std::exchange(gpu.drawnRound, room.round)};
    const bool isNew = gpu.roomFor.changed(s.cubeSize, room.size);
    if (gpu.roomMap.size() != s.cubeSize) gpu.roomMap = CubeMap(s.cubeSize, "room");
    useRoom(gpu, room);
    glViewport(0, 0, s.cubeSize, s.cubeSize);
    int drawn = 0;
    for (int face = 0; face < cubeFaces; ++face) {
        const mat4 clipFromWorld = perspective(90, 1, 0.1 * room.size, 2 * room.size) * cubeFaceView(face);
        const bool isSeen = room.isBallInView(0, clipFromWorld) || before.isBallInView(0, clipFromWorld);
        if (!isNew && s.keep && (room.round == before.round || !isSeen)) continue;
        ++drawn;
        gpu.roomMap.bindForDrawing(face);
        glClear(GL_DEPTH_BUFFER_BIT);  // the walls cover every pixel, so the old colours need no clearing
        drawRoom(gpu, clipFromWorld, room);
    }
    glDisable(GL_CULL_FACE);
    frame.bindTarget();
    frame.count("faces of the cube drawn", drawn);
    return drawn;
}

void drawAround(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame) {
    if (!inRoom(s)) return drawSky(gpu, scene);
    const Room room = roomOf(s, frame);
    useRoom(gpu, room);
    drawRoom(gpu, scene.clipFromWorld(), room, isSphere(s) ? std::optional(eyeOf(scene)) : std::nullopt);
}

// Draw the sky by the view without its translation: infinity looks the same from every place.
void drawSky(Gpu& gpu, const Scene& scene) {
    mat4 turn = scene.viewFromWorld;
    turn[3] = vec4(0, 0, 0, 1);
    glDepthFunc(GL_LEQUAL);
    gpu.skyProgram->use();
    gpu.skyProgram->set("worldFromClip", glm::inverse(scene.clipFromView * turn));
    gpu.pane->draw();
}

void setRoom(const Program& program, const Room& room) {
    program.set("room", room.size);
    program.set("ballAt", room.ballPlaces());
    program.set("ballColor", Room::ballColors());
}
Room roomOf(const Settings& s, const FrameInfo& frame) { return {s.roomSize, s.ball + (s.moving ? frame.index() : 0)}; }

}  // namespace mv::environment
