// pipeline: one vertex of a cube on its way through model, world, camera, clip and device space to its pixel.
//
// Claims (each is a test in tests/claims/pipeline.cpp):
// - [same-as-gpu] The products shown are the GPU's: transform feedback gives the same, bit for bit on llvmpipe.
// - [within-the-bound] However a GPU adds up, it is within 4 2^-24 sum |m v|, though many of the last bits differ.
// - [marked-where-computed] GL marks the vertex at the pixel that the numbers say.
// - [w-is-the-distance] w is how far the vertex is in front of the eye; behind the eye it is negative.
// - [behind-is-mirrored] Behind the eye GL draws nothing; the division alone would show it, mirrored through the middle.
// - [depth-both-ranges] Device depth is from -1 at near to 1 at far, the depth that is stored from 0 to 1.
// - [rows-for-columns] A slide's matrix has the position in its last row: it moves row vectors, and distorts columns.
// - [slide-of-projection] A slide's projection has w < 0 for all that the camera sees, and nothing is left to draw.
// - [one-product-far-out] Far from the origin one product, multiplied in double and rounded once, keeps the picture.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/geometry/closest.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "mv/math/unproject.h"
#include "shared/gpu_product.h"
#include "shared/spin.h"

using namespace mv;

namespace {

enum class Products { shader, single, once };
enum class Matrices { right, slideModel, slideProjection };

const vec3 gaze = vec3(-3, -2, -6) / 7.0;  // unit length
constexpr double half = 0.6;               // of the cube's edge
constexpr int textColumn = 600;            // pixels on the right

// clip = clipFromCamera * camera, say.
struct Step {
    std::string to, from;
    mat4 uploaded;  // what the GPU is given, before it is rounded to float
    mat4 exact;
};

std::string matrixName(const Step& step) {
    return step.to + "From" + char(std::toupper(step.from[0])) + step.from.substr(1);
}

struct Pipeline final : Demo {
    Real distance{this, "distance", 3, {-3, 8}, "from the cube's middle back to the eye; below 0 the eye is past it"};
    Whole vertex{this, "vertex", 7, {0, 7}, "which corner: bits 0, 1, 2 choose the high end of x, y, z"};
    Spin spin{this, 20, -15};
    Real near{this, "near", 0.5, {0.1, 2}, "where the view begins"};
    Real far{this, "far", 10, {5, 100}, "where it ends"};
    Real offset{this,
                "offset",
                0,
                {1, 1e8, Scale::logarithmic, true},
                "how far along x cube and eye are from the origin of the world"};
    Choice<Products> products{this,
                              "products",
                              Products::shader,
                              {{"shader", "each vertex by three matrices"},
                               {"single", "by one, multiplied in float"},
                               {"once", "by one, multiplied in double and rounded once"}},
                              "how a vertex comes to clip space"};
    Choice<Matrices> matrices{this,
                              "matrices",
                              Matrices::right,
                              {{"right"},
                               {"slide-model", "the position in the last row"},
                               {"slide-projection", "for an eye that looks along +z"}},
                              "the right ones, or one of them as on a slide"};

    Readout w{this, "w", "of the vertex in clip space: how far it is in front of the eye"};
    Readout pixelX{this, "pixel-x", "where it falls in the view, from the left", "px"};
    Readout pixelY{this, "pixel-y", "where it falls in the view, from below", "px"};
    Readout depth{this, "depth", "what the depth buffer gets"};
    Readout floatError{this, "float-error", "how far off it falls by the roundings to float", "px"};
    Readout gpuOff{this, "gpu-off",
                   "largest difference of transform feedback from the products shown, in 2^-24 sum |m v|"};
    Readout fused{this, "fused-differ", "numbers in the products that fused multiply-adds would make others"};
    Readout roundedOnce{this, "once-differ", "numbers in them that sums in double, rounded once, would make others"};

    Readout backOff{this, "back-off", "how far from the vertex unProject comes out, by its pixel and its depth"};
    Readout depthStep{this, "depth-step", "what a step of a depth of 24 bits is there, back in the cube's space"};
    Readout rayMiss{this, "ray-miss", "by how much the ray through that pixel passes the vertex by"};

    Program byThree, byOne;
    Mesh cube, corners;
    Drawing drawing;

    Pipeline() {
        bindWheel(distance, 0.1);
        bindKeys(Key::left, Key::right, vertex, 1);
        bindKeys(Key::up, Key::down, distance, 0.1);
    }

    void init() override {
        MeshData faces = colorCube();  // of edge 1
        for (fvec3& position : faces.positions) position *= float(2 * half);
        cube = Mesh(faces, "cube");
        MeshData eight;
        eight.primitive = Primitive::points;
        for (int i = 0; i < 8; ++i) eight.positions.emplace_back(corner(i));
        eight.colors.assign(8, fvec4(0, 0, 0, 1));
        corners = Mesh(eight, "corners");
    }

    void draw(const Frame& frame) override {
        const Pane pane = viewIn(frame);
        glEnable(GL_SCISSOR_TEST);
        glScissor(pane.x, pane.y, pane.width, pane.height);
        glClearColor(0.92F, 0.95F, 0.98F, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glDisable(GL_SCISSOR_TEST);
        glViewport(pane.x, pane.y, pane.width, pane.height);
        glEnable(GL_DEPTH_TEST);
        if (!isEs()) glEnable(GL_PROGRAM_POINT_SIZE);  // where ES has no switch, and the shader's size always

        const std::vector<Step> way = steps(pane.aspect());
        const bool three = products == Products::shader;
        Program& program = three ? byThree : byOne;
        if (program.id() == 0) program = Program("pipeline", three ? "" : "once");
        program.use();
        for (const Step& step : way) {
            frame.show(matrixName(step), step.uploaded);
            program.set(matrixName(step).c_str(), step.uploaded);
        }
        if (frame.readouts()) measure(program, way);
        if (three) program.set("wanted", 2);
        cube.draw();
        glDepthFunc(GL_ALWAYS);  // the mark is seen through the cube
        corners.draw(std::size_t(vertex), 1);
    }

    // The view is on the left, the numbers on the right.
    static Pane viewIn(const FrameInfo& frame) {
        return {0, 0, std::max(std::max(1, frame.width() * 2 / 5), frame.width() - textColumn), frame.height()};
    }

    static vec3 corner(int i) { return half * (2.0 * vec3(i & 1, i >> 1 & 1, i >> 2 & 1) - 1.0); }

    // From the cube's own space into the world: turned, then moved.
    mat4 worldFromModel() const {
        const mat4 m = translate(offset + 0.2, 0.1, 0) * spin.turn();
        return matrices == Matrices::slideModel ? glm::transpose(m) : m;
    }
    // The eye looks along `gaze` wherever it is, so it can pass the cube.
    mat4 cameraFromWorld() const {
        const vec3 eye = vec3(offset, 0, 0) - gaze * double(distance);
        return lookAt(eye, eye + gaze, vec3(0, 1, 0));
    }
    // x and y scaled by the angle of view, z from near and far to -1 and 1 times w, and -z as w.
    mat4 clipFromCamera(double aspect) const {
        mat4 m = perspective(50, aspect, near, far);
        if (matrices == Matrices::slideProjection) {  // rows (0, 0, f/(f-n), n f/(n-f)) and (0, 0, 1, 0)
            m[2] = vec4(0, 0, far / (far - near), 1);
            m[3] = vec4(0, 0, near * far / (near - far), 0);
        }
        return m;
    }

    std::vector<Step> steps(double aspect) const {
        const mat4 m = worldFromModel(), v = cameraFromWorld(), p = clipFromCamera(aspect), all = p * v * m;
        if (products == Products::shader)
            return {{"world", "model", m, m}, {"camera", "world", v, v}, {"clip", "camera", p, p}};
        return {{"clip", "model", products == Products::once ? all : mat4(fmat4(p) * fmat4(v) * fmat4(m)), all}};
    }

    // Each product from what the GPU had before it, by transform feedback.
    void measure(const Program& program, const std::vector<Step>& way) {
        fvec4 before(corner(vertex), 1);
        double most = 0;
        int fusedCount = 0, onceCount = 0;
        for (std::size_t i = 0; i < way.size(); ++i) {
            if (products == Products::shader) program.set("wanted", int(i));
            const fvec4 captured = transformedPositions(corners)[std::size_t(vertex)];
            const fmat4 m(way[i].uploaded);
            const fvec4 mine = gpuProduct(m, before), other = fusedProduct(m, before);
            const fvec4 once(mat4(m) * vec4(before));
            const vec4 unit = productUnit(m, before);
            for (int row = 0; row < 4; ++row) {
                if (captured[row] != mine[row])
                    most = std::max(most, std::abs(double(captured[row]) - mine[row]) / unit[row]);
                fusedCount += other[row] == mine[row] ? 0 : 1;
                onceCount += once[row] == mine[row] ? 0 : 1;
            }
            before = captured;
        }
        gpuOff = most;
        fused = fusedCount;
        roundedOnce = onceCount;
    }

    // The numbers: the products as the GPU makes them, and by how much they differ from doubles all the way.
    void annotate(const Frame& frame) override {
        glViewport(0, 0, frame.width(), frame.height());
        const Pane pane = viewIn(frame);
        drawing.begin(frame);
        drawing.in(pane);
        TextColumn text(pane.width + 14, 6, 15);
        fvec4 value(corner(vertex), 1);
        vec4 exact(value);
        for (const Step& step : steps(pane.aspect())) {
            const fvec4 next = gpuProduct(fmat4(step.uploaded), value);
            const vec4 exactNext = step.exact * exact;
            heading(text, step.to + " = " + matrixName(step) + " * " + step.from);
            for (int row = 0; row < 4; ++row) {
                for (int column = 0; column < 4; ++column)
                    text.right(column < 3 ? 62 * (column + 1) : 292, tableNumber(step.uploaded[column][row]));
                result(text, (row == 0 ? "*  " : "") + tableNumber(value[row]), next[row], exactNext[row], row == 0);
            }
            value = next;
            exact = exactNext;
        }
        afterClip(frame, pane, text, vec4(value), exact);
        drawText(frame, text.lines);
        drawing.draw(frame);
    }

    // What GL does after the vertex shader: clip, divide by w, and go to the pixels of the view.
    void afterClip(const Frame& frame, const Pane& pane, TextColumn& text, const vec4& clip, const vec4& exact) {
        w = clip.w;
        const bool inside = std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)}) <= clip.w;
        const vec4 red(0.8, 0.1, 0.1, 1), green(0, 0.45, 0.1, 1);
        text.left(0,
                  inside       ? "-w <= x, y, z <= w: in view"
                  : clip.w < 0 ? "w < 0: clipped"
                               : "beyond -w .. w: clipped",
                  inside ? green : red);
        text.next();
        if (clip.w == 0 || exact.w == 0) return;
        const vec3 device = vec3(clip) / clip.w, exactDevice = vec3(exact) / exact.w;
        heading(text, "device = clip / w");
        for (int row = 0; row < 3; ++row)
            result(text, tableNumber(clip[row]) + " / " + tableNumber(clip.w), device[row], exactDevice[row], row == 0);
        heading(text, "pixel, depth = (device + 1) / 2 * size");
        const vec3 size(pane.width, pane.height, 1);
        const vec3 pixel = (device + 1.0) / 2.0 * size, exactPixel = (exactDevice + 1.0) / 2.0 * size;
        for (int row = 0; row < 3; ++row)
            result(text, "(" + tableNumber(device[row]) + " + 1) / 2 * " + tableNumber(size[row]), pixel[row],
                   exactPixel[row], row == 0);

        // The vertex by its name, where it is or where it would be without clipping
        const bool inPane = pixel.x >= 0 && pixel.x < pane.width && pixel.y >= 0 && pixel.y < pane.height;
        const int x = int(pixel.x), y = frame.height() - int(pixel.y);
        if (inside)
            text.lines.push_back({x + 8, y, "vertex " + vertex.text()});
        else if (clip.w < 0 && inPane)
            text.lines.push_back({x - 7, y - 11, "× divided by w < 0", {.color = red}});
        if (clip.w < 0) frame.say("The vertex has w < 0, and is clipped.");
        if (!inside) return;
        magnify(pane, vec2(pixel), vec2(exactPixel));
        pixelX = pixel.x;
        pixelY = pixel.y;
        depth = pixel.z;
        floatError = std::hypot(pixel.x - exactPixel.x, pixel.y - exactPixel.y);
        wayBack(pane, pixel);
    }

    // From the pixel to the point again, in the cube's own space, by the matrices as they are in double.
    void wayBack(const Pane& pane, const vec3& pixel) {
        mat4 clipFromModel(1);
        for (const Step& step : steps(pane.aspect())) clipFromModel = step.exact * clipFromModel;
        const auto pointAt = [&](double kept) {
            return unProject(vec2(pixel), kept, clipFromModel, pane.width, pane.height);
        };
        backOff = glm::distance(pointAt(pixel.z), corner(vertex));
        const double step = 1.0 / ((1 << 24) - 1);
        depthStep = glm::distance(pointAt(pixel.z), pointAt(pixel.z > 0.5 ? pixel.z - step : pixel.z + step));
        const vec3 along = directionThroughPixel(vec2(pixel), clipFromModel, pane.width, pane.height);
        const vec3 foot = closestOnLine(corner(vertex), pointAt(0), pointAt(0) + along);
        rayMiss = glm::distance(corner(vertex), foot);
    }

    // The pixels about the one that is marked, magnified: a dot where float puts the vertex, a cross where double does.
    void magnify(const Pane& pane, const vec2& pixel, const vec2& exact) {
        const int across = std::min(pane.width, pane.height) / 5;
        const vec2 low = glm::floor(pixel), size(across);
        const vec2 corner(8, pane.height - size.y - 8);
        const Plot magnified{{corner, corner + size}, {low.x - 3, low.x + 4}, {low.y - 3, low.y + 4}};
        const vec4 grey(0.6, 0.6, 0.6, 1), green(0, 0.45, 0.1, 1);
        drawing.fill(magnified.box, vec4(1));
        drawing.fill({magnified.pixel(low), magnified.pixel(low + 1.0)}, vec4(1, 0.85, 0.5, 1));
        drawing.pixelGrid(magnified, {.color = grey, .width = 1});
        for (const vec2& arm : {vec2(1, 0), vec2(0, 1)})
            drawing.curve(magnified, std::array{exact - arm, exact + arm}, {.color = green});
        drawing.curve(magnified, std::array{pixel, exact}, {.color = green});
        drawing.point(magnified.pixel(pixel), 7, vec4(0.1, 0.1, 0.1, 1));
    }

    static void heading(TextColumn& text, const std::string& formula) {
        text.next(6);
        text.left(0, formula, vec4(0.1, 0.25, 0.7, 1));
        text.right(574, "float - double", vec4(0.5, 0.5, 0.5, 1));
        text.next(21);
    }
    static void result(TextColumn& text, const std::string& from, double value, double exact, bool first) {
        text.right(392, from);
        text.right(500, (first ? "=  " : "") + tableNumber(value));
        text.right(574, value == exact ? "0" : rounded("%.2g", value - exact), vec4(0.5, 0.5, 0.5, 1));
        text.next();
    }

    // Where points of the cube fall, by each way of multiplying.
    static constexpr int side = 8, pictureSide = 560;
    static std::vector<vec3> points() {
        std::vector<vec3> all;
        all.reserve(side * side * side);
        for (int i = 0; i < side * side * side; ++i)
            all.push_back(half * (2.0 / (side - 1) * vec3(i % side, i / side % side, i / (side * side)) - 1.0));
        return all;
    }

    std::vector<double> values() const override {
        std::vector<fmat4> uploaded;
        for (const Step& step : steps(1)) uploaded.emplace_back(step.uploaded);
        std::vector<double> pixels;
        for (const vec3& point : points()) {
            fvec4 value(point, 1);
            for (const fmat4& m : uploaded) value = gpuProduct(m, value);
            const vec2 pixel = pixelFromNdc(ndcFromClip(vec4(value)), pictureSide, pictureSide);
            pixels.insert(pixels.end(), {pixel.x, pixel.y});
        }
        return pixels;
    }
};

constexpr Declaration declaration{
    .name = "pipeline",
    .sentence = "One vertex of a cube through model, world, camera, clip and device space to its pixel, in numbers.",
    .lookFor = "Follow one number from product to product; then move the eye past the vertex and watch w.",
    .chapter = "Viewing and projection",
    .number = 24,
    .width = 1160,
    .height = 560,
    .background = vec4(1),
    .needs = {.depth = true},
    .presets =
        {
            {"one-vertex", "Follow one number down from step to step; the last column is what float costs."},
            {"behind",
             "The marked corner is behind the eye, so w is negative: divided all the same, it falls on the red cross.",
             {{"distance", "0.2"}}},
            {"far-away",
             "Ten million from the origin floats are 1 apart, and three matrices in float tear the cube.",
             {{"offset", "1e+07"}}},
            {"once",
             "As far away, with one matrix multiplied in double: the cube is whole.",
             {{"offset", "1e+07"}, {"products", "once"}}},
            {"slide-model",
             "The position in the last row is right for row vectors: on columns it distorts.",
             {{"matrices", "slide-model"}}},
            {"slide-projection",
             "A projection for an eye that looks along +z: all of the cube has w below 0 and is clipped.",
             {{"matrices", "slide-projection"}}},
        },
    .waste = {{"no-sample", "draw of 'corners'", "corners that are clipped are the lesson"},
              {"outside-view", "draw of 'cube'", "what is clipped is the lesson"}},
};

const bool added = addDemo<Pipeline, declaration>();

}  // namespace
