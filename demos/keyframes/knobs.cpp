// The settings of keyframes: rows, presets, controls and declaration.
#include <glm/geometric.hpp>

#include "keyframes.h"
#include "mv/demo/lesson.h"

namespace mv::keyframes {
namespace {

constexpr WordList kindWords{{"linear", "straight from key to key"},
                             {"ease", "the same, but not evenly"},
                             {"lagrange", "one polynomial"},
                             {"natural", "cubic spline, without acceleration at its ends"},
                             {"clamped", "cubic spline with given velocities at its ends"},
                             {"periodic", "cubic spline that is closed"},
                             {"catmull-rom", "with uniform knots, the textbook's"},
                             {"centripetal", "Catmull-Rom, with the roots of the distances for knots"},
                             {"b-spline", "cubic, not through its keys"},
                             {"bezier", "one curve for all keys, not through them"}};
constexpr WordList easeWords{{"root", "at once, then slower"},
                             {"quadratic", "from rest, faster and faster"},
                             {"logistic", "from rest to rest"},
                             {"bezier", "by its handles"},
                             {"cubic", "a third power to the middle, and the same back"},
                             {"sine", "half a wave"},
                             {"back", "first back, and in the end beyond"},
                             {"elastic", "comes to rest as on a spring"},
                             {"bounce", "as a ball that falls"},
                             {"steps", "five jumps"}};
constexpr WordList spreadWords{{"even", "equally far apart"}, {"chebyshev", "denser to the ends"}};

bool isBall(const Settings& s) { return s.which == Which::ball; }
bool isRunge(const Settings& s) { return s.which == Which::runge; }
bool isCamera(const Settings& s) { return s.which == Which::camera; }
bool isFlight(const Settings& s) { return s.which == Which::flight; }

std::string textOf(const std::array<vec2, 2>& handles) {
    const auto text = [](const vec2& at) { return numberText(at.x) + "," + numberText(at.y); };
    return text(handles[0]) + "/" + text(handles[1]);
}

// What gives the curve its shape, by name and value.
std::pair<std::string, std::string> shapeOf(const KeyCurve& curve) {
    if (curve.isBezierEase()) return {"--handles", textOf(curve.handles)};
    return {"--ease", nameOf(curve.ease)};
}

void checkFlight(const Settings& s) {
    for (int i = 0; i <= 60 * int(lap); ++i) {
        const CameraAt camera = cameraAt(s, i / 60.0);
        const vec3 gaze = camera.center - camera.eye;
        const bool hasUp = glm::length(glm::cross(gaze, camera.up)) > 0.02 * glm::length(gaze) * glm::length(camera.up);
        if (glm::length(gaze) >= 0.5 && hasUp && camera.aspect >= 0.1 && camera.fovy >= 1 && camera.fovy <= 170)
            continue;
        const auto [name, value] = shapeOf(s.curve);
        throw Error(
            name,
            "must keep the camera off what it looks at, up off its gaze, its aspect 0.1 or more, and its angle of "
            "view in 1 .. 170",
            value);
    }
}

void check(const Settings& s) {
    if (isFlight(s)) return checkFlight(s);
    const KeyCurve& curve = s.curve;
    if (isRunge(s) && curve.kind == KeyCurve::Kind::periodic && s.nodes.function == FunctionNodes::Function::sine)
        throw Error("--curve periodic", "must have the same value at both ends, which sin 3x has not");
    if (!isCamera(s)) return;
    for (int i = 0; i <= 60 * int(lap); ++i) {
        const View view = viewAt(s.camera, curve, i / 60.0, s.camera.zoom);
        if (view.distance >= 1 && view.fovy >= 1 && view.fovy <= 170) continue;
        const auto [name, value] = shapeOf(curve);
        throw Error(name, "must keep the camera 1 m before its subject, and its angle of view in 1 .. 170", value);
    }
}

std::optional<vec2> placeOfKey(const Settings& s, const FrameInfo& frame, const vec2& key) {
    if (!isBall(s)) return std::nullopt;
    const Pane pane = leftPane(frame);
    return vec2(pane.x, pane.y) + pixelOf(pane, key);
}
std::optional<vec2> placeOfHandle(const Settings& s, const FrameInfo& frame, const vec2& handle) {
    if (!isBall(s) || !s.curve.isBezierEase()) return std::nullopt;
    return easePlot(frame).pixel(handle);
}

std::vector<Row<KeyCurve>> curveRows() {
    return {word("curve", &KeyCurve::kind, kindWords, "what goes through the keys, or near them"),
            word("ease", &KeyCurve::ease, easeWords, "how a part of the time becomes a part of the way")
                .when([](const KeyCurve& curve) { return curve.isEased(); }, "only --curve ease does not go evenly"),
            number("steepness", &KeyCurve::steepness, {1, 30}, "of the logistic ease")
                .when([](const KeyCurve& curve) { return curve.isLogistic(); }, "no logistic ease is used"),
            points("handles", &KeyCurve::handles,
                   {.low = vec2(0.05, -0.5), .high = vec2(0.95, 1.5), .least = 2, .most = 2, .grid = 0.05},
                   "the two of the Bezier ease, dragged in its graph")
                .when([](const KeyCurve& curve) { return curve.isBezierEase(); }, "no Bezier ease is used")};
}
std::vector<Row<FunctionNodes>> nodesRows() {
    return {word("function", &FunctionNodes::function, {{"runge", "1/(1 + 25 x^2)"}, {"sine", "sin 3x"}},
                 "what the nodes are of"),
            whole("nodes", &FunctionNodes::count, {5, 81}, "how many, from x = -1 to 1"),
            word("nodes-at", &FunctionNodes::spread, spreadWords, "where they are"),
            word("form", &FunctionNodes::form,
                 {{"barycentric"}, {"textbook", "a product for each node"}, {"float", "the textbook's, in float"}},
                 "how the polynomial through them is computed")};
}
std::vector<Row<DollyZoom>> cameraRows() {
    return {word("zoom", &DollyZoom::zoom,
                 {{"keys", "it has keys of its own"}, {"computed", "from the distance, for each picture"}},
                 "where the camera's angle of view comes from"),
            number("near", &DollyZoom::nearest, {2, 10}, "distance of the camera at its first and its last key", "m"),
            number("far", &DollyZoom::farthest, {10, 60}, "distance at the key between them", "m"),
            number("fovy", &DollyZoom::fovy, {20, 90}, "angle of view at the first key and the last", "deg")};
}

std::vector<Row<Settings>> panelRows() {
    return together(word("scene", &Settings::which,
                         {{"ball", "through keys that are dragged, a second from each to the next"},
                          {"runge", "one polynomial through nodes of a function, and the curve through them"},
                          {"camera", "that goes away from what it looks at and zooms in"},
                          {"flight", "a camera: its eye, center, up, aspect and fovy each have keys"}},
                         "what has keys"),
                    part(&Settings::curve, curveRows()),
                    points("points", &Settings::keys,
                           {.low = vec2(0, 0), .high = vec2(10, 10), .least = 2, .most = 16, .grid = 0.1},
                           "x,y of each key of the ball, dragged in the picture", "m")
                        .when(isBall, "only the ball has keys in a plane"),
                    part(&Settings::nodes, nodesRows(), isRunge, "only scene runge has nodes"),
                    part(&Settings::camera, cameraRows(), isCamera, "only scene camera has one"),
                    word("moves", &Settings::flight, {{"all"}, {"eye"}, {"center"}, {"up"}, {"aspect"}, {"fovy"}},
                         "what moves from key to key; the rest stays at its first")
                        .when(isFlight, "only the flight's camera has keys for all"));
}

constexpr Declaration about{
    .name = "keyframes",
    .sentence = "What moves between keys: straight, eased, by one polynomial, by splines.",
    .lookFor = "Straight from key to key the speed jumps; along a spline it does not; one polynomial swings.",
    .chapter = "Motion",
    .number = 34,
    .width = 960,
    .height = 560,
    .animated = true,
    .background = vec4(1, 1, 1, 1),
    .needs = {.depth = true},
    .waste = {{"unused-buffer", "depth of 'keyframes'", "the flight alone sees the street from all sides"}},
};

std::vector<SettingsPreset<Settings>> presets() {
    using Kind = KeyCurve::Kind;
    const KeyCurve natural{.kind = Kind::natural};
    return {
        {"straight", "The speed is constant from key to key, and jumps at each of them: red lines in the graph."},
        {"spline",
         "A cubic spline through the same keys: neither velocity nor acceleration jumps between its ends.",
         {.curve = natural}},
        {"eased",
         "Straight again, but slowly off and slowly on: drag the two red handles of the lower graph.",
         {.curve = {.kind = Kind::ease, .ease = KeyCurve::Ease::bezier}}},
        {"runge",
         "One polynomial through 21 even nodes is off by 60, the spline through them by less than 0.01.",
         {.which = Which::runge, .curve = natural},
         {{"polynomial-error", 59.5, 60.5}, {"curve-error", 0, 0.01}}},
        {"chebyshev",
         "The polynomial through as many nodes, denser to the ends, is off by 0.02.",
         {.which = Which::runge, .curve = natural, .nodes = {.spread = FunctionNodes::Spread::chebyshev}},
         {{"polynomial-error", 0.015, 0.025}}},
        {"dolly-zoom",
         "The camera goes away and zooms in: its subject stays as large, and the house behind it swells.",
         {.which = Which::camera, .curve = {.kind = Kind::clamped}, .camera = {.zoom = Zoom::computed}}},
        {"flight",
         "Eye, center, up, aspect and angle of view move, each along a spline of its own: turn them off but for one.",
         {.which = Which::flight, .curve = {.kind = Kind::periodic}}},
    };
}

const bool added = addLesson(
    about,
    Lesson<Settings, Gpu>{
        .rows = panelRows(),
        .presets = presets(),
        .handles = {{"key", {"points"}, {}, placeOfKey}, {"handle", {"handles"}, {}, placeOfHandle}},
        .readouts = {{"velocity-jump", "how far the velocity jumps at a key, at most; the ends aside", "m/s"},
                     {"acceleration-jump", "the same of the acceleration, of what is not straight", "m/s^2"},
                     {"end-jump", "with which speed it begins or ends, the larger one", "m/s"},
                     {"curve-length", "how long the way is, of what is not eased", "m"},
                     {"overshoot", "how far it leaves the rectangle of its keys, of 60 places a second", "m"},
                     {"off-polygon", "how far it leaves the straight lines from key to key, of the same places", "m"},
                     {"polynomial-error", "how far the polynomial is off, at most, at 1000 places"},
                     {"curve-error", "how far the curve is off, at the same places"},
                     {"subject-size", "height of the subject in the picture, part of the picture's"},
                     {"door-size", "the same of the door, 3 m high and 20 m behind the subject"}},
        .draw = draw,
        .readOut = readOut,
        .check = check,
        .values = values,
    });

}  // namespace

std::string nameOf(KeyCurve::Kind kind) { return wordOf(kindWords, kind); }
std::string nameOf(KeyCurve::Ease ease) { return wordOf(easeWords, ease); }
std::string nameOf(FunctionNodes::Spread spread) { return wordOf(spreadWords, spread); }

}  // namespace mv::keyframes
