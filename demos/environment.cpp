// environment: bodies that mirror and refract what is around them, looked up in a cube map as if it were infinitely far.
//
// Claims (each is a test in tests/claims/environment.cpp; X57 and X58 in docs/stability.md are its extremes):
// - [rays-are-right] By rays each pixel of the sphere is what double precision finds, for each material.
// - [off-by-distance] Looked up by direction alone, of the error a room of twice the size leaves half, up to 0.71 of it.
// - [walls-corrected] Looked up where the ray meets the room's walls, the mirrored walls are right; balls before them are not.
// - [no-seams] Nothing jumps where a reflection crosses the cube's edges, which are seen where each face ends by itself.
// - [kept] While nothing moves no face is drawn; where the ball moves only those are in which it is or was.
// - [total-reflection] In a bubble, beyond the limiting angle, everything is mirrored, and nothing shines through.
// - [no-surface] Glass with the index of what is around it is not to be seen.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/file_knob.h"
#include "mv/demo/made_for.h"
#include "mv/geometry/shapes.h"
#include "mv/geometry/teapot.h"
#include "mv/gl/cube_map.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/math/color.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/fresnel.h"
#include "shared/own_picture.h"
#include "shared/reflectance_plot.h"
#include "shared/surroundings.h"
#include "shared/turntable.h"

using namespace mv;

namespace {

enum class Around { room, sky };
enum class Body { sphere, teapot };
enum class Material { mirror, gold, copper, glass };
enum class Curve { exact, schlick };
enum class Through { first, both, inside };
enum class Lookup { direction, walls, rays };

const vec4 ink(0.1, 0.1, 0.1, 1);
constexpr int walls = -1;  // in the place of a ball's number

struct Environment final : Demo {
    Choice<Around> around{
        this, "around", Around::room, {{"room", "drawn into the cube"}, {"sky", "infinitely far"}}, "what is mirrored"};
    Choice<Body> body{this, "body", Body::sphere, {{"sphere"}, {"teapot"}}, "what mirrors it"};
    Choice<Material> material{this,
                              "material",
                              Material::mirror,
                              {{"mirror", "all of the light"}, {"gold"}, {"copper"}, {"glass", "refracts, too"}},
                              "how much it reflects of which colour"};
    Real index{this, "index", 1.5, {0.4, 3}, "of the glass over that of what is around it; below 1 it is a bubble"};
    Choice<Curve> curve{this,
                        "fresnel",
                        Curve::exact,
                        {{"exact", "Fresnel's equations"}, {"schlick", "a fifth power in their place"}},
                        "the part that is reflected, by the angle"};
    Choice<Through> through{this,
                            "refract",
                            Through::both,
                            {{"first", "where light enters the glass"},
                             {"both", "where it leaves it, too"},
                             {"inside", "and where it is reflected inside, up to four times"}},
                            "at which surfaces of the glass sphere"};
    Choice<Lookup> lookup{this,
                          "lookup",
                          Lookup::direction,
                          {{"direction", "as if all were infinitely far"},
                           {"walls", "the direction, from the cube's middle, to where the ray meets the room's walls"},
                           {"rays", "no cube: each ray finds what it meets"}},
                          "how the mirrored light is found"};
    Toggle split{this, "split", true, "the right half as exact as rays make it"};
    Real roomSize{this, "room", 3, {2, 100, Scale::logarithmic}, "half of the room's width, in radii of the sphere"};
    NumberChoice size{this, "cube-size", 256, {4, 16, 64, 256}, "texels along a side of each face"};
    Toggle seamless{this, "seamless", true, "filter across the edges of the cube"};
    Angle ball{this, "ball", -7, "where the red ball is on its way round"};
    Toggle moving{this, "moving", true, "the red ball goes round, a degree a frame"};
    Toggle keep{this, "keep", true, "keep the faces in which nothing moves"};
    PictureFile picture{
        this, "picture", "assets/evening.png",
        "your own around the body: a panorama, twice as wide as high, or a cube cut open into 4 x 3 squares"};
    Turntable turntable{this, {-3, 20}};

    Readout facesDrawn{this, "faces-drawn", "faces of the cube that were drawn for this picture"};
    Readout headOn{this, "head-on", "part of the light that is reflected head on, as luminance"};
    Readout limit{this, "limit", "angle from which on the bubble reflects all", "deg"};

    Program program;
    OnDemand<Program> roomProgram{"environment", "room"}, skyProgram{"environment", "sky"},
        crossProgram{"environment", "cross"};
    OnDemand<Mesh> round{withoutTexCoords(sphere(1, 128, 64)), "sphere"},
        teapotMesh{withoutTexCoords(tessellated(teapot(), 12)), "teapot"},
        box{withoutTexCoords(mv::box(vec3(-1), vec3(1))), "walls"},
        ballMesh{withoutTexCoords(sphere(1, 48, 24)), "ball"},
        pane{MeshData{.primitive = Primitive::triangleStrip,
                      .positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}}},
             "pane"};
    CubeMap skyMap, roomMap;
    OnDemand<CubeMap> noCube{skyCube(1), "no cube"};  // its sampler must have one, though rays ask none
    MadeFor<int, int> skyFor;
    MadeFor<int, double> roomFor;
    double drawnRound = 0;  // where the ball is in the cube
    int objectSet = -2;
    Drawing drawing;

    Environment() {
        bindKeys(Key::left, Key::right, ball, 5);
        bindKeys(Key::down, Key::up, roomSize, 0.1);
        bindHandle("ball", {&ball}, [this](const FrameInfo& frame) -> std::optional<vec2> {
            if (!inRoom()) return std::nullopt;
            return pictureFromPane(view(frame), scene(frame).clipFromWorld(), roomNow(frame).ballPlaces().front());
        });
        around.onlyWhen([this] { return !picture.isSet(); }, "your picture is around");
        const auto isRoom = [this] { return inRoom(); };
        for (Knob* knob : std::vector<Knob*>{&lookup, &split, &roomSize, &ball, &moving, &keep})
            knob->onlyWhen(isRoom, "the sky is infinitely far, and at rest");
        const auto cube = [this] { return looksUp(); };
        for (Knob* knob : std::vector<Knob*>{&size, &seamless, &keep}) knob->onlyWhen(cube, "rays ask no cube");
        const auto glass = [this] { return material == Material::glass; };
        index.onlyWhen(glass, "the material is no glass");
        through.onlyWhen(glass, "nothing shines through the material");
        through.onlyWhen([this] { return body == Body::sphere; }, "the way through a teapot is no formula");
        curve.onlyWhen([this] { return material != Material::mirror; }, "the mirror reflects all");
    }

    void init() override { program = Program("environment"); }

    void check() const override {
        if (picture.isSet()) surroundingOf(picture.picture(), "--picture");
    }

    void draw(const Frame& frame) override {
        const Scene now = seen(frame);
        const vec3 eye(glm::inverse(now.viewFromWorld)[3]);
        const Pane all = view(frame);
        glEnable(GL_DEPTH_TEST);
        if (seamless && !isEs()) glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        if (!seamless && isEs()) frame.say("OpenGL ES always filters across the edges of a cube.");

        // 1. What is around, into a cube
        int faces = 0;
        if (inRoom() && looksUp()) faces = drawFaces(frame);
        if (!inRoom() && skyFor.changed(size, picture.version()))
            skyMap = CubeMap(picture.isSet() ? ownCube(picture.picture(), size) : skyCube(size), "sky");
        (!looksUp() ? *noCube : inRoom() ? roomMap : skyMap).bind(0);

        // 2. The body, which looks it up
        glViewport(all.x, all.y, all.width, all.height);
        program.use();
        program.set("clipFromBody", now.clipFromWorld() * worldFromBody());
        program.set("worldFromBody", worldFromBody());
        program.set("worldFromNormal", normalMatrix(worldFromBody()));
        program.set("eye", eye);
        setSurface();
        program.set("lookup", inRoom() ? static_cast<int>(Lookup(lookup)) : 0);
        program.set("raysFrom", splits() && !frame.measuring() ? 0.5 * all.width : 1e9);
        if (inRoom()) setRoom(program, roomNow(frame));
        (body == Body::sphere ? *round : *teapotMesh).draw();

        // 3. What is around, as the eye sees it
        if (!frame.measuring()) {
            if (inRoom()) {
                useRoom(roomNow(frame), faces > 0);
                drawRoom(now.clipFromWorld(), roomNow(frame), eye);
            } else {
                drawSky(now);
            }
        }
        if (!frame.measuring()) facesDrawn = faces;
        if (frame.readouts()) tell();
    }

    bool inRoom() const { return around == Around::room && !picture.isSet(); }
    bool looksUp() const { return !inRoom() || lookup != Lookup::rays; }
    bool splits() const { return inRoom() && split; }

    void setSurface() {
        const Coating surface = coating();
        program.set("material", static_cast<int>(surface.kind));
        program.set("index", surface.index);
        program.set("metalIndex", surface.metal.n);
        program.set("metalAbsorption", surface.metal.k);
        program.set("bySchlick", curve == Curve::schlick);
        program.set("isSphere", body == Body::sphere);
        program.set("waysOut", body == Body::teapot || through == Through::first ? 0
                               : through == Through::both                        ? 1
                                                                                 : 5);
    }

    mat4 worldFromBody() const { return body == Body::sphere ? mat4(1) : scale(0.36) * translate(-0.25, -1.55, 0); }

    // ---- the room: into the faces of the cube, and into the picture

    Room roomNow(const FrameInfo& frame) const { return {roomSize, ball + (moving ? frame.index() : 0)}; }

    static void setRoom(const Program& in, const Room& room) {
        const auto places = room.ballPlaces(), colors = Room::ballColors();
        in.set("room", room.size);
        in.set("ballAt", places);
        in.set("ballColor", colors);
    }
    void useRoom(const Room& room, bool again) {
        glEnable(GL_CULL_FACE);
        roomProgram->use();
        if (again) return;
        roomProgram->set("room", room.size);
        roomProgram->set("ballColor", Room::ballColors());
        objectSet = -2;
    }
    // Those in which something is new: all of another room, else those that the ball is in or was. Returns how many.
    int drawFaces(const Frame& frame) {
        const Room room = roomNow(frame);
        const Room before{room.size, std::exchange(drawnRound, room.round)};
        const bool isNew = roomFor.changed(size, room.size);
        if (roomMap.size() != size) roomMap = CubeMap(size, "room");
        int drawn = 0;
        for (int face = 0; face < cubeFaces; ++face) {
            const mat4 clipFromWorld = perspective(90, 1, 0.1 * room.size, 2 * room.size) * cubeFaceView(face);
            const bool isSeen = room.isBallInView(0, clipFromWorld) || before.isBallInView(0, clipFromWorld);
            if (!isNew && keep && (room.round == before.round || !isSeen)) continue;
            if (++drawn == 1) {
                useRoom(room, false);
                glViewport(0, 0, size, size);
            }
            roomMap.bindForDrawing(face);
            glClear(GL_DEPTH_BUFFER_BIT);  // the walls are everywhere: no colour is left of what was there
            drawRoom(clipFromWorld, room);
        }
        if (drawn > 0) {
            glDisable(GL_CULL_FACE);
            frame.bindTarget();
        }
        frame.count("faces of the cube drawn", drawn);
        return drawn;
    }

    // Walls that face the eye, and the balls that can be seen.
    void drawRoom(const mat4& clipFromWorld, const Room& room, const std::optional<vec3>& eye = {}) {
        // A box turned inside out by three mirrors: its fronts are inside.
        drawObject(walls, clipFromWorld, scale(-room.halfSize()));
        const auto places = room.ballPlaces();
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!room.isBallInView(i, clipFromWorld)) continue;
            if (eye && body == Body::sphere && room.isBallHidden(i, *eye)) continue;
            drawObject(static_cast<int>(i), clipFromWorld, translate(places.at(i)) * scale(room.ballRadius()));
        }
    }
    void drawObject(int number, const mat4& clipFromWorld, const mat4& worldFromObject) {
        roomProgram->set("clipFromObject", clipFromWorld * worldFromObject);
        if (objectSet != number) {
            roomProgram->set("worldFromObject", worldFromObject);
            roomProgram->set("ball", number);
        }
        objectSet = number;
        (number == walls ? *box : *ballMesh).draw();
    }

    void drawSky(const Scene& now) {
        glDepthFunc(GL_LEQUAL);
        skyProgram->use();
        mat4 turn = now.viewFromWorld;
        turn[3] = vec4(0, 0, 0, 1);  // from wherever the eye is, infinity looks the same
        skyProgram->set("worldFromClip", glm::inverse(now.clipFromView * turn));
        pane->draw();
    }

    // ---- beside it: how much is reflected, and the cube cut open

    Coating coating() const {
        return {.kind = material == Material::mirror  ? Coating::Kind::mirror
                        : material == Material::glass ? Coating::Kind::glass
                                                      : Coating::Kind::metal,
                .metal = material == Material::copper ? copper : gold,
                .index = index};
    }
    void tell() {
        headOn = luminance(coating().reflected(1));
        if (material == Material::glass && index < 1) limit = degrees(std::asin(double(index)));
    }

    static Pane view(const FrameInfo& frame) {
        if (frame.width() < 700 || frame.height() < 350) return {0, 0, frame.width(), frame.height()};
        return {0, 0, frame.width() * 5 / 8, frame.height()};
    }
    static Pane view(const Frame& frame) {  // a quantity is measured all over
        if (frame.measuring()) return {0, 0, frame.width(), frame.height()};
        return view(static_cast<const FrameInfo&>(frame));
    }

    void annotate(const Frame& frame) override {
        const Pane left = view(frame);
        if (inRoom()) glDisable(GL_CULL_FACE);
        drawing.begin(frame);
        const int words = std::clamp(frame.height() / 38, 8, 16);
        if (splits() && left.height >= 100 && left.width >= 200) {
            drawing.line({0.5 * left.width, 0}, {0.5 * left.width, left.height}, {{1, 1, 1, 0.8}, 1.5});
            drawing.text({8, left.height - 8}, (looksUp() ? "cube map, " : "") + lookup.text(), {.height = words});
            drawing.text({0.5 * left.width + 8, left.height - 8}, "rays", {.height = words});
        }
        if (left.width < frame.width()) {
            drawFigures(frame, left.width, words);
            glViewport(0, 0, frame.width(), frame.height());
        }
        drawing.draw(frame);
    }

    void drawFigures(const Frame& frame, int x, int words) {
        const double width = frame.width() - x, height = frame.height();
        drawReflectance(drawing, {{x + 52, (looksUp() ? 0.58 : 0.12) * height}, {x + width - 14, 0.93 * height}},
                        coating());
        drawing.textAround({x + 0.55 * width, 0.965 * height},
                           material.text() + (material == Material::mirror ? "" : "; thin: Schlick"),
                           {words, ink, vec4(0)});
        if (looksUp()) drawCross(frame, x, words);
    }

    void drawCross(const Frame& frame, int x, int words) {
        const double width = frame.width() - x, height = frame.height();
        const double side = std::min((width - 28) / 4, 0.40 * height / 3);
        const Pane cross{x + int(0.5 * (width - 4 * side)), int(0.03 * height), int(4 * side), int(3 * side)};
        glViewport(cross.x, cross.y, cross.width, cross.height);
        glDisable(GL_DEPTH_TEST);
        crossProgram->use();
        pane->draw();
        drawing.textAround({x + 0.5 * (width + 4 * side) - 0.9 * side, 0.03 * height + 2.5 * side}, "the cube",
                           {words, ink, vec4(0)});
    }

    // The camera. What stands in its place is the body in the middle, and what is around it.
    Scene scene(const FrameInfo& frame) const override {
        Scene scene;
        scene.viewFromWorld = turntable.seenBy(lookAt(vec3(0, 0.9, 5.4), vec3(0), vec3(0, 1, 0)));
        scene.clipFromView = perspective(34, view(frame).aspect(), 0.3, 450);  // the largest room is within
        return scene;
    }
};

constexpr Declaration declaration{
    .name = "environment",
    .sentence = "Mirror, gold, copper and glass, with what is around them looked up in a cube map.",
    .lookFor =
        "Left by the cube map, right by rays: tiles and balls do not meet, since the cube takes all for "
        "infinitely far.",
    .chapter = "Surfaces, mirrors and stages",
    .number = 31,
    .width = 960,
    .height = 560,
    .animated = true,
    .background = vec4(0.93, 0.94, 0.96, 1),
    .needs = {.depth = true, .beyondEs = {{"float targets", "the error is not measured"}}},
    .presets =
        {
            {"room", "A mirror in a room drawn into a cube map: at the line, tiles and balls do not meet."},
            {"corrected",
             "The walls meet, since the lookup knows where they are; the balls do not.",
             {{"lookup", "walls"}}},
            {"gold",
             "A golden teapot under a sky, which really is far away.",
             {{"around", "sky"}, {"body", "teapot"}, {"material", "gold"}, {"spin-x", "-8"}, {"spin-y", "25"}}},
            {"glass", "A sphere of glass turns the room upside down.", {{"material", "glass"}, {"room", "8"}}},
            {"bubble",
             "Air in water: beyond 48.6 degrees from the normal everything is reflected.",
             {{"material", "glass"}, {"index", "0.75"}, {"lookup", "rays"}, {"split", "off"}},
             {{"limit", 48.55, 48.65}}},
            {"seams",
             "Sixteen texels a side, and each face filtered by itself: where they meet it jumps.",
             {{"cube-size", "16"},
              {"seamless", "off"},
              {"lookup", "walls"},
              {"split", "off"},
              {"room", "2"},
              {"distance", "-2.3"},
              {"spin-x", "20"},
              {"spin-y", "30"}}},
        },
};

const bool added = addDemo<Environment, declaration>();

}  // namespace
