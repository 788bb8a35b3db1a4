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
#include <numbers>
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
#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"
#include "shared/mirrors.h"

using namespace mv;

namespace {

enum class Method { stencil, texture };
enum class Near { oblique, clipDistance, none };
enum class Count { one, two };

const vec3 sky(0.80, 0.88, 0.95);
const vec3 firstMiddle(0, 1.2, -2), secondMiddle(0, 1.2, 3.4);  // of the mirrors; the eye looks at the first
const vec3 halfU(1.4, 0, 0), halfV(0, 1, 0);
constexpr double ballRadius = 0.35;
constexpr ObjectId ofFloor{0}, ofFrame{1}, ofBall{2}, ofSecondFrame{6};
const vec4 red(0.8, 0.1, 0.1, 1), blue(0.1, 0.35, 0.8, 1), grey(0.5, 0.5, 0.5, 1), ink(0.1, 0.1, 0.1, 1);

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
        ObjectId frame = ofFrame;      // and so is this
    };
    std::vector<std::vector<SeenMirror>> chains;
    std::vector<std::array<vec4, 8>> boxes;  // round each object, in world space
    struct Work {
        int passes = 0, drawn = 0, leftOut = 0;
    } work;  // for all mirrors, when what they show was drawn last

    // Uniforms and state that are set only where they change
    const Program* inUse = nullptr;
    MadeFor<std::size_t> objectSet;
    MadeFor<double> partSet, skySet;
    MadeFor<vec4> beforeSet, lightSet;
    MadeFor<vec3> lookupSet;
    MadeFor<const Program*, mat4> placeSet;
    MadeFor<bool> clipsSet, frontSet;

    MirrorDemo() {
        bindKeys(Key::left, Key::right, bounces, 1);
        bindDrag(eyeX, -0.01, eyeHeight, 0.01);
        bindWheel(eyeZ, -0.1);
        bindHandle("ball", {&ballX, &ballZ}, [this](const FrameInfo& frame) {
            const Pane picture{0, 0, frame.width(), frame.height()};
            return pictureFromPane(picture, scene(frame).clipFromWorld(), ball());
        });
        bindHandle("eye", {&eyeX, &eyeZ}, [this](const FrameInfo& frame) { return plan(frame).pixel({eyeX, eyeZ}); });
        bounces.onlyWhen([this] { return count == Count::two; }, "a single mirror is not seen in itself");
        for (Knob* knob : std::vector<Knob*>{&coarser, &keep})
            knob->onlyWhen([this] { return method == Method::texture; }, "there is no texture");
    }

    void init() override {
        program = Program("mirror");
        rectangle = Mesh(square(), "mirror");
    }

    void draw(const Frame& frame) override {
        now = seen(frame);
        meshes.follow(now);
        // The mirrors that are seen through one another; the last one shows nothing.
        chains = mirrorChains(mirrors(), now.clipFromWorld(), bounces + 1);
        const vec2 whole(frame.width(), frame.height());
        begin();
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
        const Mirror mirror = mirrors()[chains[chain][static_cast<std::size_t>(bounce)].which];
        const bool hasTexture = method == Method::texture && bounce < bounces;
        const Program& surface = hasTexture ? *textured : *plain;
        use(surface);
        if (hasTexture) {
            textureOf(chain, bounce + 1).bindColor(0);
            const vec3 lookup(1.0 / size, reflectance);
            if (lookupSet.changed(lookup)) surface.set("lookup", lookup);
        } else {
            const double part = std::pow(double(reflectance), method == Method::texture ? 1 : bounce + 1);
            if (skySet.changed(part)) surface.set("sky", part * sky);
        }
        // From the unit square, which lies in the plane y = 0
        const mat4 worldFromSquare(vec4(2.0 * mirror.halfU, 0), vec4(vec3(mirror.plane()), 0),
                                   vec4(-2.0 * mirror.halfV, 0), vec4(mirror.middle, 1));
        const mat4 clipFromSquare = viewAfter(chain, bounce).clipFromWorld * worldFromSquare;
        if (placeSet.changed(&surface, clipFromSquare)) surface.set("clipFromSquare", clipFromSquare);
        setFront(bounce);
        rectangle.draw();
    }

    // The world as it is seen after so many reflections.
    View viewAfter(std::size_t chain, int bounce) const {
        if (bounce == 0) return {.clipFromWorld = now.clipFromWorld(), .edges = edgesOfView()};
        const SeenMirror& last = chains[chain][static_cast<std::size_t>(bounce - 1)];
        const vec4 plane = mirrors()[last.which].plane();
        const mat4 viewFromShown = now.viewFromWorld * last.worldFromShown;
        View view{bounce, now.clipFromView * viewFromShown, last.edges, plane,
                  last.which == 0 ? ofFrame : ofSecondFrame};
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
        if (lightSet.changed(light)) program.set("light", light);
        if (partSet.changed(part)) program.set("part", part);
        const bool clips = view.bounce > 0 && nearBy() == Near::clipDistance;
        if (clipsSet.changed(clips)) program.set("clips", clips);
        if (clips && beforeSet.changed(view.before)) program.set("beforeMirror", view.before);
        if (clips) glEnable(GL_CLIP_DISTANCE0);
        const auto all = meshes.of(now);
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!isShown(i, view)) continue;
            const auto& [object, mesh] = all[i];
            if (objectSet.changed(i)) {
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
        if (frontSet.changed(turned)) glFrontFace(turned ? GL_CW : GL_CCW);
    }
    void use(const Program& other) {
        if (inUse != &other) other.use();
        inUse = &other;
    }

    void begin() {
        boxes.clear();
        for (const SceneObject& object : now.objects) {
            const auto box = boundsOf(object.mesh, object.worldFromObject).corners();
            std::array<vec4, 8>& corners = boxes.emplace_back();
            std::transform(box.begin(), box.end(), corners.begin(), [](const vec3& p) { return vec4(p, 1); });
        }
        inUse = nullptr;
        objectSet.forget();
        partSet.forget();
        clipsSet.forget();
        beforeSet.forget();
        lightSet.forget();
        skySet.forget();
        lookupSet.forget();
        placeSet.forget();
        (void)frontSet.changed(false);
    }

    // ---- the scene

    std::vector<Mirror> mirrors() const {
        const vec3 turned(rotateY(turn) * vec4(halfU, 0));
        if (count == Count::one) return {{firstMiddle, turned, halfV}};
        return {{firstMiddle, turned, halfV}, {secondMiddle, -halfU, halfV}};
    }
    vec3 ball() const { return {ballX, ballRadius, ballZ}; }
    vec3 eye() const { return {eyeX, eyeHeight, eyeZ}; }

    void check() const override {
        if (std::hypot(eyeX - firstMiddle.x, eyeZ - firstMiddle.z) < 0.01)
            throw Error("--eye-x", "must keep the eye from above the first mirror's middle, on which it looks",
                        eyeX.text());
    }

    Scene scene(const FrameInfo& frame) const override {
        static const MeshData floor = grid(1, 1, 10, 10), back = box({-1.5, -1.1, -0.1}, {1.5, 1.1, -0.03}),
                              sphereMesh = sphere(ballRadius, 64, 32), cube = box(vec3(-0.3), vec3(0.3)),
                              cone = lathe(std::array{vec2(0, 0), vec2(0.3, 0), vec2(0, 1)}, 64),
                              column = box({-0.25, 0, -0.25}, {0.25, 2.7, 0.25});
        Scene scene;
        scene.objects = {{"floor", floor, translate(0, 0, 0.5), {0.82, 0.80, 0.74}},
                         {"frame", back, translate(firstMiddle) * rotateY(turn), {0.45, 0.33, 0.22}},
                         {"ball", sphereMesh, translate(ball()), {0.20, 0.45, 0.80}},
                         {"cube", cube, translate(-1.1, 0.3, -0.9) * rotateY(30), {0.95, 0.65, 0.15}},
                         {"cone", cone, translate(0.75, 0, -0.9), {0.25, 0.60, 0.30}},
                         {"column", column, translate(0.9, 0, -2.9), {0.80, 0.20, 0.18}}};
        if (count == Count::two)
            scene.objects.push_back({"second frame", back, translate(secondMiddle) * rotateY(180), {0.35, 0.27, 0.20}});
        scene.lights = {{.position = vec4(3, 5, 2, 0)}};
        scene.viewFromWorld = lookAt(eye(), firstMiddle, vec3(0, 1, 0));
        // The world is in the left part of the picture; the plan is beside it.
        scene.clipFromView = translate(-0.3, 0, 0) * perspective(50, frame.aspect(), 0.1, 200);
        return scene;
    }

    // ---- what is told beside it

    void tell(const Frame& frame) {
        if (chains.empty()) work = {};
        passes = work.passes;
        drawn = work.drawn;
        leftOut = work.leftOut;
        const vec4 plane = mirrors().front().plane();
        distance = glm::dot(plane, vec4(eye(), 1));
        if (lightSide(vec4(eye(), 1), plane) <= 0)
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
        const vec3 imagedEye(reflection(view.before) * vec4(eye(), 1));
        const vec3 along = ballRadius * glm::normalize(ball() - imagedEye);
        const auto depthAt = [&](const vec3& point) {
            const vec4 clip = view.clipFromWorld * vec4(point, 1);
            return 0.5 * clip.z / clip.w;
        };
        return (depthAt(ball() + along) - depthAt(ball() - along)) * (std::exp2(24) - 1);
    }

    // Seen from above; x is to the right, and what is far is above.
    static Plot plan(const FrameInfo& frame) {
        const double height = std::min(0.94 * frame.height(), 0.5 * frame.width()), width = 0.66 * height;
        const vec2 high(frame.width() - 0.03 * height, frame.height() - 0.03 * height);
        return {{high - vec2(width, height), high}, {-3.1, 3.1}, {4.2, -5.2}};
    }

    static std::vector<vec2> ringRound(const vec2& middle, double radius) {
        std::vector<vec2> ring;
        ring.reserve(33);
        for (int i = 0; i <= 32; ++i) {
            const double angle = i * std::numbers::pi / 16;
            ring.push_back(middle + radius * vec2(std::cos(angle), std::sin(angle)));
        }
        return ring;
    }

    void annotate(const Frame& frame) override {
        drawing.begin(frame);
        const Plot plot = plan(frame);
        const int words = std::clamp(frame.height() / 38, 8, 16);
        const double meter = plot.pixel({1, 0}).x - plot.pixel({0, 0}).x;
        const auto at = [&](const vec3& p) { return plot.pixel({p.x, p.z}); };
        const auto label = [&](const vec2& where, const std::string& text, const vec4& color = ink) {
            drawing.textAround(where, text, {words, color, vec4(0)});
        };
        drawing.fill(plot.box, vec4(1, 1, 1, 0.88));

        // What stands there
        for (std::size_t i = ofBall.index; i < now.objects.size(); ++i) {
            if (i == ofSecondFrame.index) continue;
            const SceneObject& object = now.objects[i];
            drawing.point(at(vec3(object.worldFromObject[3])), 0.6 * meter, vec4(object.color, 1));
        }
        const auto all = mirrors();
        for (const Mirror& mirror : all)
            drawing.line(at(mirror.middle - mirror.halfU), at(mirror.middle + mirror.halfU), {ink, 3});
        label(at(all[0].middle - 0.7 * all[0].halfU) - vec2(0, -0.9 * words), "mirror");

        // Where the ball appears, and by which way its light comes
        const SeenMirror* first = nullptr;
        for (const auto& chain : chains) {
            if (chain[0].which == 0) first = &chain[0];
            for (const SeenMirror& mirror : chain) {
                const vec3 image(mirror.worldFromShown * vec4(ball(), 1));
                drawing.line(ringRound(at(image), 0.3 * meter), {blue, 1});
            }
        }
        if (first != nullptr) {
            const Mirror& mirror = all[0];
            const vec3 image(first->worldFromShown * vec4(ball(), 1));
            const double from = glm::dot(mirror.plane(), vec4(eye(), 1)), to = glm::dot(mirror.plane(), vec4(image, 1));
            const vec3 hit = glm::mix(eye(), image, from / (from - to));
            const vec3 inMirror = hit - mirror.middle;
            const double right = glm::dot(inMirror, mirror.halfU) / glm::dot(mirror.halfU, mirror.halfU);
            if (to < 0 && std::abs(right) < 1 && std::abs(inMirror.y) < halfV.y) {
                drawing.line(at(hit), at(image), {grey, 1});
                drawing.arrow(at(ball()), at(hit), {red, 1.5});
                drawing.arrow(at(hit), at(eye()), {red, 1.5});
            }
            label(at(image) + vec2(0, 0.3 * meter + 0.7 * words), "image of the ball", blue);
        }
        drawing.point(at(eye()), 10, red);
        label(at(eye()) + vec2(0, -1.1 * words), "eye", red);
        label(at(ball()) - vec2(0, 0.3 * meter + 0.7 * words), "ball", blue);
        drawing.draw(frame);
    }
};

const bool added = addDemo<MirrorDemo>({
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
});

}  // namespace
