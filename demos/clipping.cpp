// clipping: what of points, segments and polygons lies in a window, and why space is clipped before the division.
//
// Claims (each is a test in tests/claims/clipping.cpp; X25 in docs/stability.md is its extreme):
// - [nine-codes] The code of a point says beyond which sides it lies; what OR and AND say of two is true of their segment.
// - [same-on-paper] All four methods give the same on whole numbers that they can compute without rounding.
// - [decided-by-luck] Of segments aimed at a corner, only the exact method decides all rightly, and ends within 4 ulp.
// - [one-piece-too-many] Of a concave polygon in two pieces Sutherland and Hodgman's method makes one, with edges on each
//   other; its area is right, and the other method's pieces have the same.
// - [inside-out] Clipped after the division, a segment from before the eye to behind it shows what is not seen of it; clipped
//   before the projection or before the division, it shows the same, which is right.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/math/clip.h"
#include "mv/math/projection.h"
#include "shared/clip_figure.h"
#include "shared/clip_methods.h"
#include "shared/clip_steps.h"
#include "shared/polygon_overlap.h"

using namespace mv;
using namespace mv::clip;

namespace {

enum class Subject { point, segment, polygon, space };
enum class Method { cohenSutherland, liangBarsky, cyrusBeck, exact };
enum class PolygonMethod { sutherlandHodgman, overlap };
enum class Where { view, clip, divided };

constexpr int segmentsTried = 20000;
constexpr double gridStep = 0.01;

struct Clipping final : Demo {
    Choice<Subject> subject{this,
                            "subject",
                            Subject::segment,
                            {{"point"}, {"segment"}, {"polygon"}, {"space", "a segment in space, seen by an eye"}},
                            "what is clipped"};
    Choice<Method> method{this,
                          "method",
                          Method::cohenSutherland,
                          {{"cohen-sutherland", "codes of the nine regions; cut, and begin again"},
                           {"liang-barsky", "from and to which t the segment is inside"},
                           {"cyrus-beck", "the same by signed distances from any half planes"},
                           {"exact", "the library's: decided without rounding, each end computed once"}},
                          "for a segment"};
    Choice<PolygonMethod> polygonMethod{this,
                                        "polygon-method",
                                        PolygonMethod::sutherlandHodgman,
                                        {{"sutherland-hodgman", "cut at one edge of the window after the other"},
                                         {"overlap", "of both outlines the parts that lie inside the other one"}},
                                        "for a polygon"};
    Choice<Where> where{this,
                        "where",
                        Where::clip,
                        {{"view", "before the projection, against the planes of the view volume"},
                         {"clip", "in homogeneous coordinates, before the division"},
                         {"divided", "after the division, against the square: wrong"}},
                        "a segment in space is clipped"};
    Whole round{this, "round", 8, {0, 8}, "how many rounds, or edges of the window, are shown"};
    NumberChoice offset{
        this, "offset", 0, {0, 1000, 1000000}, "added to all coordinates: how far the window is from the origin"};
    Points segment{this,
                   "ends",
                   {{-2.6, -1.55}, {2.1, 1.85}},
                   {{-3, -2.6}, {3, 2.6}, 2, 2, gridStep},
                   "x,y of the segment's ends"};
    Points window{this,
                  "corners",
                  {{-1.6, -1}, {1.5, 1.2}},
                  {{-3, -2.6}, {3, 2.6}, 2, 2, gridStep},
                  "x,y of two opposite corners"};
    Points polygon{this,
                   "polygon",
                   {{-2.4, -2}, {2.4, -2}, {2.4, 2}, {1.2, 2}, {1.2, -1.4}, {-1.2, -1.4}, {-1.2, 2}, {-2.4, 2}},
                   {{-3, -2.6}, {3, 2.6}, 3, 12, gridStep},
                   "x,y of the polygon's corners"};
    Points against{this,
                   "against",
                   {{-2, -0.6}, {2, -0.9}, {2.1, 0.9}, {0, 1.5}, {-1.9, 0.8}},
                   {{-3, -2.6}, {3, 2.6}, 3, 8, gridStep},
                   "x,y of the corners of the polygon that it is clipped against"};
    Points inSpace{this,
                   "in-space",
                   {{-0.8, -2.4}, {0.9, 1.2}},
                   {{-3, -3.5}, {3, 1.5}, 2, 2, gridStep},
                   "x,z of the segment's ends before the eye, which looks along -z"};

    Readout wrong{this, "wrong", "segments that the method decides wrongly, of those aimed at the window's corners",
                  "%"};
    Readout endError{
        this, "end-error",
        "of those decided rightly: largest error of an end, in units in the last place of the largest coordinate",
        "ulp"};
    Readout area{this, "area", "that the polygons have in common, by the chosen method"};
    Readout off{this, "off",
                "how far the picture's segment ends from where it ought to, at most; the picture is 2 wide"};

    ClipFigure figure;

    Clipping() {
        const auto is = [this](Subject one) { return [this, one] { return subject == one; }; };
        method.onlyWhen(is(Subject::segment), "only a segment has it");
        polygonMethod.onlyWhen(is(Subject::polygon), "only a polygon has it");
        where.onlyWhen(is(Subject::space), "only in space");
        round.onlyWhen([this] { return hasRounds(); }, "the method has no rounds");
        offset.onlyWhen(is(Subject::segment), "only the methods for a segment are tried far away");
        segment.onlyWhen([this] { return subject == Subject::segment || subject == Subject::point; }, "there is none");
        window.onlyWhen([this] { return subject == Subject::segment || subject == Subject::point; }, "there is none");
        polygon.onlyWhen(is(Subject::polygon), "there is none");
        against.onlyWhen(is(Subject::polygon), "there is none");
        inSpace.onlyWhen(is(Subject::space), "nothing is in space");
        bindKeys(Key::left, Key::right, round, 1);
        const auto handle = [this](const char* name, Points& points, auto shown) {
            bindHandle(name, points, [shown](const FrameInfo& frame, const vec2& at) -> std::optional<vec2> {
                if (!shown()) return {};
                return pictureFromPane(ClipFigure::leftPane(frame),
                                       ClipFigure::plotIn(ClipFigure::leftPane(frame)).pixel(at));
            });
        };
        const auto inPlane = [this] { return subject == Subject::segment || subject == Subject::point; };
        handle("end", segment, inPlane);
        handle("corner", window, inPlane);
        handle("polygon's corner", polygon, is(Subject::polygon));
        handle("second polygon's corner", against, is(Subject::polygon));
        handle("end in space", inSpace, is(Subject::space));
    }

    void init() override {}

    void check() const override {
        if (subject != Subject::polygon) return;
        if (!isSimple(onGrid(polygon)))
            throw Error("--polygon", "must have an area, and edges that do not cross or touch");
        if (!isSimple(onGrid(against)))
            throw Error("--against", "must have an area, and edges that do not cross or touch");
        if (polygonMethod == PolygonMethod::sutherlandHodgman && !isConvex(against.points()))
            throw Error("--against", "must be convex with --polygon-method sutherland-hodgman; overlap takes any");
    }

    bool hasRounds() const {
        return (subject == Subject::segment && method == Method::cohenSutherland) ||
               (subject == Subject::polygon && polygonMethod == PolygonMethod::sutherlandHodgman);
    }

    // ---- a segment in the plane

    vec2 far(const vec2& at) const { return at + double(offset); }
    vec2 near(const vec2& at) const { return at - double(offset); }
    Box nearBox() const { return {glm::min(window[0], window[1]), glm::max(window[0], window[1])}; }
    Box box() const { return {far(nearBox().low), far(nearBox().high)}; }

    std::optional<Segment> clipped(const Segment& whole, const Box& to) const {
        if (method == Method::liangBarsky) return liangBarsky(whole, to);
        if (method == Method::cyrusBeck) return cyrusBeck(whole, halfPlanes(to));
        if (method == Method::exact) return clipSegment(whole, to);
        const CodeRound last = cohenSutherland(whole, to).back();
        if (last.does == CodeRound::Does::reject) return {};
        return last.segment;
    }

    // For the study, and the readouts: segments aimed at the window's corners.
    mutable std::vector<Segment> aimed;
    mutable MadeFor<int, std::vector<vec2>> aimedFor;
    const std::vector<Segment>& aimedSegments() const {
        if (aimedFor.changed(offset, window.points())) aimed = aimedAtCorners(exactWindow(box()), segmentsTried);
        return aimed;
    }
    Trial trial() const {
        return tryMethod([this](const Segment& one, const Box& to) { return clipped(one, to); }, aimedSegments(),
                         exactWindow(box()));
    }
    // 1 for each that the method keeps, 0 for each that it rejects.
    std::vector<double> values() const override {
        std::vector<double> kept;
        kept.reserve(segmentsTried);
        const Box to = exactWindow(box());
        for (const Segment& one : aimedSegments()) kept.push_back(clipped(one, to) ? 1 : 0);
        return kept;
    }
    std::vector<std::pair<std::string, double>> valueCounts() const override {
        return {{"end error, ulp", trial().ulps}};
    }

    // ---- a polygon

    // Sutherland and Hodgman's method, as the library has it for space: what is left after so many edges of the window.
    std::vector<vec2> cutAt(int edges) const {
        std::vector<vec4> corners, halfSpaces;
        for (const vec2& corner : polygon.points()) corners.emplace_back(corner, 0, 1);
        for (const HalfPlane& half : halfPlanes(against.points()))
            halfSpaces.emplace_back(half.normal, 0, half.distance);
        halfSpaces.resize(std::min(halfSpaces.size(), static_cast<std::size_t>(edges)));
        std::vector<vec2> left;
        for (const vec4& corner : clipPolygon(corners, halfSpaces)) left.emplace_back(corner);
        return left;
    }
    static GridPolygon onGrid(const Points& points) {
        GridPolygon corners;
        for (const vec2& p : points.points())
            corners.push_back({std::lround(p.x / gridStep), std::lround(p.y / gridStep)});
        return corners;
    }

    // ---- a segment in space

    static mat4 clipFromView() { return perspective(70, 1, 0.25, 2.75); }
    std::vector<vec4> spaceSegment() const {
        return {vec4(inSpace[0].x, -0.35, inSpace[0].y, 1), vec4(inSpace[1].x, 0.3, inSpace[1].y, 1)};
    }
    // The six planes of the view volume in view space: the plane h of clip space is h M there.
    static std::vector<vec4> viewVolume() {
        std::vector<vec4> planes(clipVolume().begin(), clipVolume().end());
        for (vec4& plane : planes) plane = plane * clipFromView();
        return planes;
    }
    // Where the picture shows the ends of what is seen.
    static std::vector<vec2> seenPart(std::vector<vec4> ends, Where clippedWhere) {
        if (clippedWhere == Where::view) ends = clipPolygon(ends, viewVolume());
        for (vec4& end : ends) end = clipFromView() * end;
        if (clippedWhere == Where::divided) {
            for (vec4& end : ends) {
                if (end.w == 0) return {};  // infinitely far away: nothing that could be clipped
                end /= end.w;
            }
        }
        const std::span bounds(clipVolume());
        if (clippedWhere == Where::clip) ends = clipPolygon(ends, bounds);
        if (clippedWhere == Where::divided) ends = clipPolygon(ends, bounds.first(4));  // the square's four sides
        std::vector<vec2> seen;
        seen.reserve(ends.size());
        for (const vec4& end : ends) seen.push_back(vec2(end) / end.w);
        return seen;
    }

    // ---- the picture: the figure on the left, what was computed on the right

    void draw(const Frame& frame) override {
        figure.begin(frame);
        if (subject == Subject::point) drawPoint();
        if (subject == Subject::segment) drawSegment(frame);
        if (subject == Subject::polygon) drawPolygon();
        if (subject == Subject::space) drawSpace(frame);
        figure.draw(frame);
    }

    void drawPoint() {
        const vec2 point = segment[0];
        figure.window(nearBox());
        figure.say("inside where no signed distance is negative:");
        bool inside = true;
        static const std::array<const char*, 4> names{"x - x_min", "x_max - x", "y - y_min", "y_max - y"};
        const auto planes = halfPlanes(nearBox());
        for (std::size_t i = 0; i < 4; ++i) {
            const double distance = planes.at(i).of(point);
            inside = inside && distance >= 0;
            const vec4& color = distance < 0 ? red : green;
            figure.say(names.at(i) + rounded(" = %.2f", distance), color);
            const vec2 aside = (i % 2 == 0 ? 4.0 : -4.0) * vec2(planes.at(i).normal.y, planes.at(i).normal.x);
            figure.drawing.arrow(figure.px(point - distance * planes.at(i).normal) + aside, figure.px(point) + aside,
                                 {color, 2});
        }
        figure.say(inside ? "It is kept." : "It is not kept.", inside ? green : red);
        figure.point(point, 10, inside ? green : red);
        figure.name(point, "p: " + codeText(regionCode(nearBox(), point)));
    }

    void drawSegment(const Frame& frame) {
        const Segment whole{far(segment[0]), far(segment[1])};
        figure.window(nearBox());
        figure.stroke(segment[0], segment[1], {grey, 1.5});
        if (offset > 0) figure.say("all coordinates " + offset.text() + " larger", grey);
        if (method == Method::cohenSutherland) {
            figure.codes(nearBox());
            showRounds(figure, cohenSutherland(whole, box()), round, offset);
        } else {
            if (method == Method::exact) {
                showCorners(figure, whole, box(), offset);
            } else {
                showParameters(figure, whole, box(), offset, method == Method::cyrusBeck);
            }
            const auto part = clipped(whole, box());
            figure.say(part ? "kept: what is blue" : "rejected", part ? blue : red);
            if (part) figure.stroke(near(part->a), near(part->b), {blue, 4});
        }
        for (std::size_t i = 0; i < 2; ++i) {
            figure.point(segment[i], 9, ink);
            figure.name(segment[i], i == 0 ? "a" : "b");
        }
        if (!frame.readouts()) return;
        const Trial tried = trial();
        wrong = tried.wrongPercent;
        endError = tried.ulps;
    }

    void drawPolygon() {
        std::vector<std::vector<vec2>> pieces;
        if (polygonMethod == PolygonMethod::sutherlandHodgman) {
            const int edges = std::min(int(round), static_cast<int>(against.size()));
            pieces = {cutAt(edges)};
            for (int i = 0; i <= edges; ++i)
                figure.say("after " + std::to_string(i) + " edges: " + std::to_string(cutAt(i).size()) + " corners",
                           i == edges ? blue : ink);
            if (edges > 0) {
                const vec2 a = against[static_cast<std::size_t>(edges) - 1],
                           b = against[static_cast<std::size_t>(edges) % against.size()];
                figure.stroke(a - 9.0 * (b - a), a + 9.0 * (b - a), {green, 1.5});
            }
            figure.say("one polygon, whatever its pieces");
        } else {
            const Overlap common = overlap(onGrid(polygon), onGrid(against));
            for (const auto& piece : common.polygons) {
                pieces.emplace_back();
                for (const vec2& corner : piece) pieces.back().push_back(gridStep * corner);
            }
            const auto along = std::count_if(common.parts.begin(), common.parts.end(), [](const EdgePart& part) {
                return part.lies >= EdgePart::Lies::alongSame;
            });
            const auto kept =
                std::count_if(common.parts.begin(), common.parts.end(), [](const EdgePart& part) { return part.kept; });
            figure.say(std::to_string(common.parts.size()) + " parts of outlines, " + std::to_string(along) +
                       " of them along the other");
            figure.say(std::to_string(kept) + " lie inside the other, or with it");
            figure.say("joined: " + std::to_string(pieces.size()) + (pieces.size() == 1 ? " polygon" : " polygons"),
                       blue);
        }
        double sum = 0;
        for (const auto& piece : pieces) {
            figure.hatch(piece, vec4(0.45, 0.62, 0.88, 1));
            sum += areaOf(piece);
        }
        figure.outline(against.points(), {ink, 2});
        figure.outline(polygon.points(), {red, 1.5});
        for (const auto& piece : pieces) {
            figure.outline(piece, {blue, 4});
            for (const vec2& corner : piece) figure.point(corner, 7, blue);
        }
        figure.say(rounded("area %.4f", sum), blue);
        area = sum;
    }

    // From above, the eye at the origin looking down along -z; and the picture that it sees.
    void drawSpace(const Frame& frame) {
        const vec2 nearEdge = 0.25 * vec2(std::tan(radians(35)), -1), farEdge = 11.0 * nearEdge;
        figure.outline({nearEdge, farEdge, {-farEdge.x, farEdge.y}, {-nearEdge.x, nearEdge.y}}, {ink, 1.5});
        figure.stroke({plane.low.x, 0}, {plane.high.x, 0}, {grey, 1});
        figure.name({plane.low.x, 0}, "w = 0: the eye's plane", grey);
        figure.point({0, 0}, 10, ink);
        figure.name({0, 0}, "eye");
        figure.stroke(inSpace[0], inSpace[1], {grey, 2.5});
        const auto inside = clipPolygon(spaceSegment(), viewVolume());
        if (inside.size() == 2) figure.stroke({inside[0].x, inside[0].z}, {inside[1].x, inside[1].z}, {blue, 4});
        for (std::size_t i = 0; i < 2; ++i) {
            figure.point(inSpace[i], 9, ink);
            figure.name(inSpace[i], (i == 0 ? "a: w = " : "b: w = ") + rounded("%.2f", -inSpace[i].y));
        }
        frame.show("clipFromView", clipFromView());

        const auto right = seenPart(spaceSegment(), Where::clip), shown = seenPart(spaceSegment(), where);
        off = right.size() != shown.size() ? 2
              : right.empty()              ? 0
                              : std::max(glm::distance(right[0], shown[0]), glm::distance(right[1], shown[1]));
        const bool isRight =
            right.size() == shown.size() &&
            (right.empty() || glm::distance(right[0], shown[0]) + glm::distance(right[1], shown[1]) < 1e-9);
        figure.say(where == Where::view   ? "clipped before the projection"
                   : where == Where::clip ? "clipped before the division"
                                          : "clipped after the division");
        figure.say(isRight ? "blue: what is seen" : "red: what is not seen; pale: what is", isRight ? blue : red);
        const Pane left = ClipFigure::leftPane(frame);
        const double side = std::min((frame.width() - left.width) * 0.85, frame.height() * 0.62);
        const vec2 low(left.width + 4, frame.height() * 0.2);
        const Plot picture{{low, low + side}, {-1, 1}, {-1, 1}};
        figure.drawing.in({0, 0, frame.width(), frame.height()});
        figure.drawing.fill(picture.box, pale);
        figure.drawing.curve(picture, std::vector<vec2>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}, {ink, 1.5});
        if (!isRight) figure.drawing.curve(picture, right, {vec4(0.6, 0.72, 0.9, 1), 6});
        figure.drawing.curve(picture, shown, {isRight ? blue : red, 3});
    }
};

constexpr Declaration declaration{
    .name = "clipping",
    .sentence =
        "Points, segments and polygons clipped to a window step by step, and a segment in space before and "
        "after the division.",
    .lookFor =
        "Each round cuts one end at one side whose bit is 1, and computes its code anew, until OR or AND decides.",
    .chapter = "Rays, clipping and pixels",
    .number = 25,
    .width = 960,
    .height = 560,
    .background = vec4(1, 1, 1, 1),
    .presets =
        {
            {"codes", "Nine regions, nine codes: each round cuts one end at one side."},
            {"parameters",
             "No end is cut before its place is known: the last entry and the first exit.",
             {{"method", "liang-barsky"}}},
            {"distances", "A point and its signed distances from four half planes.", {{"subject", "point"}}},
            {"concave",
             "A U cut by a convex window: Sutherland and Hodgman's piece hangs together by edges on each other.",
             {{"subject", "polygon"}}},
            {"pieces",
             "The same by the parts of both outlines: two pieces.",
             {{"subject", "polygon"}, {"polygon-method", "overlap"}}},
            {"inside-out",
             "Divided first, the part behind the eye shows up in front, mirrored.",
             {{"subject", "space"}, {"where", "divided"}}},
        },
};

const bool added = addDemo<Clipping, declaration>();

}  // namespace
