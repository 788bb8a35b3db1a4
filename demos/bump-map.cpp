// bump-map: a smooth wall and a smooth ball that are lit as bricks and as an orange, beside the really displaced surface.
//
// Claims (each is a test in tests/claims/bump-map.cpp; X54 in docs/stability.md is sight along the surface):
// - [right-straight-on] Seen straight on, a normal map leaves less than a tenth of the error of mere paint.
// - [fails-at-80] At 80 degrees it leaves more than half of that error, and more than five times its own straight on.
// - [occlusion-sees-relief] From 20 to 80 degrees parallax occlusion leaves at most two thirds of the normal map's error.
// - [finer-maps] From 256 rows on, twice as many make the normals of the map four times as exact.
// - [no-mirror-seam] A mirrored wall is lit as well as a plain one; without the sign of its frames it is not.
// - [round-outline] By maps the orange keeps the outline of the sphere; displaced it does not.
// - [no-depth-no-bumps] With depth 0 all methods show the smooth surface.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/file_knob.h"
#include "mv/demo/made_for.h"
#include "mv/geometry/mesh_tangents.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/tangent_buffer.h"
#include "mv/gl/texture.h"
#include "mv/image/mipmap.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/own_picture.h"
#include "shared/relief.h"
#include "shared/relief_figures.h"
#include "shared/spin.h"
#include "shared/strip.h"

using namespace mv;

namespace {

enum class Method { smooth, height, normal, parallax, occlusion, displaced };
enum class Kept { floats, bytes };

constexpr double wallEnd = 64;   // of the wall, both ways
constexpr int tileCells = 160;   // of 2 units of the displaced wall, each way
constexpr int orangeRows = 320;  // of the displaced orange, from pole to pole
const vec4 ink(0.1, 0.1, 0.1, 1), blue(0.1, 0.3, 0.75, 1);

struct BumpMap final : Demo {
    Choice<ReliefBody> body{
        this, "body", ReliefBody::wall, {{"wall", "bricks"}, {"orange", "a sphere with pores"}}, "what is bumped"};
    Choice<Method> method{this,
                          "method",
                          Method::normal,
                          {{"smooth", "no bumps: painted only"},
                           {"height", "normals by differences of the height map"},
                           {"normal", "normals from the normal map"},
                           {"parallax", "and looked up where the height here would be met"},
                           {"occlusion", "and looked up where the line of sight meets the height map"},
                           {"displaced", "the real relief, as a mesh"}},
                          "what is shown on the left"};
    Toggle beside{this, "beside", true, "the really displaced surface on the right"};
    Real angle{this, "angle", 50, {0, 85}, "between the line of sight and the wall's normal; on the orange, a ring",
               "deg"};
    Real depth{this, "depth", 0.08, {0, 0.25}, "of the relief; a brick is 1 long, the orange's radius is 1", "units"};
    NumberChoice mapSize{this, "map-size", 256, {32, 64, 128, 256, 512}, "rows of texels of the maps"};
    Choice<Kept> texels{
        this, "texels", Kept::floats, {{"float", "32 bits a channel"}, {"8-bit"}}, "how a texel is kept"};
    Whole layers{this, "layers", 32, {2, 128}, "into which parallax occlusion divides the depth"};
    PictureFile picture{this, "picture", "assets/coin.png", "your own as a height map, in stone: white is high"};
    Toggle mirrored{this, "mirrored", false, "the left part of the wall has the texture turned about"};
    Toggle sign{this, "sign", true, "frames keep on which side they are mirrored"};
    Real lampTurn{this, "lamp-turn", 50, {-89, 89}, "the lamp's direction, to the right of the surface's normal",
                  "deg"};
    Real lampHeight{this, "lamp-height", 40, {-89, 89}, "and above it", "deg"};
    Spin spin{this, 20, 0, vec2(0.5)};

    Readout lookups{this, "lookups", "texture lookups of a pixel, at most"};
    Readout triangles{this, "triangles", "of what the method draws"};

    OnDemand<Program> smooth{"bump-map", "smooth"}, byHeight{"bump-map", "height"}, byNormal{"bump-map"},
        byParallax{"bump-map", "parallax"}, byOcclusion{"bump-map", "occlusion"}, mapProgram{"bump-map", "map"};
    OnDemand<Mesh> sheet{withoutNormals(square()), "map"};
    Mesh flat, real, turned;
    Buffer tangents;
    MadeFor<ReliefBody, bool> flatFor;
    MadeFor<ReliefBody, int, int, double, bool> realFor;
    FloatPicture heights;
    Texture painted, normals;
    MadeFor<ReliefBody, int, int> heightsFor;
    MadeFor<ReliefBody, int, int, Texels> paintedFor;
    MadeFor<ReliefBody, int, int, Texels, double> normalsFor;
    const Program* told = nullptr;  // what holds for all that a program draws in this frame
    Drawing drawing;

    BumpMap() {
        bindKeys(Key::left, Key::right, angle, 5);
        bindWheel(depth, 0.01);
        bindHandle("lamp", {&lampTurn, &lampHeight}, [this](const FrameInfo& frame) { return dial(frame).at(lamp()); });
        bindHandle("eye", {&angle}, [this](const FrameInfo& frame) { return sight(frame).tip(angle); });
        beside.onlyWhen([this] { return method != Method::displaced; }, "the method itself shows it");
        layers.onlyWhen([this] { return method == Method::occlusion; }, "only parallax occlusion goes down in layers");
        mirrored.onlyWhen([this] { return body == ReliefBody::wall; }, "only the wall is mirrored");
        sign.onlyWhen([this] { return mirrored && body == ReliefBody::wall && usesFrames(); }, "no frame is mirrored");
        for (Knob* knob : {&spin.x, &spin.y})
            knob->onlyWhen([this] { return body == ReliefBody::orange; }, "only the orange turns");
    }

    void init() override {}
    void check() const override { picture.check(); }

    // ---- the picture: the method on the left, what is real on the right

    void draw(const Frame& frame) override {
        makeMaps();
        told = nullptr;
        glEnable(GL_DEPTH_TEST);
        const Pane left = leftPane(frame);
        glViewport(left.x, left.y, left.width, left.height);
        if (method == Method::displaced) {
            drawReal(left, frame);
        } else {
            drawMapped(left, frame);
        }
        if (showsBoth() && !frame.measuring()) {
            const Pane right = rightPane(frame);
            glViewport(right.x, right.y, right.width, right.height);
            drawReal(right, frame);
        }
    }

    bool showsBoth() const { return method != Method::displaced && beside; }
    bool usesFrames() const { return method != Method::smooth && method != Method::displaced; }
    bool usesNormals() const { return usesFrames() && method != Method::height; }
    Pane leftPane(const Frame& frame) const {
        if (frame.measuring()) return {0, 0, frame.width(), frame.height()};
        return paneAboveStrip(frame, 0, showsBoth() ? 0.498 : 1);
    }

    static Pane rightPane(const FrameInfo& frame) { return paneAboveStrip(frame, 0.502, 1); }

    // The smooth surface, bumped by a program.
    void drawMapped(const Pane& pane, const Frame& frame) {
        if (flatFor.changed(body, isMirrored())) {
            const MeshTangents made = meshTangents(
                body == ReliefBody::orange ? sphere(1, 256, 128) : wallPiece(relief(), -wallEnd, wallEnd, 128, 2));
            flat = Mesh(made.mesh, "smooth surface");
            tangents = attachTangents(made.tangents, "smooth surface");
        }
        const Program& program = method == Method::smooth     ? *smooth
                                 : method == Method::height   ? *byHeight
                                 : method == Method::normal   ? *byNormal
                                 : method == Method::parallax ? *byParallax
                                                              : *byOcclusion;
        tell(program, frame);
        program.set("clipFromBody", scene(frame, pane.aspect()).clipFromWorld());
        if (usesFrames()) program.set("keepsSign", sign || !isMirrored());
        if (usesNormals()) program.set("normals", 1);
        if (usesFrames() && method != Method::normal) {
            program.set("depth", depth);
            program.set("unitsOfRepeat", unitsOfRepeat(body));
            program.set("isRound", body == ReliefBody::orange);
            program.set("leastCosine", std::sin(pi / mapSize));
        }
        if (method == Method::occlusion) program.set("layers", layers);
        flat.draw();
        const auto corners = flat.count();
        triangles = double(corners) / 3;
        constexpr std::array<int, 5> lookupsOf{1, 5, 2, 3, 3};
        lookups = lookupsOf.at(static_cast<std::size_t>(Method(method))) + (method == Method::occlusion ? layers : 0);
    }

    // The displaced surface, with its own normals; of the wall as many pieces as are in view.
    void drawReal(const Pane& pane, const Frame& frame) {
        if (realFor.changed(body, picture.version(), picture.isSet() ? int(mapSize) : 0, depth, isMirrored())) {
            real =
                Mesh(displaced(relief(), body == ReliefBody::orange ? sphere(1, 2 * orangeRows, orangeRows)
                                                                    : wallPiece(relief(), 0, 2, tileCells, tileCells)),
                     "displaced surface");
            if (isMirrored())
                turned = Mesh(displaced(relief(), wallPiece(relief(), -2, 0, tileCells, tileCells)), "mirrored piece");
        }
        tell(*smooth, frame);
        const mat4 clipFromWorld = scene(frame, pane.aspect()).clipFromWorld();
        const auto [first, last] = piecesInView(pane.aspect());
        for (int i = first; i <= last; ++i) {
            const bool isTurned = isMirrored() && i < 0;
            smooth->set("clipFromBody", clipFromWorld * translate(isTurned ? 2 * i + 2 : 2 * i, 0, 0));
            (isTurned ? turned : real).draw();
        }
        if (method == Method::displaced) {
            triangles = (last - first + 1) * real.count() / 3.0;
            lookups = 1;
        }
    }
    // The first and the last: number 0 of the wall begins at x = 0 and is 2 units long. The relief lies below the wall's
    // plane, and is seen from the right: so what is seen reaches farther to the left.
    std::pair<int, int> piecesInView(double aspect) const {
        if (body == ReliefBody::orange) return {0, 0};
        const double half = aspect / std::cos(radians(angle)), below = depth * std::tan(radians(angle));
        return {static_cast<int>(std::floor(std::max(-half - below, -wallEnd) / 2)),
                static_cast<int>(std::ceil(std::min(half, wallEnd) / 2)) - 1};
    }

    // What holds for all that a program draws in this frame. Light and eye are told in the body's space.
    void tell(const Program& program, const Frame& frame) {
        if (told == &program) return;
        told = &program;
        const mat3 bodyFromWorld = glm::transpose(mat3(worldFromBody()));
        program.use();
        program.set("light", bodyFromWorld * lamp());
        program.set("view", bodyFromWorld * towardsEye());
        program.set("band", frame.measuring() ? measuredBand(body, angle) : vec2(-1, 1e9));
    }
    static vec2 measuredBand(ReliefBody body, double angle) {
        if (body == ReliefBody::wall) return {-1, 1e9};
        return {angle < 2.5 ? -1 : std::sin(radians(angle - 2.5)), std::sin(radians(angle + 2.5))};
    }

    // ---- where things are

    bool isMirrored() const { return mirrored && body == ReliefBody::wall; }
    Relief relief() const { return {body, depth, isMirrored(), picture.isSet() ? &heights : nullptr}; }
    mat4 worldFromBody() const { return body == ReliefBody::orange ? spin.turn() : mat4(1); }
    vec3 lamp() const { return {rotateY(lampTurn) * rotateX(-lampHeight) * vec4(0, 0, 1, 0)}; }
    vec3 towardsEye() const {
        return body == ReliefBody::orange ? vec3(0, 0, 1) : vec3(std::sin(radians(angle)), 0, std::cos(radians(angle)));
    }
    // A parallel projection: all of the wall is seen at one angle. The world of this scene is the body's space.
    Scene scene(const FrameInfo&, double aspect) const {
        Scene scene;
        if (body == ReliefBody::orange) {
            const double up = 1.1 * std::max(1.0, 1 / aspect);
            scene.clipFromView = ortho(-up * aspect, up * aspect, -up, up, -2, 2);
            scene.viewFromWorld = worldFromBody();
        } else {
            scene.clipFromView = ortho(-aspect, aspect, -1, 1, -70, 70);
            scene.viewFromWorld = rotateY(-angle);
        }
        scene.lights = {{.position = vec4(glm::transpose(mat3(worldFromBody())) * lamp(), 0)}};
        return scene;
    }
    Scene scene(const FrameInfo& frame) const override { return scene(frame, frame.aspect()); }

    // ---- the maps

    void makeMaps() {
        if (heightsFor.changed(body, mapSize, picture.version())) heights = heightMap();
        const TextureFilter filter{.minify = GL_LINEAR_MIPMAP_LINEAR, .magnify = GL_LINEAR, .wrap = GL_REPEAT};
        if (usesNormals()) {
            if (normalsFor.changed(body, mapSize, picture.version(), format(), depth)) {
                normals = Texture(mipmaps(reliefNormals(relief(), heights)), {.texels = format(), .label = "normals"});
                normals.filterBy(filter, 1);
                clampAtPoles();
                paintedFor.forget();  // its unit was used
            } else {
                normals.bind(1);
            }
        }
        if (paintedFor.changed(body, mapSize, picture.version(), format())) {
            painted = Texture(mipmaps(heights), {.texels = format(), .label = "painted"});
            painted.filterBy(filter);
            clampAtPoles();
        } else {
            painted.bind(0);
        }
    }
    FloatPicture heightMap() const {
        if (!picture.isSet()) return paintedMap(body, mapSize);
        return ownHeights(picture.picture(), body == ReliefBody::orange ? 2 * mapSize : int(mapSize), mapSize);
    }
    void clampAtPoles() const {  // beyond the orange's north pole there is no south
        if (body == ReliefBody::orange) glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    Texels format() const {
        if (texels == Kept::bytes) return Texels::bytes;
        return has(beyond_es::floatFiltering) ? Texels::floats : Texels::halfFloats;
    }

    // ---- below it: the maps, the lamp, the angle

    static double reach(const FrameInfo& frame) { return 0.10 * std::min(1.0 * frame.height(), 0.8 * frame.width()); }
    static vec2 inStrip(const FrameInfo& frame, double part) { return {part * frame.width(), 0.125 * frame.height()}; }
    static SightFigure sight(const FrameInfo& frame) {
        return {inStrip(frame, 0.58) - vec2(0, reach(frame)), 1.75 * reach(frame)};
    }
    static LampDial dial(const FrameInfo& frame) { return {inStrip(frame, 0.84), reach(frame)}; }

    void annotate(const Frame& frame) override {
        drawing.begin(frame);
        // No words where they have no room
        const int size = std::clamp(std::min(frame.height() / 36, frame.width() / 50), 8, 16);
        const int words = textWidth("height map", {size}) < 2.4 * reach(frame) ? size : 0;
        mapProgram->use();
        drawMap(frame, 0, "height map", words);
        if (usesNormals()) drawMap(frame, 1, "normal map", words);
        glViewport(0, 0, frame.width(), frame.height());
        sight(frame).draw(drawing, angle, words);
        dial(frame).draw(drawing, lamp(), words);

        constexpr std::array<const char*, 6> titles{"no bumps", "bumps by the height map", "bumps by the normal map",
                                                    "parallax", "parallax occlusion",      "really displaced"};
        const auto name = [&](const Pane& pane, Method shown) {
            drawing.in(pane);
            if (words > 0) drawWords(drawing, frame, pane, 0, {{titles.at(static_cast<std::size_t>(shown)), ink}});
        };
        name(leftPane(frame), method);
        if (body == ReliefBody::orange) drawRing(leftPane(frame));
        if (showsBoth()) name(rightPane(frame), Method::displaced);
        drawing.draw(frame);
    }
    void drawMap(const Frame& frame, int unit, const char* name, int words) {
        const double wide = 2 * reach(frame), high = body == ReliefBody::wall ? wide : wide / 2;
        const vec2 corner = inStrip(frame, 0.02) + vec2(unit * 1.2, -0.5) * wide;
        glViewport(static_cast<int>(corner.x), static_cast<int>(corner.y), std::max(1, static_cast<int>(wide)),
                   std::max(1, static_cast<int>(high)));
        mapProgram->set("image", unit);
        mapProgram->set("isAlpha", unit == 0);
        sheet->draw();
        if (words > 0) drawing.text(corner + vec2(0, high + 1.5 * words), name, {words, ink, vec4(0)});
    }
    // Where the orange is seen at that angle.
    void drawRing(const Pane& left) {
        const vec2 size(left.width, left.height);
        const double r = 0.5 * std::min(size.x, size.y) / 1.1 * std::sin(radians(angle));
        std::vector<vec2> ring;
        for (int i = 0; i <= 96; ++i)
            ring.push_back(0.5 * size + r * vec2(std::cos(pi * i / 48), std::sin(pi * i / 48)));
        drawing.line(ring, {blue, 1});
    }
};

constexpr Declaration declaration{
    .name = "bump-map",
    .sentence = "A brick wall and an orange by height map, normal map, parallax and parallax occlusion.",
    .lookFor = "Lit alike, but on the left no brick hides the mortar behind it: the surface is flat.",
    .chapter = "Surfaces, mirrors and stages",
    .number = 20,
    .width = 960,
    .height = 600,
    .background = vec4(0.93, 0.94, 0.96, 1),
    .needs = {.depth = true,
              .beyondEs = {{"float targets", "the error is not measured"},
                           {"float filtering", "float texels have 16 bits a channel"}}},
    .presets =
        {
            {"normal-map", "The light is right, but the bricks hide no mortar: the surface is flat."},
            {"orange", "The lecture's case: a sphere, a map, an orange.", {{"body", "orange"}, {"depth", "0.04"}}},
            {"grazing", "At 80 degrees the trick is seen through.", {{"angle", "80"}}},
            {"parallax-swims",
             "One guess from one height: at 70 degrees edges smear.",
             {{"method", "parallax"}, {"angle", "70"}}},
            {"occlusion",
             "Down the line of sight in layers: bricks hide mortar.",
             {{"method", "occlusion"}, {"angle", "70"}}},
            {"inside-out",
             "Mirrored texture, and frames without their sign: left of the middle the courses are lit from below.",
             {{"mirrored", "on"}, {"sign", "off"}, {"angle", "0"}}},
        },
};

const bool added = addDemo<BumpMap, declaration>();

}  // namespace
