// The settings of shadow-map: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "shadow-map.h"
#include "shared/orbit_rows.h"

namespace mv::shadow_map {

void check(const Settings& s) {
    if (s.light == s.target) throw Error("--light-x", "the light must not be at its target", numberText(s.light.x));
    if (s.frustum == Fit::fitted) (void)lightView(s, sceneOf(s, FrameInfo(1, 1, 1)));
}

namespace {

constexpr Declaration about{
    .name = "shadow-map",
    .sentence = "Shadows by a second depth buffer, drawn as the light sees the scene.",
    .lookFor =
        "The steps at the shadow's edge are the texels of the map in the corner, as large as they fall on the floor.",
    .chapter = "Shadows",
    .number = 12,
    .width = 600,
    .height = 600,
    .background = vec4(0, 0, 0, 1),
    .needs = {.depth = true,
              .beyondEs = {{"float targets", "falsely-dark, falsely-lit and pixels-asked are not measured"}}},
    .waste = {{"outside-view", "draw of 'cube'", "what is behind a projector goes into its map sooner than asked for"},
              {"outside-view", "draw of 'light'", "the light's ball is drawn sooner than asked for"},
              {"no-sample", "draw of 'light's frustum'", "from below the casters none of its edges is in the picture"},
              {"outside-view", "draw of 'ball'", "it hangs above the picture, and only its shadow is seen"},
              {"outside-view", "draw of 'cord #'", "it hangs above the picture, and only its shadow is seen"},
              {"no-sample", "draw of 'floor'",
               "the map's pass draws the whole scene, and culling leaves the floor out"}},
};

bool isOverhead(const Settings& s) { return s.scene == Which::overhead; }
bool hasBall(const Settings& s) { return s.scene == Which::sphereAndCube || s.scene == Which::overhead; }
bool isCone(const Settings& s) { return s.rays == Rays::spot && s.frustum == Fit::set; }
bool isSet(const Settings& s) { return s.frustum == Fit::set; }
bool hasTarget(const Settings& s) { return s.rays != Rays::spot || s.frustum == Fit::set; }

std::vector<Row<Settings>> panelRows() {
    const Literal fitted = "a fitted frustum has its own window", casts = "a fitted frustum looks at what casts";
    return together(
        word("scene", &Settings::scene,
             {{"sphere-and-cube"},
              {"cube-on-plane"},
              {"still-life"},
              {"overhead", "the shadows of a ball and three cords, which hang above the picture"}},
             "what is shown"),
        oneOf("sides", &Settings::sides, {4, 6, 8, 12, 16, 24, 32, 48, 64},
              "of the ball, round it; from pole to pole three quarters as many")
            .when(hasBall, "only sphere-and-cube and overhead have a ball"),
        number("cord", &Settings::cord, {0.001, 0.2, Scale::logarithmic}, "thickness of the cords")
            .when(isOverhead, "only overhead has cords"),
        oneOf("resolution", &Settings::resolution, {64, 128, 256, 512, 1024, 2048, 4096},
              "texels along a side of the map"),
        word("filter", &Settings::filter,
             {{"none", "one texel"},
              {"hardware", "four, weighted"},
              {"pcf3", "3 x 3 such looks"},
              {"pcf5", "5 x 5"},
              {"pcf7", "7 x 7"}},
             "how the map is looked up"),
        number("bias", &Settings::bias, {1e-4, 0.2, Scale::logarithmic, true},
               "how much deeper than the map (0..1) is not yet shadow"),
        number("slope-bias", &Settings::slopeBias, {0, 16}, "push the map back by its slope over this many texels"),
        word("map-faces", &Settings::mapFaces, {{"front"}, {"back"}, {"both"}},
             "faces in the map, as the light sees them"),
        toggle("receiver", &Settings::receiver, "floor and wall in the map, though they shade nothing"),
        toggle("keep", &Settings::keep, "keep the map while light and casters rest"),
        word("projection", &Settings::rays,
             {{"spot", "from a point, in a cone"}, {"orthographic", "parallel, as from infinity"}},
             "how the light shines"),
        word("frustum", &Settings::frustum, {{"set", "by fov and window"}, {"fitted", "round what casts; no cone"}},
             "what the map holds"),
        number("light-x", x(&Settings::light), {-10, 10}, "x of the light"),
        number("light-y", y(&Settings::light), {1, 20}, "y of the light"),
        number("light-z", z(&Settings::light), {-10, 20}, "z of the light"),
        number("target-x", x(&Settings::target), {-10, 10}, "x of the point that the light looks at")
            .when(hasTarget, casts),
        number("target-y", y(&Settings::target), {0, 20}, "y of the point that the light looks at")
            .when(hasTarget, casts),
        number("target-z", z(&Settings::target), {-10, 20}, "z of the point that the light looks at")
            .when(hasTarget, casts),
        number("fov", &Settings::fov, {1, 179}, "height of the spot's cone", "deg")
            .when(isCone, "only a spot's cone that is set has an angle"),
        number("window-width", &Settings::windowWidth, {0.1, 30, Scale::logarithmic},
               "of parallel light; by the height, the spot's aspect")
            .when(isSet, fitted),
        number("window-height", &Settings::windowHeight, {0.1, 30, Scale::logarithmic}, "of parallel light")
            .when(isSet, fitted),
        word("slide", &Settings::slide,
             {{"none"},
              {"thrown", "a picture in the light's window, as a projector throws it"},
              {"also-behind", "the same without asking whether w is above 0: a mistake"}},
             "whether the light is a slide projector"),
        toggle("show-map", &Settings::showMap, "show the map in a corner, near is dark"),
        toggle("rays", &Settings::showRays, "show the light's rays through the corners of cube or box"),
        toggle("show-frustum", &Settings::showFrustum, "show the edges of what the map holds"),
        part(&Settings::orbit, orbitRows({-4, 40})));
}

const Settings closeUp{.scene = Which::cubeOnPlane,
                       .resolution = 1024,
                       .bias = 0,
                       .light{-2.2, 3.6, 1.4},
                       .target{0, 0, 0},
                       .fov = 90,
                       .orbit = {.spinY = 300}};

const Settings projector{.scene = Which::stillLife,
                         .resolution = 1024,
                         .bias = 0,
                         .slopeBias = 2,
                         .light{-1.6, 2.2, 4.4},
                         .target{0.5, 0.9, -1.6},
                         .fov = 30,
                         .windowWidth = 3,
                         .windowHeight = 2.4,
                         .slide = Slide::thrown};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"original",
         "The steps at the shadow's edge are the texels of the map in the corner, as large as they fall on the "
         "floor."},
        {"acne", "Without a bias what is lit shades itself, in stripes.", closeUp},
        {"peter-panning", "Back faces in the map and too large a bias: the shadow begins a step away from the cube.",
         with(closeUp,
              [](Settings& s) {
                  s.bias = 0.01;
                  s.mapFaces = Faces::back;
              })},
        {"fitted",
         "The map holds just what casts, so that its texels are small; 3 x 3 looks make the edge a ramp.",
         {.scene = Which::stillLife,
          .resolution = 1024,
          .filter = Filter::pcf3,
          .bias = 0,
          .slopeBias = 4,
          .frustum = Fit::fitted}},
        {"sun",
         "Parallel light: the map holds a box, and only the backs of what casts.",
         {.bias = 0,
          .mapFaces = Faces::back,
          .receiver = false,
          .rays = Rays::orthographic,
          .windowWidth = 9,
          .windowHeight = 9}},
        {"slide-projector",
         "The matrix of the map looks points up in a picture instead: it lies over wall, floor and things, and the "
         "things cut it out of what is behind them.",
         projector},
        {"slide-behind",
         "Without the question whether w is above 0 the picture is behind the projector, too, upside down.",
         {.scene = Which::cubeOnPlane,
          .resolution = 1024,
          .bias = 0,
          .slopeBias = 2,
          .light{1.2, 1.1, 1.0},
          .target{3, 1, 0.6},
          .fov = 80,
          .windowWidth = 3,
          .windowHeight = 2.4,
          .slide = Slide::alsoBehind,
          .orbit = {.distance = 4}}},
        {"overhead",
         "A ball of six sides throws a polygon; cords thinner than a texel throw rows of dashes.",
         {.scene = Which::overhead, .sides = 6, .cord = 0.006}},
    };
}

std::optional<vec2> placeOf(const Settings& s, const FrameInfo& frame, const vec3& point) {
    return pictureFromPane({0, 0, frame.width(), frame.height()}, sceneOf(s, frame).clipFromWorld(), point);
}

const bool added = addLesson(
    about, Lesson<Settings, Gpu>{
               .rows = panelRows(),
               .presets = presets(),
               .controls = {orbitDrag, orbitWheel, keys(Key::left, Key::right, "light-x", 0.1),
                            keys(Key::up, Key::down, "light-z", 0.1)},
               .handles = {{"light",
                            {"light-x", "light-y", "light-z"},
                            [](const Settings& s, const FrameInfo& frame) { return placeOf(s, frame, s.light); }},
                           {"light's target",
                            {"target-x", "target-y", "target-z"},
                            [](const Settings& s, const FrameInfo& frame) { return placeOf(s, frame, s.target); }}},
               .draw = draw,
               .figure = drawFigure,
               .check = check,
               .scene = sceneOf,
           });

}  // namespace
}  // namespace mv::shadow_map
