// projections: one house in four panes: as in CAD, in the axonometric and the oblique views, and with vanishing points.
//
// Claims (each is a test in tests/claims/projections.cpp):
// - [views-line-up] In the CAD panes each corner is right below its place in the top view and level with it at the side.
// - [shortening-as-theory] The three axes are as short as the formulas say; in the isometric view sqrt(2/3), all of them.
// - [squares-sum-to-two] However an axonometric view is turned, the squares of the three shortenings add up to 2.
// - [only-face-on] Lengths and angles are kept on faces parallel to the picture and nowhere else (cavalier: depths, too).
// - [one-two-three] There are as many vanishing points as axes that are not parallel to the picture.
// - [lines-meet] Each edge of the walls, drawn longer, runs to the image of its direction, the point with w = 0.
// - [eye-on-the-horizon] What is as high as the eye is on the horizon, at any distance.
// - [far-eye-is-parallel] The farther the eye the nearer the perspective is to the parallel view: in proportion 1/distance.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/geometry/edges.h"
#include "mv/gl/gl.h"
#include "mv/math/depth_range.h"
#include "mv/math/projection.h"
#include "mv/math/shear.h"
#include "mv/math/transform.h"
#include "shared/scenes.h"
#include "shared/vanishing.h"

using namespace mv;

namespace {

enum class Show { cad, axonometric, oblique, vanishing };

const vec3 middle(1.5, 3, 0);  // of the house; all of it lies within `reach` of this point
constexpr double reach = 8;
const vec3 wallsLow(-4, 0, -3), wallsHigh(4, 3, 3);                                     // up to the eaves
constexpr double isometricTilt = 35.264389682754654;                                    // atan(1/sqrt(2))
constexpr double dimetricTurn = 20.704811054635432, dimetricTilt = 19.471220634490692;  // x : y : z = 1 : 1 : 1/2
const vec4 axisColors[] = {{0.80, 0.10, 0.10, 1}, {0.05, 0.50, 0.10, 1}, {0.10, 0.25, 0.90, 1}};
const std::string axisNames[] = {"x", "y", "z"};

// What a pane shows, of a world of metres. `half` is how many of them from its middle to its upper edge.
struct View {
    std::string name;
    mat4 viewFromWorld;
    double half;
    vec3 shortening{0};   // of x, y and z by the formulas, in a parallel view
    double distance = 0;  // of the eye from the middle, in a perspective; a parallel view has 0
    double shift = 0;     // of a perspective's window, upwards, in its half heights
    mat4 clipFromWorld(double aspect) const { return clipFromView(aspect) * viewFromWorld; }
    mat4 clipFromView(double aspect) const {
        if (distance == 0) return ortho(-half * aspect, half * aspect, -half, half, -2 * reach, 2 * reach);
        const double near = distance - reach;
        if (shift == 0) return infinitePerspective(2 * degrees(std::atan(half / distance)), aspect, near);
        const double top = near * half / distance;
        return infiniteFrustum(-top * aspect, top * aspect, top * (shift - 1), top * (shift + 1), near);
    }
};

mat4 turned(double turn, double tilt) { return rotateX(tilt) * rotateY(-turn) * translate(-middle); }

// An axonometric view: the lines of sight are perpendicular to the picture, the house is turned before it.
View axonometric(const std::string& name, double turn, double tilt, double half) {
    const double c = std::cos(radians(turn)), s = std::sin(radians(turn)), up = std::sin(radians(tilt));
    return {name, turned(turn, tilt), half, {std::hypot(c, s * up), std::cos(radians(tilt)), std::hypot(s, c * up)}};
}

// An oblique view: a side of the house is parallel to the picture, and what lies one metre behind it is drawn `length`
// metres further in the direction `angle`.
View oblique(const std::string& name, double angle, double length, double half) {
    const mat4 shear = shearZ(-length * std::cos(radians(angle)), -length * std::sin(radians(angle)));
    return {name, shear * turned(0, 0), half, {1, 1, length}};
}

View perspective(const std::string& name, const mat4& turnedFromWorld, double distance, double half, double shift = 0) {
    return {name, translate(0, 0, -distance) * turnedFromWorld, half, vec3(0), distance, shift};
}

// Corner i of the walls: bits 0, 1, 2 of i choose the high end of x, y, z.
vec3 wallCorner(int i) {
    vec3 corner = wallsLow;
    for (int axis = 0; axis < 3; ++axis) {
        if ((i >> axis & 1) != 0) corner[axis] = wallsHigh[axis];
    }
    return corner;
}

struct Projections final : Demo {
    Choice<Show> show{this,
                      "show",
                      Show::cad,
                      {{"cad", "top, perspective, front and side"},
                       {"axonometric", "isometric, dimetric, trimetric and yours"},
                       {"oblique", "cavalier, cabinet, planometric and yours"},
                       {"vanishing", "one, two, three vanishing points and yours"}},
                      "which four views"};
    Angle turn{this, "turn", 30, "yours: how far the eye goes round, to the right"};
    Real tilt{this, "tilt", 20, {-90, 90}, "yours: how far the eye goes up from there", "deg"};
    Real distance{
        this, "distance", 14, {9, 1000, Scale::logarithmic}, "yours, a perspective: from the eye to the house", "m"};
    Real angle{this, "angle", 30, {-180, 180}, "yours, oblique: where depth is drawn to, from the horizontal", "deg"};
    Real length{this, "length", 0.75, {0, 2}, "yours, oblique: how long a metre of depth is drawn", "m"};

    Real shift{this, "shift", 0, {-1, 1}, "yours, a perspective: how far its window is moved up, in its half heights"};

    Readout shortX{this, "shortening-x", "in your parallel view: how long a metre along x is drawn", "m"};
    Readout shortY{this, "shortening-y", "the same along y", "m"};
    Readout shortZ{this, "shortening-z", "the same along z", "m"};
    Readout off{this, "shortening-error", "largest difference from the formulas in the parallel views", "m"};
    Readout points{this, "vanishing-points", "how many your perspective has"};
    Readout miss{this, "meeting-error", "by how much an edge that is drawn longer misses its vanishing point, at most",
                 "px"};

    Program faces, lines;
    Mesh house, edges, rays, horizon;
    Drawing drawing;

    Projections() {
        bindDrag(turn, -0.5, tilt, 0.5);
        const auto oblique = [this] { return show == Show::oblique; };
        const auto turns = [this] { return show != Show::oblique; };
        turn.onlyWhen(turns, "an oblique view has its front to the picture");
        tilt.onlyWhen(turns, "an oblique view has its front to the picture");
        for (Knob* knob : std::vector<Knob*>{&distance, &shift}) {
            knob->onlyWhen([this] { return show == Show::cad || show == Show::vanishing; },
                           "there is no perspective among these views");
        }
        angle.onlyWhen(oblique, "there is no oblique view among these");
        length.onlyWhen(oblique, "there is no oblique view among these");
    }

    void init() override {
        faces = Program("projections");
        lines = Program("projections", "lines");
        const MeshData body = meshOf(mv::house());
        house = Mesh(body, "house");
        edges = Mesh(edgesOf(body), "edges");
        std::array<vec3, 8> corners;
        for (int i = 0; i < 8; ++i) corners[std::size_t(i)] = wallCorner(i);
        rays = Mesh(linesToInfinity(corners), "rays");
        horizon = Mesh(horizonLines(), "horizon");
    }

    void draw(const Frame& frame) override {
        glClearColor(1, 1, 1, 1);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LEQUAL);
        glEnable(GL_CULL_FACE);
        glEnable(GL_POLYGON_OFFSET_FILL);  // faces give way to their edges
        glPolygonOffset(1, 1);
        glEnable(GL_SCISSOR_TEST);

        const std::vector<Pane> panes = frame.panes(4);
        const std::array<View, 4> four = views();
        drawing.begin(frame);
        off.clear();
        miss.clear();
        for (std::size_t i = 0; i < 4; ++i) {
            // The viewport takes clip space to the pane; the scissor keeps glClear in it
            const Pane& pane = panes[i];
            glViewport(pane.x, pane.y, pane.width, pane.height);
            glScissor(pane.x, pane.y, pane.width, pane.height);
            glClear(GL_COLOR_BUFFER_BIT);

            const mat4 clipFromWorld = four[i].clipFromWorld(pane.aspect());
            frame.show(four[i].name + "FromWorld", clipFromWorld);
            faces.use();
            faces.set("clipFromWorld", clipFromWorld);
            house.draw();
            lines.use();
            lines.set("clipFromWorld", clipFromWorld);
            const bool colored = i > 0 && four[i - 1].distance == 0;  // and no line to infinity has changed it
            if (!colored) lines.set("color", vec4(0.1, 0.1, 0.1, 1));
            edges.draw();

            drawing.in(pane);
            drawing.text({6, pane.height - 6}, four[i].name);
            if (four[i].distance == 0)
                measureAxes(four[i], clipFromWorld, pane);
            else
                drawToInfinity(four[i], clipFromWorld, pane);
        }
        glDisable(GL_SCISSOR_TEST);
        glViewport(0, 0, frame.width(), frame.height());
        drawing.draw(frame);
    }

    std::array<View, 4> views() const {
        const mat4 yours = turned(turn, tilt);
        switch (show) {
            case Show::axonometric:
                return {axonometric("isometric", 45, isometricTilt, 7.2),
                        axonometric("dimetric", dimetricTurn, dimetricTilt, 7.2), axonometric("trimetric", 60, 15, 7.2),
                        axonometric("yours", turn, tilt, 7.2)};
            case Show::oblique: {
                View planometric = oblique("planometric", -90, 1, 8.5);
                planometric.viewFromWorld =
                    planometric.viewFromWorld * translate(middle) * rotateX(90) * rotateY(-45) * translate(-middle);
                return {oblique("cavalier", 45, 1, 8), oblique("cabinet", 45, 0.5, 8), planometric,
                        oblique("yours", angle, length, 8)};
            }
            case Show::vanishing:
                return {perspective("one-point", translate(-5.5, -4, 0) * turned(0, 0), 16, 12),
                        perspective("two-point", translate(0, -1, 0) * turned(42, 0), 11, 11),
                        perspective("three-point", turned(42, 42), 11, 14.5),
                        perspective("yours", yours, distance, 13, shift)};
            case Show::cad:
                break;
        }
        return {axonometric("top", 0, 90, 6), perspective("perspective", yours, distance, 6, shift),
                axonometric("front", 0, 0, 6), axonometric("side", 90, 0, 6)};
    }

    // Columns 0 to 2 of the matrix are where it takes the directions of the axes, (1, 0, 0, 0) and so on. In a parallel
    // view their w is 0, and x and y say which way and how far one metre goes in the picture.
    void measureAxes(const View& view, const mat4& clipFromWorld, const Pane& pane) {
        const double metre = pane.height / (2 * view.half);  // px
        const vec2 corner = pixelFromNdc(ndcFromClip(clipFromWorld * vec4(wallCorner(4), 1)), pane.width, pane.height);
        vec3 measured;
        int x = 6;
        for (int axis = 0; axis < 3; ++axis) {
            const vec4 image = clipFromWorld[axis];
            const vec2 drawn = vec2(image) * vec2(pane.width, pane.height) / 2.0;  // px
            measured[axis] = std::hypot(drawn.x, drawn.y) / metre;
            raise(off, std::abs(measured[axis] - view.shortening[axis]));
            const std::string text = axisNames[axis] + rounded(" %.3f", measured[axis]);
            drawing.text({x, pane.height - 26}, text, {.color = axisColors[axis]});
            x += textWidth(text) + 4;
            if (measured[axis] < 1e-9) continue;  // seen end on
            drawing.arrow(corner, corner + 2.0 * drawn, {.color = axisColors[axis], .width = 2});
            const vec2 beyond = drawn * (10 / std::hypot(drawn.x, drawn.y));
            drawing.textAround(corner + 2.0 * drawn + beyond, axisNames[axis],
                               {.height = 13, .color = axisColors[axis]});
        }
        if (view.name != "yours") return;
        shortX = measured.x;
        shortY = measured.y;
        shortZ = measured.z;
    }

    // In a perspective w is not 0, unless the axis is parallel to the picture: then the column is a point of the
    // picture, the vanishing point of all lines along the axis.
    void drawToInfinity(const View& view, const mat4& clipFromWorld, const Pane& pane) {
        vec3 side(1);  // (-1, 0, 0, 0) has the same image, and is in front of the eye where (1, 0, 0, 0) is not
        for (int axis = 0; axis < 3; ++axis) side[axis] = clipFromWorld[axis].w < 0 ? -1 : 1;
        lines.set("side", side);
        lines.set("color", vec4(0.6, 0.6, 0.6, 1));
        horizon.draw();
        int count = 0;
        double most = 0;
        for (int axis = 0; axis < 3; ++axis) {
            vec3 direction(0);
            direction[axis] = 1;
            const auto point = vanishingPoint(clipFromWorld, direction, pane.width, pane.height);
            if (!point) continue;
            ++count;
            for (int i = 0; i < 8; ++i) {
                const std::array<vec3, 2> edge{wallCorner(i), wallCorner(i ^ 1 << axis)};
                most = std::max(most, missOfVanishingPoint(*point, edge, clipFromWorld, pane.width, pane.height));
            }
            lines.set("color", axisColors[axis]);
            rays.draw(16 * std::size_t(axis), 16);
            drawing.point(*point, 7, axisColors[axis]);
            if (std::min(point->x, point->y) >= 0 && point->x < pane.width - 18 && point->y < pane.height - 28)
                drawing.text(*point + vec2(6, 26), axisNames[axis], {.color = axisColors[axis]});
        }
        raise(miss, most);
        drawing.text({6, 28}, std::to_string(count) + (count == 1 ? " vanishing point" : " vanishing points") +
                                  rounded(", met within %.0e px", most));
        if (view.name == "yours" || view.name == "perspective") points = count;
    }

    static void raise(Readout& readout, double value) { readout = std::max(readout.value().value_or(0), value); }
};

constexpr Declaration declaration{
    .name = "projections",
    .sentence = "One house in four views at once: orthographic, axonometric, oblique, and with vanishing points.",
    .lookFor = "Which lengths and angles a view keeps; and in the perspectives, where parallel edges would meet.",
    .chapter = "Viewing and projection",
    .number = 4,
    .width = 960,
    .height = 720,
    .background = vec4(0.5, 0.5, 0.5, 1),
    .needs = {.depth = true},
    .presets =
        {
            {"cad",
             "Top stands over front and side beside it, each to be measured with a ruler; only the perspective looks "
             "like a house."},
            {"axonometric",
             "All three axes are seen, each shortened: all alike in the isometric view, two alike in the dimetric one.",
             {{"show", "axonometric"}}},
            {"oblique",
             "All three keep a side as it is. Cavalier keeps the depth, too, and looks too deep; cabinet halves it.",
             {{"show", "oblique"}}},
            {"vanishing",
             "Parallel edges that are not parallel to the picture meet, in one, two or three points.",
             {{"show", "vanishing"}}},
            {"level",
             "Your perspective, looking level, has 2 vanishing points: the walls stay upright.",
             {{"show", "vanishing"}, {"tilt", "0"}},
             {{"vanishing-points", 2, 2}}},
            {"from-afar",
             "From 1000 m the perspective is nearly the parallel view of the same turn.",
             {{"show", "vanishing"}, {"distance", "1000"}}},
        },
    .waste = {{"unused-object", "mesh 'horizon'", "made once, for the settings that show it"},
              {"unused-object", "mesh 'rays'", "made once, for the settings that show them"},
              {"no-sample", "draw of 'horizon'",
               "from afar it lies beyond the far plane's edge, as a line that no pixel has"}},
};

const bool added = addDemo<Projections, declaration>();

}  // namespace
