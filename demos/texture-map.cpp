// texture-map: which point of a texture a pixel shows: parametrized surfaces, and what is interpolated between corners.
//
// Claims (each is a test in tests/claims/texture-map.cpp; X48, X49 and X51 in docs/stability.md are its extremes):
// - [slips] Interpolated along the picture, a texture slips by as much as the formula says, and correctly not at all.
// - [falls-with-the-square] The slip falls as 1/n^2 once a cell's w's are nearly alike, which takes the longer, the larger W.
// - [divide-at-the-end] u/w and v/w show the right point only when divided by 1/w.
// - [forward-leaves-holes] Texels drawn as points leave holes where they are larger than pixels, and meet where smaller.
// - [a-circle] The lecture's cylinder (cos u, h, sin u) is a circle, of no area.
// - [one-strip-runs-back] Where the corners of a seam are shared, one strip shows the whole texture backwards.
// - [half-at-the-pole] At a pole each cell of the texture is shown by a single triangle: half of it is lost.
// - [through-the-origin] A triangle's texture matrix has no inverse when its plane holds the origin; edges always work.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/file_knob.h"
#include "mv/demo/made_for.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/texture.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/perspective_quad.h"
#include "shared/triangle_map.h"

using namespace mv;

namespace {

enum class Shape { quad, cylinder, sphere, triangle };
enum class Method { affine, correct, byHand, undivided, forward };
enum class Formula { corrected, lecture };
enum class Seam { doubled, shared };
enum class Map { edges, matrix };

const vec4 red(0.85, 0.1, 0.1, 1), blue(0.1, 0.3, 0.75, 1), grey(0.45, 0.45, 0.45, 1), ink(0.1, 0.1, 0.1, 1);

struct TextureMapDemo final : Demo {
    Choice<Shape> shape{this,
                        "shape",
                        Shape::quad,
                        {{"quad", "a square in perspective"}, {"cylinder"}, {"sphere"}, {"triangle", "by its matrix"}},
                        "what has the texture"};
    Choice<Method> method{this,
                          "method",
                          Method::affine,
                          {{"affine", "u and v interpolated along the picture (noperspective)"},
                           {"correct", "u and v interpolated along the surface, by the driver"},
                           {"by-hand", "u/w, v/w and 1/w interpolated along the picture, and divided"},
                           {"undivided", "the same without the division, as on the slide"},
                           {"forward", "from the texture to the picture: each texel is drawn as a point"}},
                          "how a pixel finds its texture coordinates"};
    Whole divisions{this, "divisions", 2, {1, 64}, "cells along a side of the square, or a quarter of a turn"};
    Real ratio{this, "ratio", 4, {1, 20}, "W: the w of the far edge, by that of the near one"};
    NumberChoice texels{this, "texels", 128, {16, 32, 64, 128, 256, 512}, "texels along a side of the texture"};
    Choice<Formula> formula{this,
                            "formula",
                            Formula::corrected,
                            {{"corrected", "(cos u, v, sin u)"}, {"lecture", "(cos u, h, sin u)"}},
                            "of the cylinder"};
    Choice<Seam> seam{this,
                      "seam",
                      Seam::doubled,
                      {{"doubled", "corners with u = 1 beside those with u = 0"}, {"shared", "only those with u = 0"}},
                      "the corners where the texture's left and right edge meet"};
    Choice<Map> map{this,
                    "map",
                    Map::edges,
                    {{"edges", "from the way along the plane since a corner"},
                     {"matrix", "by the inverse of the 3 x 3 matrix of the lecture"}},
                    "from a point of the triangle to its texture coordinates"};
    Real distance{
        this, "distance", 0.5, {1e-8, 1, Scale::logarithmic, true}, "of the triangle's plane from the origin"};
    Angle turn{this, "turn", -60, "of the cylinder or the sphere about its axis"};
    PictureFile picture{this, "picture", "assets/postcard.png",
                        "your own on the surface, in at most 1024 x 1024 texels"};

    Readout slip{this, "slip", "how far from its place the affine method shows a point of the texture, at most", "px"};
    Readout determinant{this, "determinant", "of the lecture's matrix P"};
    Readout off{this, "off", "texture coordinates of the corners in floats, by the chosen map: the largest error"};

    OnDemand<Program> correct{"texture-map"}, affine{"texture-map", "affine"}, byHand{"texture-map", "by-hand"},
        byPoint{"texture-map", "point"};
    Mesh mesh;
    MadeFor<Shape, Method, int, int, Formula, Seam, double> meshFor;
    Texture image;
    MadeFor<int, int> imageFor;
    Drawing drawing;

    TextureMapDemo() {
        bindKeys(Key::down, Key::up, divisions, 1);
        bindKeys(Key::left, Key::right, turn, 5);
        bindHandle("far edge", {&ratio}, [this](const FrameInfo& frame) -> std::optional<vec2> {
            if (shape != Shape::quad) return {};
            return projected(pixelFromQuad(ratio, leftPane(frame)), {1, 1});
        });
        const auto isRound = [this] { return shape == Shape::cylinder || shape == Shape::sphere; };
        const auto isTriangle = [this] { return shape == Shape::triangle; };
        const auto isNoTriangle = [this] { return shape != Shape::triangle; };
        const auto hasFaces = [this] { return method != Method::forward || shape == Shape::triangle; };
        method.onlyWhen(isNoTriangle, "a triangle's texture coordinates are found from its points");
        divisions.onlyWhen(isNoTriangle, "a triangle is a single one");
        divisions.onlyWhen(hasFaces, "points have no faces to divide");
        ratio.onlyWhen([this] { return shape == Shape::quad; }, "only the square has it");
        formula.onlyWhen([this] { return shape == Shape::cylinder; }, "it is the cylinder's");
        seam.onlyWhen(isRound, "the shape has no seam");
        seam.onlyWhen(hasFaces, "points have no seam");
        const auto hasArea = [this] { return !isCircle(); };
        for (Knob* knob : std::vector<Knob*>{&divisions, &texels, &seam})
            knob->onlyWhen(hasArea, "the lecture's cylinder has no faces");
        texels.onlyWhen([this] { return !picture.isSet() || isForward(); }, "the picture has its own");
        map.onlyWhen(isTriangle, "it is the triangle's");
        distance.onlyWhen(isTriangle, "it is the triangle's");
        turn.onlyWhen(isRound, "the shape does not turn");
    }

    void init() override {}

    void check() const override {
        picture.check();
        if (shape == Shape::triangle && map == Map::matrix && distance == 0)
            throw Error("--distance",
                        "must not be 0 with --map matrix: P is singular where the plane holds the origin");
    }

    void draw(const Frame& frame) override {
        const Pane pane = frame.measuring() ? Pane{0, 0, frame.width(), frame.height()} : leftPane(frame);
        glViewport(pane.x, pane.y, pane.width, pane.height);
        if (isCircle()) return;  // it has no faces; annotate() draws it
        if (imageFor.changed(texels, picture.version())) {
            image =
                Texture(picture.isSet() ? shrink(picture.picture(), 1024, 1024) : chart(texels), GL_NEAREST, "chart");
        } else {
            image.bind(0);
        }
        if (meshFor.changed(shape, method, texels, divisions, formula, seam, distance)) {
            const MeshData made = isForward() ? texelPoints() : surfaceMesh();
            mesh = Mesh(shape == Shape::triangle ? withoutTexCoords(made) : made, "surface");
        }
        glEnable(GL_DEPTH_TEST);

        // What is interpolated between the corners
        const Program& program = shape == Shape::triangle   ? *byPoint
                                 : method == Method::affine ? *affine
                                 : isByHand()               ? *byHand
                                                            : *correct;
        program.use();
        program.set("clipFromModel", clipFromModel(pane));
        if (isByHand()) program.set("divided", method == Method::byHand);
        if (shape == Shape::triangle) setMap(program);
        if (frame.measuring()) {
            program.set("compared", shape == Shape::quad);
            program.set("pixelFromQuad", pixelFromQuad(ratio, pane));
            program.set("quadFromPixel", quadFromPixel(ratio, pane));
        }
        mesh.draw();
        if (shape == Shape::quad && !isForward()) slip = largestSlip(ratio, divisions, pane).pixels;
        if (shape == Shape::triangle) {
            determinant = glm::determinant(pointFromTexture(triangle()));
            off = errorInFloats(planeMap(), triangle());
        }
    }

    // ---- the surfaces: F(u, v) for u and v from 0 to 1

    vec3 surfacePoint(double u, double v) const {
        const double around = 2 * pi * u, height = 2;
        if (shape == Shape::quad) return {u, v, 0};
        if (shape == Shape::cylinder)
            return {std::cos(around), (formula == Formula::lecture ? 1 : v) * height, std::sin(around)};
        const double up = pi * (v - 0.5), out = std::cos(up);
        return {out * std::cos(around), std::sin(up), out * std::sin(around)};
    }

    // A grid of cells, two triangles each; at a pole, where one of them is a line, the other.
    MeshData surfaceMesh() const {
        if (shape == Shape::triangle) return triangleMesh();
        const int columns = shape == Shape::quad ? divisions : 4 * divisions;
        const int rows = shape == Shape::sphere ? 2 * divisions : int(divisions);
        MeshData made;
        for (int j = 0; j <= rows; ++j) {
            for (int i = 0; i <= columns; ++i) {
                const double u = double(i) / columns, v = double(j) / rows;
                made.positions.emplace_back(surfacePoint(u, v));
                made.texCoords.emplace_back(u, v);
            }
        }
        const bool sharesSeam = shape != Shape::quad && seam == Seam::shared;
        const auto corner = [&](int i, int j) {
            return static_cast<std::uint32_t>(j * (columns + 1) + (sharesSeam ? i % columns : i));
        };
        for (int j = 0; j < rows; ++j) {
            for (int i = 0; i < columns; ++i) {
                const auto a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
                if (shape != Shape::sphere || j > 0) made.indices.insert(made.indices.end(), {a, b, c});
                if (shape != Shape::sphere || j < rows - 1) made.indices.insert(made.indices.end(), {a, c, d});
            }
        }
        return made;
    }

    // The lecture's other order: not which texel a pixel shows, but which pixel a texel falls on.
    MeshData texelPoints() const {
        MeshData made{.primitive = Primitive::points};
        for (int j = 0; j < texels; ++j) {
            for (int i = 0; i < texels; ++i) {
                const double u = (i + 0.5) / texels, v = (j + 0.5) / texels;
                made.positions.emplace_back(surfacePoint(u, v));
                made.texCoords.emplace_back(u, v);
            }
        }
        return made;
    }
    bool isCircle() const { return shape == Shape::cylinder && formula == Formula::lecture && !isForward(); }
    bool isByHand() const {
        return shape != Shape::triangle && (method == Method::byHand || method == Method::undivided);
    }
    bool isForward() const { return shape != Shape::triangle && method == Method::forward; }

    // ---- the triangle: the map from its plane to the texture

    TexturedTriangle triangle() const {
        const mat4 tilt = rotateX(30) * rotateY(25);
        const auto at = [&](double x, double y) { return vec3(tilt * vec4(x, y, distance, 0)); };
        return {{at(-1.2, -1), at(1.2, -1), at(0, 1.2)}, {vec2(0.1, 0.1), vec2(0.9, 0.1), vec2(0.5, 0.9)}};
    }
    MeshData triangleMesh() const {
        MeshData made;
        const TexturedTriangle corners = triangle();
        for (std::size_t i = 0; i < 3; ++i) {
            made.positions.emplace_back(corners.points.at(i));
            made.texCoords.emplace_back(corners.texture.at(i));
        }
        return made;
    }
    PlaneMap planeMap() const { return map == Map::matrix ? mapByMatrix(triangle()) : mapByEdges(triangle()); }
    void setMap(const Program& program) const {
        const PlaneMap used = planeMap();
        program.set("textureFromPoint", used.linear);
        program.set("corner", used.corner);
        program.set("atCorner", used.atCorner);
    }

    // ---- camera and texture

    static Pane leftPane(const FrameInfo& frame) { return {0, 0, std::max(1, frame.width() * 5 / 8), frame.height()}; }
    mat4 clipFromModel(const Pane& pane) const {
        if (shape == Shape::quad) return clipFromQuad(ratio);
        const mat4 clipFromView = perspective(50, pane.aspect(), 0.1, 20);
        if (shape == Shape::triangle)  // whatever its distance from the origin, it looks the same
            return clipFromView * translate(0, 0, -3.2) * rotateY(30) * translate(0, 0, -distance) * rotateY(-25) *
                   rotateX(-30);
        const double middle = shape == Shape::cylinder ? -1 : 0;
        return clipFromView * lookAt(vec3(0, 1.8, 3.3), vec3(0), vec3(0, 1, 0)) * rotateY(turn) *
               translate(0, middle, 0);
    }

    // Eight by eight squares, blue at u = 0 and red at u = 1, dark at v = 0.
    static Picture chart(int side) {
        Picture picture(side, side);
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const double u = (x + 0.5) / side, v = 1 - (y + 0.5) / side;
                const bool isLight = (static_cast<int>(8 * u) + static_cast<int>(8 * v)) % 2 != 0;
                const vec3 hue = glm::mix(vec3(0.15, 0.35, 0.75), vec3(0.85, 0.3, 0.15), u);
                const vec3 color = 255.0 * (isLight ? glm::mix(hue, vec3(1), 0.92) : (0.45 + 0.55 * v) * hue);
                const auto byte = [](double value) { return static_cast<std::uint8_t>(std::lround(value)); };
                picture.set(x, y, {byte(color.x), byte(color.y), byte(color.z)});
            }
        }
        return picture;
    }

    // What has the texture, for those who count its triangles.
    Scene scene(const FrameInfo&) const override {
        Scene scene;
        scene.objects = {{.name = "surface", .mesh = isForward() ? texelPoints() : surfaceMesh()}};
        return scene;
    }

    // ---- beside it: where the lines of the texture belong, and how the slip falls

    void annotate(const Frame& frame) override {
        drawing.begin(frame);
        const Pane left = leftPane(frame);
        drawing.in(left);
        const int height = std::clamp(frame.height() / 30, 8, 18);
        const TextStyle words{.height = height};
        const std::string what = shape == Shape::triangle ? "triangle: texture coordinates by " + map.text()
                                                          : shape.text() + ": " + method.text();
        if (shape == Shape::quad) annotateQuad(frame, left, words);
        if (shape == Shape::cylinder || shape == Shape::sphere) annotateBody(left, words);
        drawing.in(left);
        drawing.text({8, left.height - 8}, what, words);
        drawing.in({0, 0, frame.width(), frame.height()});
        if (shape != Shape::quad || isForward()) drawFormulas(frame, words);
        glViewport(0, 0, frame.width(), frame.height());
        drawing.draw(frame);
    }

    void annotateQuad(const Frame& frame, const Pane& left, const TextStyle& words) {
        const mat3 pixels = pixelFromQuad(ratio, left);
        for (int i = 0; i <= 8; ++i) {
            drawing.line(projected(pixels, {i / 8.0, 0}), projected(pixels, {i / 8.0, 1}), {ink, 1});
            drawing.line(projected(pixels, {0, i / 8.0}), projected(pixels, {1, i / 8.0}), {ink, 1});
        }
        drawing.text({8, 1.5 * words.height + 4},
                     picture.isSet() ? "black lines: where eighths of the picture belong"
                                     : "black lines: where the squares belong",
                     words);
        const Slip most = largestSlip(ratio, divisions, left);
        if (method == Method::affine && most.pixels > 2) drawing.arrow(most.shown, most.right, {red, 3});

        if (isForward()) return;

        // The slip over the divisions
        drawing.in({0, 0, frame.width(), frame.height()});
        const vec2 size(frame.width(), frame.height());
        const Plot plot{{vec2(0.72, 0.2) * size, vec2(0.97, 0.86) * size},
                        {1, 64, "divisions a side", true},
                        {0.01, 1000, "largest slip, px", true}};
        drawing.axes(plot);
        std::vector<vec2> curve, square;
        for (int n = 1; n <= 64; ++n) {
            const double pixelsOff = largestSlip(ratio, n, left).pixels;
            if (pixelsOff > 0) curve.emplace_back(n, pixelsOff);
            if (pixelsOff > 0) square.emplace_back(n, largestSlip(ratio, 64, left).pixels * std::pow(64.0 / n, 2));
        }
        drawing.curve(plot, square, {grey, 1});
        drawing.curve(plot, curve, {blue, 2});
        if (most.pixels >= 0.01) drawing.point(plot.pixel({divisions, most.pixels}), 9, red);
        drawing.text({plot.box.low.x, plot.box.high.y + 3.2 * words.height},
                     rounded("affine, W = %.3g:", ratio) + rounded(" %.3g px", most.pixels),
                     {words.height, blue, vec4(0)});
        drawing.text(plot.pixel({8, 600}), curve.empty() ? "nothing slips" : "grey: as 1/n²",
                     {words.height, ink, vec4(0)});
    }

    void annotateBody(const Pane& left, const TextStyle& words) {
        const mat4 clip = clipFromModel(left);
        if (isCircle()) {
            for (int i = 0; i < 64; ++i)
                drawing.edge(clip, surfacePoint(i / 64.0, 1), surfacePoint((i + 1) / 64.0, 1), {blue, 2});
            return;
        }
        std::vector<vec3> line;
        for (int i = 0; i <= 32; ++i) line.push_back(1.004 * surfacePoint(0, i / 32.0));
        for (std::size_t i = 1; i < line.size(); ++i) drawing.edge(clip, line[i - 1], line[i], {red, 2});
        drawing.text(clip, surfacePoint(0, 0.6), {5 * words.height, 0}, "seam: u = 0 and 1", words);
        if (shape != Shape::sphere) return;
        drawing.point(clip, surfacePoint(0, 1), 8, red);
        drawing.text(clip, surfacePoint(0, 1), {10, 30}, "pole: every u", words);
    }

    void drawFormulas(const FrameInfo& frame, const TextStyle& words) {
        std::vector<std::string> lines;
        if (shape == Shape::quad) {
            lines = {"Each texel is drawn", "where it belongs:", "holes where texels are", "larger than pixels"};
        } else if (shape == Shape::cylinder) {
            lines = {"F(u, v) =", formula == Formula::lecture ? "(cos 2πu, h, sin 2πu)" : "(cos 2πu, h v, sin 2πu)",
                     formula == Formula::lecture ? "v is not in it: a circle" : ""};
        } else if (shape == Shape::sphere) {
            lines = {"F(u, v) =", "(cos a cos 2πu, sin a, cos a sin 2πu)", "a = π (v - 1/2)"};
        } else {
            lines = {map == Map::matrix ? "(u, v, 1) = P⁻¹ p" : "(u, v) = G (p - p₁) + t₁",
                     rounded("plane %.3g from the origin", distance),
                     rounded("det P = %.3g", glm::determinant(pointFromTexture(triangle()))),
                     rounded("corners off by %.2g", errorInFloats(planeMap(), triangle()))};
        }
        vec2 at(0.64 * frame.width(), 0.8 * frame.height());
        for (const std::string& line : lines) {
            if (!line.empty()) drawing.text(at, line, words);
            at.y -= 2.0 * words.height;
        }
    }
};

constexpr Declaration declaration{
    .name = "texture-map",
    .sentence =
        "Which point of a texture a pixel shows: on a square in perspective, a cylinder, a sphere and a triangle.",
    .lookFor =
        "The squares of the texture miss the black lines where they belong: the coordinates are interpolated along "
        "the picture.",
    .chapter = "Light, colour and texture",
    .number = 28,
    .width = 960,
    .height = 540,
    .background = vec4(0.76, 0.81, 0.87, 1),
    .needs = {.depth = true, .beyondEs = {{"float targets", "the slip is not measured, and holes are not counted"}}},
    .presets =
        {
            {"affine", "Along the picture: the texture breaks at each diagonal."},
            {"correct", "Along the surface: each square fills its place.", {{"method", "correct"}}},
            {"not-divided",
             "The slide's u/w without the division by 1/w: far away there is hardly any texture left.",
             {{"method", "undivided"}}},
            {"holes",
             "Each texel drawn as a point: near the eye there are gaps.",
             {{"method", "forward"}, {"texels", "256"}}},
            {"seam",
             "Shared corners: one strip shows the whole texture backwards.",
             {{"shape", "sphere"}, {"method", "correct"}, {"divisions", "4"}, {"seam", "shared"}}},
            {"near-the-origin",
             "The triangle's plane passes the origin at a millionth: the inverse of P has lost the floats' digits.",
             {{"shape", "triangle"}, {"map", "matrix"}, {"distance", "1e-06"}}},
        },
};

const bool added = addDemo<TextureMapDemo, declaration>();

}  // namespace
