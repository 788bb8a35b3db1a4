// The settings of stereocube: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "mv/geometry/in_view.h"
#include "stereocube.h"

namespace mv::stereocube {

void check(const Settings& s) {
    if (s.shape == Shape::hypercube && leastDivisor(s.four) < 0.1)
        throw Error("--inner", "must be more: turned so, a corner is as near as the eye in the fourth dimension",
                    numberText(s.four.inner));
    const Lens square{50, 1};
    for (const Eye& eye : {leftEye(s, square), rightEye(s, square)}) {
        const bool isClosed = s.eyes != eye.which && (s.eyes == Eyes::left || s.eyes == Eyes::right);
        if (!isClosed && isInView(wireOf(s), eye.clipFromEye * eye.eyeFromWorld * worldFromModelOf(s))) return;
    }
    throw Error("--z-dist", "must leave some of the cube in view of an eye", numberText(s.zDist));
}

namespace {

bool isHypercube(const Settings& s) { return s.shape == Shape::hypercube; }
bool hasOnePicture(const Settings& s) { return !isBeside(s); }
bool isWire(const Settings& s) { return !isShaded(s); }
bool mixes(const Settings& s) { return isShaded(s) && !isBeside(s); }

constexpr Declaration about{
    .name = "stereocube",
    .sentence = "Stereo with coloured glasses: two eyes, two pictures, one in red and one in cyan.",
    .lookFor = "With red glass left and cyan glass right the cube stands in the depth; without, a red and a cyan cube.",
    .chapter = "Stereo and hidden surfaces",
    .number = 6,
    .width = 600,
    .height = 600,
    .needs = {.depth = true},
    .waste = {{"repeated-pass", "pass into 'left eye'", "what two pictures cost in every frame is the lesson"},
              {"repeated-pass", "pass into 'right eye'", "what two pictures cost in every frame is the lesson"},
              {"unused-buffer", "depth of 'stereocube'", "a still life has depths in each eye's own picture"}},
};

std::vector<Row<Hypercube>> hypercubeRows() {
    return {angle("turn-xy", &Hypercube::xy, "turn in the plane of x and y"),
            angle("turn-xw", &Hypercube::xw, "turn in the plane of x and w, the fourth coordinate"),
            angle("turn-yw", &Hypercube::yw, "the same of y and w"),
            angle("turn-zw", &Hypercube::zw, "the same of z and w"),
            number("inner", &Hypercube::inner, {0.05, 1},
                   "side of the farthest cell where the nearest has 1; at 1 nothing grows smaller along w")};
}

std::vector<Row<Settings>> panelRows() {
    const Literal apart = "each eye has a picture of its own", solid = "the still life has surfaces, and no lines";
    return together(
        number("eye-sep", &Settings::eyeSep, {0, 1}, "distance between the eyes"),
        number("z-dist", &Settings::zDist, {-10, 2}, "z of the eyes, which look along +z"),
        number("convergence", &Settings::convergence, {0.25, 10}, "how far ahead of the eyes the screen is"),
        angle("spin-x", &Settings::spinX, "turn about the x axis"),
        angle("spin-y", &Settings::spinY, "turn about the y axis"),
        word("stereo", &Settings::stereo,
             {{"toe-in", "both eyes look at one point"}, {"off-axis", "parallel, through one window"}},
             "how the two eyes are aimed"),
        word("colors", &Settings::colors,
             {{"lines", "lines in red and in cyan"}, {"masks", "the red channel, then green and blue"}},
             "how the two pictures of lines become one")
            .when(hasOnePicture, apart)
            .when(isWire, solid),
        oneOf("line-width", &Settings::lineWidth, {1, 3, 5},
              "how many pixels wide the lines are, more in a larger picture")
            .when(isWire, solid),
        word("background", &Settings::background, {{"white"}, {"black"}}, "what the lines are drawn on"),
        word("eyes", &Settings::eyes,
             {{"both"},
              {"left"},
              {"right"},
              {"side-by-side", "two pictures, as a headset shows them"},
              {"crossed", "the same exchanged, for crossed eyes"}},
             "whose picture is drawn; of a still life with one eye closed, what the other sees through its glass"),
        number("screen-width", &Settings::screenWidth, {100, 20000, Scale::logarithmic, true},
               "how wide the picture is where it is shown, for a ruler over it; 0: not known", "mm")
            .when(hasOnePicture, apart),
        toggle("plan", &Settings::plan, "eyes, screen and one corner, seen from above")
            .when(hasOnePicture, apart)
            .when(isWire, solid),
        word("shape", &Settings::shape,
             {{"cube"},
              {"4d-cube", "of four dimensions, projected to three"},
              {"still-life", "coloured, shaded things"}},
             "what is seen"),
        part(&Settings::four, hypercubeRows(), isHypercube, "what has three dimensions has no w"),
        word("mix", &Settings::mix,
             {{"full", "red of the left picture, green and blue of the right"},
              {"half", "the left picture in grey, the right one's green and blue"},
              {"grey", "both pictures in grey"},
              {"least-squares", "what both eyes see through these glasses is as near as can be to what they ought to"}},
             "how two coloured pictures become one")
            .when(mixes, "only two pictures of coloured things are mixed"));
}

const Lesson<Settings, Gpu> lesson{
    .rows = panelRows(),
    .presets =
        {
            {"turned",
             "With red glass left and cyan glass right it stands behind the screen; its horizontal edges are not "
             "level."},
            {"original",
             "The page's first picture: the cube straight on, a small square in a large one, each twice.",
             {.spinX = 0, .spinY = 0, .lineWidth = 1, .plan = false}},
            {"off-axis",
             "Both eyes look straight ahead, so that no corner moves up or down: vertical-parallax is 0. Each channel "
             "is one picture.",
             {.stereo = Stereo::offAxis, .colors = Colors::masks},
             {{"vertical-parallax", 0, 1e-9}}},
            {"side-by-side",
             "Two pictures, left for left: a headset shows each to its eye. The screen is behind the cube, which comes "
             "out of it.",
             {.zDist = -2.2, .convergence = 6, .stereo = Stereo::offAxis, .eyes = Eyes::sideBySide}},
            {"squint",
             "Eyes far apart that meet near: heights differ by many pixels, and on a laptop's screen the parallax is "
             "twice what two eyes are apart.",
             {.eyeSep = 0.5, .convergence = 1, .screenWidth = 345},
             {{"parallax-mm", 127, 190}}},
            {"4d-cube",
             "A cube of four dimensions, turned in two planes with w: eight cubes, each of which shares its six faces "
             "with "
             "six others.",
             {.spinY = 20,
              .stereo = Stereo::offAxis,
              .colors = Colors::masks,
              .background = Paper::black,
              .shape = Shape::hypercube,
              .four = {.xw = 20, .yw = 10, .inner = 0.45}}},
            {"still-life",
             "Coloured things: the red ball is bright behind red glass and nearly black behind cyan, so the eyes "
             "disagree.",
             {.convergence = 3, .stereo = Stereo::offAxis, .shape = Shape::stillLife}},
            {"behind-the-red-glass",
             "What the left eye sees through real red glass, of the mixture with the least error: a ghost of the other "
             "picture stays.",
             {.convergence = 3,
              .stereo = Stereo::offAxis,
              .eyes = Eyes::left,
              .shape = Shape::stillLife,
              .mix = Mix::leastSquares}},
        },
    .controls = {drag("spin-y", 1, "spin-x", -1), keys(Key::down, Key::up, "z-dist", 0.1), wheel("z-dist", 0.1),
                 keys(Key::left, Key::right, "turn-xw", 5)},
    .readouts = {{"vertical-parallax", "largest difference in height between the two pictures of a corner", "px"},
                 {"parallax-min", "the right eye's picture of a corner is this much to the right, least", "px"},
                 {"parallax-max", "the same, most; positive is behind the screen, negative before it", "px"},
                 {"parallax-mm", "parallax-max on a screen of that width; eyes are 63.5 mm apart", "mm"},
                 {"infinity-mm", "off-axis: the parallax there of what is infinitely far away", "mm"},
                 {"crosstalk-left", "how bright the other eye's channels are through the red glass, by its own", "%"},
                 {"crosstalk-right", "the same through the cyan glass", "%"}},
    .draw = draw,
    .figure = figure,
    .readOut = readOut,
    .check = check,
};

const bool added = addLesson(about, lesson);

}  // namespace
}  // namespace mv::stereocube
