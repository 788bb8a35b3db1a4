// ray-cast: a picture made of rays, one for each pixel, and how each of the lecture's objects meets one.
//
// Claims (each is a test in tests/claims/ray-cast.cpp):
// - [like-the-raster] Away from edges, which hold 5 % of the pixels at most, no pixel has another object or colour than GL's.
// - [through-the-middle] The ray of a pixel goes through its middle, and u, v, w are a right-handed frame.
// - [nearest-first] Candidates come in order of t, and the pixel has the colour of the first.
// - [three-planes] Implicit, by point and normal, and parametric: the plane's three forms give one picture.
// - [same-t-in-both-spaces] A ray taken to an object's space, not normalized anew, meets it at the t of the world.
// - [textbook-fails-far] In float the textbook's sphere is wrong in over a tenth of its pixels 1e4 away; the stable one in none.
// - [newton-needs-a-start] From one start Newton's method misses parts of the flag; from a grid of 12 by 12 a tenth of them
//   at most.
// - [raster-by-hand] The same triangles filled by the processor show, away from edges, what the rays see.
// - [threads-agree] The picture is the same, byte for byte, by any number of threads.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/gl/program.h"
#include "mv/gl/scene_meshes.h"
#include "mv/gl/text.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "mv/threads.h"
#include "shared/cast_objects.h"
#include "shared/cast_side.h"
#include "shared/depth_raster.h"
#include "shared/in_rows.h"
#include "shared/ray_structures.h"

using namespace mv;

namespace {

enum class Precision { single, twice };
enum class Maker { rays, raster, gl };

constexpr vec4 sky(0.85, 0.9, 0.95, 1);
const vec3 toLight = glm::normalize(vec3(0.5, 0.8, 0.35));
constexpr double opening = 0.53, opens = 9;  // the tangent of half the angle of view, and the distance where it is that

struct RayCast final : Demo {
    Choice<CastForm> form{this,
                          "form",
                          CastForm::stable,
                          {{"textbook", "as the slides print it"}, {"stable", "the library's"}},
                          "how rays and objects are intersected"};
    Choice<Precision> precision{
        this, "precision", Precision::twice, {{"float"}, {"double"}}, "in which it is computed"};
    Whole rows{this, "rows", 32, {16, 512}, "rows and columns of pixels"};
    WordChoice objects{this,
                       "objects",
                       0,
                       {{"all"},
                        {"plane"},
                        {"sphere"},
                        {"box", "by slabs"},
                        {"triangle"},
                        {"polygon", "a star"},
                        {"transformed", "a sphere under a matrix"},
                        {"surface", "a flag, by Newton's method"},
                        {"teapot", "triangles, in a tree"},
                        {"cylinder", "round an axis, with lids"},
                        {"cone", "with its base"},
                        {"disk", "a plane, and a distance"},
                        {"torus", "the first of four roots"}},
                       "what there is"};
    NumberChoice triangles{this,
                           "triangles",
                           4096,
                           {1024, 4096, 16384, 65536, 262144, 1048576},
                           "of the teapot, less those that have collapsed to an edge"};
    Choice<PlaneForm> plane{this,
                            "plane",
                            PlaneForm::implicit,
                            {{"implicit", "Ax + By + Cz + D = 0"},
                             {"normal", "a point and the normal"},
                             {"parametric", "a point and two vectors"}},
                            "how the floor is given"};
    Whole starts{this, "starts", 12, {1, 16}, "cells a side of the grid that Newton's method starts from"};
    Real distance{
        this, "distance", opens, {opens, 1e6, Scale::logarithmic}, "of the eye; the view is as much narrower"};
    Real size{this, "scale", 1, {1e-6, 1e6, Scale::logarithmic}, "of all, with the eye's distance"};
    Choice<Maker> by{this,
                     "picture-by",
                     Maker::rays,
                     {{"rays"}, {"raster", "triangles, filled by the processor"}, {"gl", "triangles, by OpenGL"}},
                     "who makes the left picture"};
    Whole threads{this, "threads", 2, {1, 16}, "that share the picture's rows"};
    Real pixelX{this, "pixel-x", 0.55, {0, 1}, "where the chosen pixel is, across"};
    Real pixelY{this, "pixel-y", 0.5, {0, 1}, "where the chosen pixel is, upwards"};

    Readout nearest{this, "t", "of the chosen pixel's ray, to the nearest object"};
    Readout candidatesMet{this, "candidates", "objects that the chosen pixel's ray meets"};
    Readout unlike{this, "unlike",
                   "pixels with another object than by the stable form in double, or a t off by 0.05 of the scale",
                   "px"};

    Program program;
    SceneMeshes meshes;
    Drawing drawing;
    MadeFor<std::string, CastForm, Precision, int, PlaneForm, int, double, double, int, int, Maker> pictureFor,
        unlikeFor;
    MadeFor<std::string, CastForm, Precision, int, PlaneForm, int, double, double, int, Maker> seenFor;
    std::vector<std::optional<CastCandidate>> seenNow;
    Picture picture;
    // The objects as triangles at scale 1, and the teapot's tree, when they are asked for
    mutable MadeFor<std::string, int> trianglesFor;
    mutable std::vector<SceneTriangle> madeTriangles;
    mutable std::unique_ptr<const TriangleFinder> madeTree;
    int differ = 0;

    RayCast() {
        bindHandle("pixel", {&pixelX, &pixelY}, [this](const FrameInfo& frame) -> std::optional<vec2> {
            const Pane pane = picturePane(frame);
            return vec2(pane.x, pane.y) + vec2(pixelX, pixelY) * double(pane.width);
        });
        triangles.onlyWhen([this] { return isThere(CastKind::teapot); }, "there is no teapot");
        form.onlyWhen([this] { return hasForms(); },
                      "triangles in a tree, and bodies round an axis, are met by the stable form");
        precision.onlyWhen([this] { return !isThere(CastKind::teapot); }, "triangles are met in double");
        plane.onlyWhen([this] { return isThere(CastKind::plane); }, "there is no plane");
        starts.onlyWhen([this] { return isThere(CastKind::surface) && form == CastForm::stable; },
                        "Newton's method has no grid here");
        threads.onlyWhen(haveThreads, "a page in a browser has one thread");
    }

    void init() override { program = Program("ray-cast"); }

    // ---- the rays

    CastEye eye() const {
        const vec3 w = glm::normalize(vec3(0.32, 0.42, 1)), u = glm::normalize(glm::cross(vec3(0, 1, 0), w));
        return {double(size) * (vec3(0, 0.2, 0) + double(distance) * w), u, glm::cross(w, u), w,
                opening * opens / distance};
    }
    // Through the middle of the pixel in column i and row j from the top.
    Ray rayOf(int i, int j, int side) const {
        const CastEye from = eye();
        const double alpha = from.half * (i + 0.5 - side / 2.0) / (side / 2.0);
        const double beta = from.half * (side / 2.0 - (j + 0.5)) / (side / 2.0);
        return {from.at, glm::normalize(alpha * from.u + beta * from.v - from.w)};
    }

    using Candidate = CastCandidate;
    // What the ray meets, nearest first.
    std::vector<Candidate> candidates(const std::vector<CastKind>& of, const Ray& ray, const CastWay& way,
                                      Precision in) const {
        const RayOf<float> rounded{fvec3(ray.origin), fvec3(ray.direction)};
        std::vector<Candidate> met;
        if (isThere(CastKind::teapot)) {
            const auto hit = madeTree->nearest({ray.origin / double(size), ray.direction / double(size)});
            if (hit) met.push_back({{hit->hit.t, normalOf(*hit->triangle)}, CastKind::teapot});
            return met;
        }
        for (const CastKind kind : of) {
            const auto hit = in == Precision::single ? castAt(kind, size, rounded, way) : castAt(kind, size, ray, way);
            if (hit) met.push_back({*hit, kind});
        }
        std::ranges::stable_sort(met, {}, [](const Candidate& one) { return one.hit.t; });
        return met;
    }
    // The first candidate of each pixel, the upper row first.
    using Seen = std::vector<std::optional<Candidate>>;
    Seen cast(int side, const CastWay& way, Precision in, int workers) const {
        Seen seen(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
        const std::vector<CastKind> of = shown();
        inRows(side, workers, [&](int j) {
            for (int i = 0; i < side; ++i) {
                const std::vector<Candidate> met = candidates(of, rayOf(i, j, side), way, in);
                if (!met.empty()) seen[pixelIndex(i, j, side)] = met.front();
            }
        });
        return seen;
    }
    CastWay way() const { return {form, plane, starts}; }

    // ---- the other way: not what a pixel's ray meets, but which pixels a triangle covers

    Seen raster(int side) const {
        const Scene through = view();
        const DepthRaster filled =
            rasterized(madeTriangles, through.clipFromWorld() * mv::scale(size, size, size), side, side);
        const mat4& p = through.clipFromView;
        Seen seen(filled.depth.size());
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                const std::size_t pixel = pixelIndex(i, j, side);
                if (filled.triangle[pixel] < 0) continue;
                const SceneTriangle& in = madeTriangles[static_cast<std::size_t>(filled.triangle[pixel])];
                // The division undone: the distance along -w, then along the ray
                const double before = p[3][2] / (filled.depth[pixel] + p[2][2]);
                const double t = before / -glm::dot(rayOf(i, j, side).direction, eye().w);
                seen[pixel] = Candidate{{t, normalOf(in)}, static_cast<CastKind>(in.object)};
            }
        }
        return seen;
    }
    static vec3 normalOf(const SceneTriangle& in) { return glm::cross(in.b - in.a, in.c - in.a); }
    Seen seenBy(Maker maker, int side, int workers) const {
        makeTriangles(maker);
        return maker == Maker::raster ? raster(side) : cast(side, way(), precision, workers);
    }
    // By the present settings, kept as long as they stay.
    const Seen& now() {
        if (seenFor.changed(objects.text(), form, precision, rows, plane, starts, distance, size, triangles, by))
            seenNow = seenBy(by, rows, threads);
        return seenNow;
    }
    void makeTriangles(Maker maker) const {
        if (trianglesFor.changed(objects.text(), triangles)) {
            madeTriangles.clear();
            madeTree.reset();
        }
        const bool isTeapot = isThere(CastKind::teapot);
        if (madeTriangles.empty() && (isTeapot || maker == Maker::raster))
            madeTriangles = castTriangles(shown(), static_cast<int>(std::lround(std::sqrt(triangles / 64.0))));
        if (!madeTree && isTeapot) madeTree = findTriangles(RayStructure::tree, madeTriangles);
    }

    // ---- the picture

    void draw(const Frame& frame) override {
        makeTriangles(by);
        const Scene scene = seen(frame);
        meshes.follow(scene);
        glEnable(GL_DEPTH_TEST);
        program.use();
        program.set("toLight", toLight);
        if (frame.measuring())
            return drawTriangles(scene, scene.clipFromWorld(), {0, 0, frame.width(), frame.height()}, true);
        const Pane left = picturePane(frame), right = sidePane(frame);
        drawTriangles(scene, fromSide(frame).clipFromWorld(), right);
        if (by == Maker::gl) drawTriangles(scene, scene.clipFromWorld(), left);
        glViewport(0, 0, frame.width(), frame.height());
        if (by != Maker::gl) showImage(frame, left.x, frame.height() - left.height, magnified(left.width));
        if (frame.readouts()) report(frame);
    }

    void drawTriangles(const Scene& scene, const mat4& clipFromWorld, const Pane& pane, bool isMeasured = false) const {
        glViewport(pane.x, pane.y, pane.width, pane.height);
        program.set("clipFromScene", clipFromWorld * mv::scale(size, size, size));  // all stand in the world already
        for (const auto& [object, mesh] : meshes.of(scene)) {
            program.set("color", object.color);
            if (isMeasured) program.set("id", numberOf(object.name));
            mesh.draw();
        }
    }

    // As the fragment shader has it: from either side.
    static vec3 shaded(const vec3& color, const vec3& normal) {
        return color * (0.35 + 0.65 * std::abs(glm::dot(glm::normalize(normal), toLight)));
    }

    const Picture& magnified(int width) {
        if (!pictureFor.changed(objects.text(), form, precision, rows, plane, starts, distance, size, triangles, width,
                                by))
            return picture;
        const Seen& seen = now();
        picture = Picture(width, width);
        const auto byte = [](double value) { return static_cast<std::uint8_t>(std::lround(255 * value)); };
        for (int y = 0; y < width; ++y) {
            for (int x = 0; x < width; ++x) {
                const auto& first = seen[pixelIndex(x * rows / width, y * rows / width, rows)];
                const vec3 color = first ? shaded(colorOf(first->kind), first->hit.normal) : vec3(sky);
                picture.set(x, y, {byte(color.x), byte(color.y), byte(color.z)});
            }
        }
        return picture;
    }

    // ---- what there is

    bool isThere(CastKind kind) const {
        const std::string which = objects.text();
        if (which == "all") return kind < CastKind::teapot;
        return which == castKindNames.at(static_cast<std::size_t>(kind));
    }
    std::vector<CastKind> shown() const {
        std::vector<CastKind> kinds;
        for (std::size_t i = 0; i < castKindNames.size(); ++i) {
            if (isThere(static_cast<CastKind>(i))) kinds.push_back(static_cast<CastKind>(i));
        }
        return kinds;
    }
    bool hasForms() const { return std::ranges::any_of(shown(), hasTextbookForm); }
    static vec3 colorOf(CastKind kind) { return castColors.at(static_cast<std::size_t>(kind)); }
    // 1 for a plane, and so on; 0 is the sky.
    static double numberOf(const std::string& name) {
        return double(std::ranges::find(castKindNames, name) - castKindNames.begin()) + 1;
    }

    // The same eye without objects, and with them as triangles.
    Scene view() const {
        Scene scene;
        const CastEye from = eye();
        scene.viewFromWorld = lookAt(from.at, from.at - from.w, vec3(0, 1, 0));
        scene.clipFromView =
            perspective(2 * degrees(std::atan(from.half)), 1, size * (distance - 7), size * (distance + 7));
        return scene;
    }
    Scene scene(const FrameInfo&) const override {
        Scene scene = view();
        for (const CastKind kind : shown()) {
            if (kind == CastKind::teapot)
                scene.objects.push_back(teapotMesh());
            else
                scene.objects.push_back(castMesh(kind, size));
        }
        return scene;
    }
    SceneObject teapotMesh() const {
        makeTriangles(by);
        MeshData mesh;
        for (const SceneTriangle& one : madeTriangles) {
            for (const vec3& corner : {one.a, one.b, one.c}) {
                mesh.positions.emplace_back(corner);
                mesh.normals.emplace_back(normalOf(one));
            }
        }
        return {.name = "teapot",
                .mesh = std::move(mesh),
                .worldFromObject = mv::scale(size, size, size),
                .color = colorOf(CastKind::teapot)};
    }

    // For the study: each pixel's t without the distance, in units of the scale; 10 for the sky.
    std::vector<double> values() const override {
        std::vector<double> ts;
        for (const auto& first : seenBy(by, rows, 1)) {
            ts.push_back(first ? first->hit.t / size - distance : 10);
        }
        return ts;
    }

    bool isUnlike(const std::optional<Candidate>& a, const std::optional<Candidate>& b) const {
        if (!a || !b) return a.has_value() != b.has_value();
        return a->kind != b->kind || std::abs(a->hit.t - b->hit.t) > 0.05 * size;
    }
    void report(const Frame& frame) {
        const std::vector<Candidate> met = chosen();
        candidatesMet = double(met.size());
        if (!met.empty()) nearest = met.front().hit.t;
        if (by == Maker::gl) return;
        if (unlikeFor.changed(objects.text(), form, precision, rows, plane, starts, distance, size, triangles, 0, by)) {
            const Seen right = cast(rows, {CastForm::stable, PlaneForm::implicit, 16}, Precision::twice, threads);
            differ = 0;
            for (std::size_t i = 0; i < right.size(); ++i) differ += isUnlike(now()[i], right[i]) ? 1 : 0;
        }
        unlike = differ;
        if (differ > 0)
            frame.say(std::to_string(differ) + " pixels have another object or t than by the stable form in double.");
    }

    // ---- the chosen pixel, and the scene from the side

    int column() const { return std::min(static_cast<int>(pixelX * rows), rows - 1); }
    int row() const { return std::min(static_cast<int>((1 - pixelY) * rows), rows - 1); }
    std::vector<Candidate> chosen() const {
        return candidates(shown(), rayOf(column(), row(), rows), way(), precision);
    }

    static Pane picturePane(const FrameInfo& frame) {
        const int side = std::max(1, std::min(frame.width() / 2, frame.height() * 8 / 9));
        return {0, 0, side, side};
    }
    static Pane sidePane(const FrameInfo& frame) {
        const int left = picturePane(frame).width + 4, low = frame.height() * 2 / 5;
        return {left, low, std::max(1, frame.width() - left), std::max(1, frame.height() - low)};
    }
    CastSide fromSide(const FrameInfo& frame) const { return {sidePane(frame), eye(), distance, size}; }

    void annotate(const Frame& frame) override {
        drawing.begin(frame);
        const int height = std::clamp(frame.height() / 34, 8, 24);
        const TextStyle words{height, castInk, vec4(0)};
        const Pane left = picturePane(frame);
        drawing.text({6, frame.height() - 2}, title(), words);
        drawing.text({6, frame.height() - 2 - 1.2 * height},
                     rounded("pixel (%.0f, ", column()) + rounded("%.0f), the ray through its middle", row()),
                     {height, castRed, vec4(0)});
        drawing.in(left);
        const double cell = double(left.width) / rows;
        const Plot plot{{vec2(0), vec2(left.width)}, {0, double(rows)}, {0, double(rows)}};
        if (cell >= 6) drawing.pixelGrid(plot, {vec4(0.1, 0.1, 0.1, 0.25), 1});
        const vec2 low = plot.pixel({column(), rows - 1 - row()}), high = low + vec2(cell);
        const std::vector<vec2> marked{low, {high.x, low.y}, high, {low.x, high.y}, low};
        drawing.line(marked, {vec4(1), 4});  // under the red, which a red object would hide
        drawing.line(marked, {castRed, 2});
        if (cell < 6) drawing.line(low + vec2(5 + cell, 5 + cell), low + vec2(24, 24), {castRed, 2});
        const Pane table{sidePane(frame).x, 0, sidePane(frame).width, std::max(1, sidePane(frame).y)};
        const std::vector<Candidate> met = chosen();
        fromSide(frame).draw(drawing, rayOf(column(), row(), rows), met, words);
        drawCandidates(drawing, table, met, shown(), words);
        drawing.draw(frame);
    }

    std::string title() const {
        if (by == Maker::gl) return "triangles, by OpenGL";
        const std::string cells = rows.text() + " x " + rows.text();
        if (by == Maker::raster) return "triangles filled into " + cells + " pixels";
        return cells + " rays, " +
               (isThere(CastKind::teapot) ? triangles.text() + " triangles"
                                          : (hasForms() ? form.text() : "stable") + ", in " + precision.text());
    }
};

constexpr Declaration declaration{
    .name = "ray-cast",
    .sentence = "A picture made of rays, one for each pixel, and from the side what the ray of one pixel meets.",
    .lookFor =
        "Drag the red pixel: its ray is shown from the side, with all that it meets in order; the nearest gives "
        "the colour.",
    .chapter = "Rays, clipping and pixels",
    .number = 22,
    .width = 960,
    .height = 540,
    .background = sky,
    .needs = {.depth = true, .beyondEs = {{"float targets", "the picture is not compared with GL's"}}},
    .presets =
        {
            {"one-ray-a-pixel", "Pixels large enough to count: each is the colour of the first object on its ray."},
            {"full", "The same with a ray for each pixel of the pane.", {{"rows", "480"}, {"threads", "2"}}},
            {"far-in-float",
             "The textbook's sphere in float, 3000 away: its discriminant has hardly a digit left.",
             {{"objects", "sphere"},
              {"form", "textbook"},
              {"precision", "float"},
              {"distance", "3000"},
              {"rows", "120"},
              {"pixel-x", "0.3"},
              {"pixel-y", "0.47"}}},
            {"far-and-stable",
             "The library's sphere, from as far and in float.",
             {{"objects", "sphere"},
              {"precision", "float"},
              {"distance", "3000"},
              {"rows", "120"},
              {"pixel-x", "0.3"},
              {"pixel-y", "0.47"}}},
            {"teapot",
             "Triangles: rays ask a tree, a raster fills one after the other.",
             {{"objects", "teapot"}, {"rows", "240"}}},
            {"one-start",
             "Newton's method from the flag's middle alone: it walks away from parts of it.",
             {{"objects", "surface"}, {"form", "textbook"}, {"rows", "120"}, {"pixel-x", "0.6"}, {"pixel-y", "0.7"}}},
        },
};

const bool added = addDemo<RayCast, declaration>();

}  // namespace
