// mirror: a plane mirror, and two that face each other, by the stencil buffer or by a texture.
//
// Claims (each is a test in tests/claims/mirror.cpp; X55 and X56 in docs/stability.md are its extremes):
// - [as-by-rays] Away from edges every pixel shows the object, as bright as it is, that a ray meets which every mirror on its
//   way turns round, by either method, with one bounce and with many.
// - [few-edges] Edges are at most 5 % of the picture.
// - [methods-agree] Both methods make the same picture, but for the rounding of the texture's 8 bits.
// - [stays-behind] What stands behind the mirror is not seen in it, by either near plane; with none it is.
// - [eye-in-the-plane] An eye in the mirror's plane or behind it sees nothing in it, and no pass is drawn for it.
// - [each-bounce-a-pass] A bounce more costs each of two mirrors a pass at most, and one mirror has a single bounce.
// - [winding] A reflection turns the winding over: unless that is set, bodies are seen from inside.
// - [only-what-it-shows] Objects that no mirror shows are not drawn for it, and the picture is the same.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/geometry/bounds.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/scene_meshes.h"
#include "mv/gl/target.h"
#include "mv/math/shadow.h"
#include "shared/mirror_room.h"
#include "shared/mirrors.h"

using namespace mv;

namespace {

enum class Method { stencil, texture };
enum class Near { oblique, clipDistance, none };
enum class Count { one, two };

constexpr vec3 sky(0.80, 0.88, 0.95);

struct MirrorDemo final : Demo {
    Choice<Method> method{this,
                          "method",
                          Method::stencil,
                          {{"stencil", "the mirrored world is drawn into the picture, where the mirror has marked it"},
                           {"texture", "it is drawn into a texture, which the mirror shows"}},
                          "how a mirror is drawn"};
    Choice<Near> near{this,
                      "near",
                      Near::oblique,
                      {{"oblique", "the near plane is laid into the mirror"},
                       {"clip-distance", "by gl_ClipDistance; depths stay as they were"},
                       {"none", "by nothing: it gets in"}},
                      "how what stands behind the mirror is kept out of it"};
    Choice<Count> count{this, "mirrors", Count::one, {{"one"}, {"two", "facing each other"}}, "how many there are"};
    Whole bounces{this, "bounces", 8, {1, 16}, "reflections one after another, at most"};
    Real reflectance{this, "reflectance", 0.85, {0, 1}, "part of the light that a mirror sends on"};
    NumberChoice coarser{this, "coarser", 1, {1, 2, 4, 8, 16}, "pixels of the picture along a texel"};
    Toggle keep{this, "keep", true, "keep the textures while eye and world rest"};
    Angle turn{this, "mirror-turn", 0, "of the first mirror about its upright axis"};
    Real eyeX{this, "eye-x", 0.9, {-3, 3}, "where the eye stands, which looks at the first mirror's middle"};
    Real eyeZ{this, "eye-z", 2.9, {-5, 5}, "the same; the first mirror stands at -2, the second at 3.4"};
    Real eyeHeight{this, "eye-height", 1.7, {0.2, 3}, "the same, above the floor"};
    Real ballX{this, "ball-x", -0.35, {-3, 3}, "where the ball lies"};
    Real ballZ{this, "ball-z", -0.35, {-5, 5}, "the same"};
    Toggle winding{this, "winding", true, "say which winding is the front, which each reflection turns over"};
    Toggle leaveOut{this, "leave-out", true, "draw nothing for a mirror that it does not show"};

    Readout passes{this, "passes", "times that the world is drawn in a mirror"};
    Readout drawn{this, "drawn", "objects drawn there, together"};
    Readout leftOut{this, "left-out", "objects that are not, since no mirror shows them"};
    Readout distance{this, "eye-distance", "of the eye from the first mirror's plane; below 0 behind it"};
    Readout steps{this, "depth-steps", "steps of 24 bits from the ball's front to its back, in the first mirror"};

    Program program;
    OnDemand<Program> plain{"mirror", "surface"}, textured{"mirror", "texture"};
    Mesh rectangle;
    Scene now;
    SceneMeshes meshes;
    std::array<std::array<Target, 2>, 2> textures;  // of each chain of mirrors, for even and odd bounces
    MadeFor<Scene, int, int, bool, Near, int, double, int, bool, bool> texturesFor;
    Drawing drawing;

    // The world as it is seen after some reflections.
    struct View {
        int bounce = 0;
        mat4 clipFromWorld{1};
        std::vector<vec4> edges = {};  // in clip space: between them all lies that is seen
        vec4 before{0};                // half space in world space: what is not in it is behind the last mirror,
        ObjectId frame{0};             // and so is this
    };
    std::vector<std::vector<SeenMirror>> chains;
    std::vector<std::array<vec4, 8>> boxes;  // round each object, in world space
    struct Work {
        int passes = 0, drawn = 0, leftOut = 0;
    } work;  // for all mirrors, when what they show was drawn last

    // What uniforms and state were set to last in this frame: many draws share them.
    struct Last {
        const Program* program = nullptr;
        MadeFor<std::size_t> object = {};
        MadeFor<double> part = {}, sky = {};
        MadeFor<vec4> light = {}, before = {};
        MadeFor<vec3> lookup = {};
        MadeFor<const Program*, mat4> place = {};
        MadeFor<bool> clips = {};
        bool clockwise = false;
    } last;

    MirrorDemo() {
        bindKeys(Key::left, Key::right, bounces, 1);
        bindDrag(eyeX, -0.01, eyeHeight, 0.01);
        bindWheel(eyeZ, -0.1);
        bindHandle("ball", {&ballX, &ballZ}, [this](const FrameInfo& frame) {
            const Pane picture{0, 0, frame.width(), frame.height()};
            return pictureFromPane(picture, scene(frame).clipFromWorld(), room().ball);
        });
        bindHandle("eye", {&eyeX, &eyeZ}, [this](const FrameInfo& frame) {
            return planOfRoom(frame).pixel({eyeX, eyeZ});
        });
        bounces.onlyWhen([this] { return count == Count::two; }, "a single mirror is not seen in itself");
        for (Knob* knob : std::vector<Knob*>{&coarser, &keep})
            knob->onlyWhen([this] { return method == Method::texture; }, "there is no texture");
    }

    void init() override {
        program = Program("mirror");
        rectangle = Mesh(positionsOnly(square()), "mirror");
    }

    void draw(const Frame& frame) override {
        now = seen(frame);
        meshes.follow(now);
        // The mirrors that are seen through one another; the last one shows nothing.
        chains = mirrorChains(room().mirrors(), now.clipFromWorld(), bounces + 1);
        for (const auto& chain : chains)
            frame.show("worldFromImage" + std::to_string(chain[0].which + 1), chain[0].worldFromShown);
        const vec2 whole(frame.width(), frame.height());
        findBoxes();
        last = {};
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_CULL_FACE);

        if (method == Method::texture && !chains.empty() && haveChanged(frame)) {
            drawTextures(frame);
            frame.bindTarget();
        }
        // The world as it is, and the mirrors in it
        drawWorld({.clipFromWorld = now.clipFromWorld(), .edges = edgesOfView()}, 1);
        const bool marks = method == Method::stencil && !chains.empty();
        if (marks) {
            glEnable(GL_STENCIL_TEST);
            glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        }
        for (std::size_t c = 0; c < chains.size(); ++c) {
            if (marks) glStencilFunc(GL_ALWAYS, mark(c, 1), ~0U);
            drawMirror(c, 0, whole);
        }
        if (marks) {
            drawWhereMarked(whole);
            glDisable(GL_STENCIL_TEST);
        }
        setFront(0);
        tell(frame);
    }

    // ---- by the stencil buffer

    // The world in each mirror, where a mark says that it is seen: bounce after bounce, each over the one before.
    void drawWhereMarked(const vec2& whole) {
        work = {};
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        for (int bounce = 1; bounce <= bounces; ++bounce) {
            for (std::size_t c = 0; c < chains.size(); ++c) {
                if (bounce > length(c)) continue;
                glStencilFunc(GL_EQUAL, mark(c, bounce), ~0U);

                // 1. Where this mirror is seen, all is as far away again as can be
                glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
                glDepthFunc(GL_ALWAYS);
                glDepthRange(1, 1);
                drawMirror(c, bounce - 1, whole);
                glDepthRange(0, 1);
                glDepthFunc(GL_LESS);
                glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

                // 2. The world after so many reflections, each of which leaves a part of its light
                drawWorld(viewAfter(c, bounce), std::pow(double(reflectance), bounce));

                // 3. The other mirror in it, which moves the mark on by 1 where it is seen
                if (bounce == length(c)) continue;
                glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
                drawMirror(c, bounce, whole);
                glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
            }
        }
    }
    // Chains may be seen beside each other, so their marks differ.
    static int mark(std::size_t chain, int bounce) { return bounce + 128 * static_cast<int>(chain); }

    // ---- by textures

    // From the last bounce to the first: what is seen in a mirror shows the other mirror, with what is seen in that.
    void drawTextures(const Frame& frame) {
        const int width = (frame.width() + coarser - 1) / coarser, height = (frame.height() + coarser - 1) / coarser;
        const Target::Buffers buffers{
            .depth = true, .color = static_cast<GLenum>(frame.measuring() ? GL_R32F : GL_RGBA8), .texture = true};
        const fvec3 clear(frame.measuring() ? vec3(0.3 * (sky.x + sky.y + sky.z)) : sky);
        glClearColor(clear.x, clear.y, clear.z, 1);
        work = {};
        for (int bounce = bounces; bounce >= 1; --bounce) {
            for (std::size_t c = 0; c < chains.size(); ++c) {
                if (bounce > length(c)) continue;
                Target& target = textureOf(c, bounce);
                if (!target.fit(width, height, buffers, "mirrored")) target.bind();
                glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
                drawWorld(viewAfter(c, bounce), 1);
                if (bounce < length(c)) drawMirror(c, bounce, vec2(width, height));
            }
        }
    }
    // Unlike a shadow map they are made for one eye.
    bool haveChanged(const Frame& frame) {
        const bool changed = texturesFor.changed(now, frame.width(), frame.height(), frame.measuring(), nearBy(),
                                                 bounces, reflectance, coarser, winding, leaveOut);
        return changed || !keep;
    }
    Target& textureOf(std::size_t chain, int bounce) {
        return textures.at(chain).at(static_cast<std::size_t>(bounce % 2));
    }

    // ---- what both draw

    int length(std::size_t chain) const { return static_cast<int>(chains[chain].size()); }

    // A mirror of the chain as it is seen after so many reflections: with its texture, or before anything is seen in it.
    void drawMirror(std::size_t chain, int bounce, const vec2& size) {
        const Mirror mirror = room().mirrors()[chains[chain][static_cast<std::size_t>(bounce)].which];
        const bool hasTexture = method == Method::texture && bounce < bounces;
        const Program& surface = hasTexture ? *textured : *plain;
        use(surface);
        if (hasTexture) {
            textureOf(chain, bounce + 1).bindColor(0);
            const vec3 lookup(1.0 / size, reflectance);
            if (last.lookup.changed(lookup)) surface.set("lookup", lookup);
        } else {
            const double part = std::pow(double(reflectance), method == Method::texture ? 1 : bounce + 1);
            if (last.sky.changed(part)) surface.set("sky", part * sky);
        }
        // From the unit square, which lies in the plane y = 0
        const mat4 worldFromSquare(vec4(2.0 * mirror.halfU, 0), vec4(vec3(mirror.plane()), 0),
                                   vec4(-2.0 * mirror.halfV, 0), vec4(mirror.middle, 1));
        const mat4 clipFromSquare = viewAfter(chain, bounce).clipFromWorld * worldFromSquare;
        if (last.place.changed(&surface, clipFromSquare)) surface.set("clipFromSquare", clipFromSquare);
        setFront(bounce);
        rectangle.draw();
    }

    // The world as it is seen after so many reflections.
    View viewAfter(std::size_t chain, int bounce) const {
        if (bounce == 0) return {.clipFromWorld = now.clipFromWorld(), .edges = edgesOfView()};
        const SeenMirror& mirror = chains[chain][static_cast<std::size_t>(bounce - 1)];
        const vec4 plane = room().mirrors()[mirror.which].plane();
        const mat4 viewFromShown = now.viewFromWorld * mirror.worldFromShown;
        View view{bounce, now.clipFromView * viewFromShown, mirror.edges, plane, MirrorRoom::frameOf(mirror.which)};
        if (nearBy() == Near::oblique)
            view.clipFromWorld =
                withNearPlane(now.clipFromView, planeIn(glm::inverse(viewFromShown), plane)) * viewFromShown;
        return view;
    }
    Near nearBy() const {
        return near == Near::clipDistance && !has(beyond_es::clipDistances) ? Near::oblique : Near(near);
    }

    // All of it but mirrors; `part` of its light is left.
    void drawWorld(const View& view, double part) {
        setFront(view.bounce);
        use(program);
        const vec4 light = now.lights.front().position;
        if (last.light.changed(light)) program.set("light", light);
        if (last.part.changed(part)) program.set("part", part);
        const bool clips = view.bounce > 0 && nearBy() == Near::clipDistance;
        if (!isEs() && last.clips.changed(clips)) program.set("clips", clips);
        if (clips && last.before.changed(view.before)) program.set("beforeMirror", view.before);
        if (clips) glEnable(GL_CLIP_DISTANCE0);
        const auto all = meshes.of(now);
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!isShown(i, view)) continue;
            const auto& [object, mesh] = all[i];
            if (last.object.changed(i)) {
                program.set("worldFromObject", object.worldFromObject);
                program.set("color", object.color);
                program.set("number", double(i + 1));
            }
            program.set("clipFromObject", view.clipFromWorld * object.worldFromObject);
            mesh.draw();
            if (view.bounce > 0) ++work.drawn;
        }
        if (clips) glDisable(GL_CLIP_DISTANCE0);
        if (view.bounce > 0) ++work.passes;
    }

    // Whether anything of the object may be seen there. A mirror hides its own frame, which is right behind it.
    bool isShown(std::size_t object, const View& view) {
        if (view.bounce > 0 && object == view.frame.index) return false;
        const auto isBeyond = [&] {
            std::array<vec4, 8> clip{};
            std::transform(boxes[object].begin(), boxes[object].end(), clip.begin(),
                           [&](const vec4& corner) { return view.clipFromWorld * corner; });
            return areBeyond(clip, view.edges) ||
                   (view.bounce > 0 && nearBy() != Near::none && areBeyond(boxes[object], {&view.before, 1}));
        };
        if ((view.bounce > 0 && !leaveOut) || !isBeyond()) return true;
        if (view.bounce > 0) ++work.leftOut;
        return false;
    }

    // Each reflection turns the winding of all faces over.
    void setFront(int bounce) {
        const bool turned = winding && bounce % 2 == 1;
        if (turned != last.clockwise) glFrontFace(turned ? GL_CW : GL_CCW);
        last.clockwise = turned;
    }
    void use(const Program& other) {
        if (last.program != &other) other.use();
        last.program = &other;
    }

    void findBoxes() {
        boxes.clear();
        for (const SceneObject& object : now.objects) {
            const auto box = boundsOf(object.mesh, object.worldFromObject).corners();
            std::array<vec4, 8>& corners = boxes.emplace_back();
            std::transform(box.begin(), box.end(), corners.begin(), [](const vec3& p) { return vec4(p, 1); });
        }
    }

    // ---- the scene

    MirrorRoom room() const {
        return {turn, count == Count::two, {eyeX, eyeHeight, eyeZ}, {ballX, MirrorRoom::ballRadius, ballZ}};
    }
    Scene scene(const FrameInfo& frame) const override { return room().scene(frame.aspect()); }

    void check() const override {
        const vec3 beside = room().eye - MirrorRoom::lookedAt();
        if (std::hypot(beside.x, beside.z) < 0.01)
            throw Error("--eye-x", "must keep the eye from above the first mirror's middle, on which it looks",
                        eyeX.text());
    }

    // ---- what is told beside it

    void tell(const Frame& frame) {
        if (chains.empty()) work = {};
        passes = work.passes;
        drawn = work.drawn;
        leftOut = work.leftOut;
        const vec4 eye(room().eye, 1), plane = room().mirrors().front().plane();
        distance = glm::dot(plane, eye);
        if (lightSide(eye, plane) <= 0)
            frame.say("The eye is not in front of the first mirror: nothing is seen in it.");
        if (chains.empty() || chains.front().front().which != 0) return;
        const double left = depthSteps();
        steps = left;
        if (nearBy() == Near::oblique && left < 256) {
            frame.say(rounded("So near the mirror's plane the oblique near plane leaves %.0f steps of depth ", left) +
                      "from the ball's front to its back; --near clip-distance leaves as many as ever.");
        }
    }

    // From the ball's front to its back, as the eye sees them in the first mirror.
    double depthSteps() const {
        const View view = viewAfter(0, 1);
        const vec3 imagedEye(reflection(view.before) * vec4(room().eye, 1)), ball = room().ball;
        const vec3 along = MirrorRoom::ballRadius * glm::normalize(ball - imagedEye);
        const vec4 front = view.clipFromWorld * vec4(ball - along, 1),
                   back = view.clipFromWorld * vec4(ball + along, 1);
        return 0.5 * (back.z / back.w - front.z / front.w) * (std::exp2(24) - 1);
    }

    void annotate(const Frame& frame) override {
        drawing.begin(frame);
        drawPlan(drawing, frame, room(), now, chains);
        drawing.draw(frame);
    }
};

constexpr Declaration declaration{
    .name = "mirror",
    .sentence = "A plane mirror by the stencil buffer or by a texture, and two that show each other many times.",
    .lookFor =
        "What is in the mirror is as far behind it as it is in front, and nothing there has come from behind it.",
    .chapter = "Surfaces, mirrors and stages",
    .number = 30,
    .width = 960,
    .height = 560,
    .background = vec4(sky, 1),
    .needs = {.depth = true,
              .stencil = true,
              .beyondEs = {{"clip distances", "the near plane is laid into the mirror instead"},
                           {"float targets", "what is wrong is not measured"}}},
    .presets =
        {
            {"one", "The red line is the light's way: from the ball to the mirror, and from there to the eye."},
            {"behind",
             "Nothing keeps out what stands behind the mirror: the red column comes out of it.",
             {{"near", "none"}}},
            {"facing",
             "Two mirrors show each other: every second image shows things from their other side.",
             {{"mirrors", "two"}}},
            {"inside-out",
             "A reflection turns the winding over; whoever forgets that draws the insides.",
             {{"winding", "off"}}},
            {"coarse", "By a texture whose texels are 8 pixels wide.", {{"method", "texture"}, {"coarser", "8"}}},
            {"turned",
             "Two mirrors that are not parallel: the images lie on a circle.",
             {{"mirrors", "two"}, {"mirror-turn", "12"}}},
        },
    .waste = {{"no-sample", "draw of 'floor'", "what of the floor is seen is known when it is drawn"},
              {"unused-buffer", "stencil of 'mirror'", "a mirror by a texture does without"}},
};

const bool added = addDemo<MirrorDemo, declaration>();

}  // namespace
