// The settings of clipping: rows, presets, controls and declaration.
#include "clipping.h"
#include "mv/demo/lesson.h"

namespace mv::clipping {

void check(const Settings& s) {
    if (s.subject != Subject::polygon) return;
    if (!isSimple(onGrid(s.polygons.polygon)))
        throw Error("--polygon", "must have an area, and edges that do not cross or touch");
    if (!isSimple(onGrid(s.polygons.against)))
        throw Error("--against", "must have an area, and edges that do not cross or touch");
    if (s.polygons.method != PolygonMethod::overlap && !isConvex(s.polygons.against))
        throw Error("--against", s.polygons.method == PolygonMethod::sides
                                     ? "must be convex with --polygon-method sides; overlap takes any"
                                     : "must be convex with --polygon-method sutherland-hodgman; overlap takes any");
}

namespace {

constexpr Declaration about{
    .name = "clipping",
    .sentence =
        "Points, segments and polygons clipped to a window step by step, and a segment in space before and after the "
        "division.",
    .lookFor =
        "Each round cuts one end at one side whose bit is 1, and computes its code anew, until OR or AND decides.",
    .chapter = "Rays, clipping and pixels",
    .number = 25,
    .width = 960,
    .height = 560,
    .background = vec4(1, 1, 1, 1),
};

template <Subject... subjects>
bool is(const Settings& s) {
    return ((s.subject == subjects) || ...);
}
bool hasRounds(const Settings& s) {
    return (is<Subject::segment>(s) && s.plane.method == Method::cohenSutherland) ||
           (is<Subject::polygon>(s) && s.polygons.method == PolygonMethod::sutherlandHodgman);
}

std::vector<Row<Settings>> panelRows() {
    const PointLimits two{{-3, -2.6}, {3, 2.6}, 2, 2, gridStep};
    return together(
        word("subject", &Settings::subject,
             {{"point"}, {"segment"}, {"polygon"}, {"space", "a segment in space, seen by an eye"}}, "what is clipped"),
        part(&Settings::plane,
             {word("method", &InPlane::method,
                   {{"cohen-sutherland", "codes of the nine regions; cut, and begin again"},
                    {"liang-barsky", "from and to which t the segment is inside"},
                    {"cyrus-beck", "the same by signed distances from any half planes"},
                    {"exact", "the library's: decided without rounding, each end computed once"}},
                   "for a segment")},
             is<Subject::segment>, "only a segment has it"),
        part(&Settings::polygons,
             {word("polygon-method", &Polygons::method,
                   {{"sutherland-hodgman", "cut at one edge of the window after the other"},
                    {"overlap", "of both outlines the parts that lie inside the other one"},
                    {"sides", "each side by itself, as a segment: what is left does not close"}},
                   "for a polygon")},
             is<Subject::polygon>, "only a polygon has it"),
        part(&Settings::space,
             {word("where", &InSpace::where,
                   {{"view", "before the projection, against the planes of the view volume"},
                    {"clip", "in homogeneous coordinates, before the division"},
                    {"divided", "after the division, against the square: wrong"}},
                   "a segment in space is clipped")},
             is<Subject::space>, "only in space"),
        whole("round", &Settings::round, {0, 8}, "how many rounds, or edges of the window, are shown")
            .when(hasRounds, "the method has no rounds"),
        part(&Settings::plane,
             {oneOf("offset", &InPlane::offset, {0, 1000, 1000000},
                    "added to all coordinates: how far the window is from the origin")},
             is<Subject::segment>, "only the methods for a segment are tried far away"),
        part(&Settings::plane,
             {points("ends", &InPlane::ends, two, "x,y of the segment's ends"),
              points("corners", &InPlane::corners, two, "x,y of two opposite corners")},
             is<Subject::point, Subject::segment>, "there is none"),
        part(&Settings::polygons,
             {points("polygon", &Polygons::polygon, {{-3, -2.6}, {3, 2.6}, 3, 12, gridStep},
                     "x,y of the polygon's corners"),
              points("against", &Polygons::against, {{-3, -2.6}, {3, 2.6}, 3, 8, gridStep},
                     "x,y of the corners of the polygon that it is clipped against")},
             is<Subject::polygon>, "there is none"),
        part(&Settings::space,
             {points("in-space", &InSpace::ends, {{-3, -3.5}, {3, 1.5}, 2, 2, gridStep},
                     "x,z of the segment's ends before the eye, which looks along -z")},
             is<Subject::space>, "nothing is in space"));
}

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"codes", "Nine regions, nine codes: each round cuts one end at one side."},
        {"parameters",
         "No end is cut before its place is known: the last entry and the first exit.",
         {.plane = {.method = Method::liangBarsky}}},
        {"distances", "A point and its signed distances from four half planes.", {.subject = Subject::point}},
        {"concave",
         "A U cut by a convex window: Sutherland and Hodgman's piece hangs together by edges on each other.",
         {.subject = Subject::polygon}},
        {"pieces",
         "The same by the parts of both outlines: two pieces.",
         {.subject = Subject::polygon, .polygons = {.method = PolygonMethod::overlap}}},
        {"inside-out",
         "Divided first, the part behind the eye shows up in front, mirrored.",
         {.subject = Subject::space, .space = {.where = Where::divided}}},
    };
}

// The pixel of the left pane for a place of the plane, for these subjects.
template <Subject... subjects>
std::optional<vec2> placeOf(const Settings& s, const FrameInfo& frame, const vec2& at) {
    if (!is<subjects...>(s)) return {};
    const Pane pane = ClipFigure::leftPane(frame);
    return pictureFromPane(pane, ClipFigure::plotIn(pane).pixel(at));
}

const bool added = addLesson(
    about,
    Lesson<Settings, Gpu>{
        .rows = panelRows(),
        .presets = presets(),
        .controls = {keys(Key::left, Key::right, "round", 1)},
        .handles = {{"end", {"ends"}, {}, placeOf<Subject::point, Subject::segment>},
                    {"corner", {"corners"}, {}, placeOf<Subject::point, Subject::segment>},
                    {"polygon's corner", {"polygon"}, {}, placeOf<Subject::polygon>},
                    {"second polygon's corner", {"against"}, {}, placeOf<Subject::polygon>},
                    {"end in space", {"in-space"}, {}, placeOf<Subject::space>}},
        .readouts =
            {{"wrong", "segments that the method decides wrongly, of those aimed at the window's corners", "%"},
             {"end-error",
              "of those decided rightly: largest error of an end, in units in the last place of the largest coordinate",
              "ulp"},
             {"area", "that the polygons have in common, by the chosen method"},
             {"off", "how far the picture's segment ends from where it ought to, at most; the picture is 2 wide"}},
        .draw = draw,
        .readOut = readOut,
        .check = check,
        .values = values,
        .valueCounts = valueCounts,
    });

}  // namespace
}  // namespace mv::clipping
