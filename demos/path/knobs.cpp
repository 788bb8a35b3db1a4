// The settings of path: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "path.h"

namespace mv::path {
namespace {

constexpr WordList upWords{{"fixed", "the world's"},
                           {"acceleration", "the slide's"},
                           {"banking", "acceleration minus gravity"},
                           {"minimizing", "carried along without a turn about the path"}};
constexpr WordList lengthWords{{"adaptive"}, {"chords"}, {"simpson"}, {"gauss"}};

bool isTrack(const Settings& s) { return s.show == Show::track; }
bool isPoses(const Settings& s) { return s.show == Show::poses; }
bool isCarried(const Settings& s) { return s.ride.up == Up::minimizing; }
bool hasPieces(const Settings& s) { return s.ride.lengthBy != LengthBy::adaptive; }

std::optional<vec2> placeOfCar(const Settings& s, const FrameInfo& frame) {
    if (!isTrack(s)) return std::nullopt;
    const Pane pane = outsidePane(frame);
    const vec3 place = motionAt(s.ride, parameterAt(s.ride, lapPart(s, frame))).position;
    return pictureFromPane(pane, clipFromOutside(s, pane), place);
}
std::optional<vec2> placeOfNose(const Settings& s, const FrameInfo& frame, const Pose& pose) {
    if (!isPoses(s)) return std::nullopt;
    const Pane pane = posePane(frame, 1);
    return pictureFromPane(pane, clipFromPoses(s, pane), turned(orientationOf(pose), vec3(0, 0, -1)));
}

std::vector<Row<Settings>> rideRows() {
    const Literal trackless = "between two poses there is no track", carries = "the other rules carry nothing along";
    return together(part(&Settings::ride,
                         {word("track", &Ride::track,
                               {{"park", "bend, hills and a loop"},
                                {"eight", "flat, with two inflections"},
                                {"ring", "flat, of radius 20 m"},
                                {"knot", "a trefoil"}},
                               "which curve"),
                          word("curve", &Ride::curve, {{"spline"}, {"catmull-rom", "its curvature jumps"}},
                               "what goes through its keys"),
                          word("up", &Ride::up, upWords, "which way is up for the car")},
                         isTrack, trackless),
                    word("transport", within(&Settings::ride, &Ride::transport),
                         {{"re-orthogonalize"}, {"project"}, {"rotate"}, {"double-reflection"}},
                         "how the minimizing frame is carried from sample to sample")
                        .when(isTrack, trackless)
                        .when(isCarried, carries),
                    whole("steps", within(&Settings::ride, &Ride::steps), {120, 8000},
                          "samples of the lap that frames are made for")
                        .when(isTrack, trackless),
                    toggle("spread", within(&Settings::ride, &Ride::spread),
                           "turn the minimizing frame a little everywhere, so that it closes")
                        .when(isTrack, trackless)
                        .when(isCarried, carries),
                    part(&Settings::ride,
                         {word("pace", &Ride::pace, {{"way"}, {"parameter"}}, "of what the car covers equal steps"),
                          number("speed", &Ride::speed, {1, 40}, "of the car, averaged over the lap", "m/s"),
                          word("length-by", &Ride::lengthBy, lengthWords, "rule for the length")},
                         isTrack, trackless),
                    whole("pieces", within(&Settings::ride, &Ride::pieces), {2, 64},
                          "chords, parts or nodes of that rule between two keys")
                        .when(isTrack, trackless)
                        .when(hasPieces, "adaptive chooses for itself"));
}

std::vector<Row<Poses>> poseRows(Pose Poses::*pose, Literal yaw, Literal pitch, Literal roll) {
    return part(pose, {angle(yaw, &Pose::yaw, "the pose: turned to the left"),
                       number(pitch, &Pose::pitch, {-90, 90}, "the pose: nose up", "deg"),
                       angle(roll, &Pose::roll, "the pose: leaning to the left")});
}

std::vector<Row<Settings>> panelRows() {
    const Literal poseless = "the track has no keys of poses";
    return together(
        word("scene", &Settings::show, {{"track"}, {"poses", "three ways between two poses"}}, "what is shown"),
        rideRows(),
        number("start", &Settings::start, {0, 100}, "where frame 0 is: the part of the lap, or between the poses", "%"),
        part(&Settings::poses, poseRows(&Poses::from, "from-yaw", "from-pitch", "from-roll"), isPoses, poseless),
        part(&Settings::poses, poseRows(&Poses::to, "to-yaw", "to-pitch", "to-roll"), isPoses, poseless),
        angle("spin-x", &Settings::spinX, "turn about the x axis"),
        angle("spin-y", &Settings::spinY, "turn about the y axis"),
        word("order", within(&Settings::poses, &Poses::order),
             {{"yxz", "yaw, pitch, roll: as the poses are given"},
              {"xyz", "about x, then y, then z"},
              {"zyx", "about z, then y, then x"}},
             "which three angles of the poses are mixed; the last acts first")
            .when(isPoses, poseless));
}

constexpr Declaration about{
    .name = "path",
    .sentence = "A car on a curve: forward is the velocity, up is a choice; and three ways from one pose to another.",
    .lookFor = "The sleepers lean into each bend, so that a passenger is pressed straight down into the seat.",
    .chapter = "Motion",
    .number = 35,
    .width = 960,
    .height = 560,
    .animated = true,
    .background = vec4(0.95, 0.97, 1, 1),
    .needs = {.depth = true},
};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"banking",
         "The sleepers lean into each bend, so that a passenger is pressed straight into the seat.",
         {},
         {{"flips", 0, 0}}},
        {"acceleration",
         "The slide's rule lays the car on its side in the bends, and turns it over at each red dot.",
         {.ride = {.up = Up::acceleration}},
         {{"flips", 3, 3}}},
        {"fixed",
         "Upright in every bend, until the path points at the sky: in the loop the car turns over twice.",
         {.ride = {.up = Up::fixed}},
         {{"flips", 2, 2}}},
        {"minimizing",
         "Carried along without a turn about the path: it never flips, but a lap leaves it 12 degrees off.",
         {.ride = {.up = Up::minimizing}},
         {{"flips", 0, 0}, {"closing-angle", 11.5, 12.5}}},
        {"poses",
         "Nose up by 85 degrees more, past the vertical: slerp does that, three angles whirl by 131 degrees.",
         {.show = Show::poses},
         {{"turned-slerp", 84.9, 85.1}, {"turned-angles", 131, 132}}},
        {"gimbal-lock",
         "Nose straight up: the rings of yaw and pitch lie in one plane, and yaw does what roll does.",
         {.show = Show::poses, .start = 100, .poses = {.from = {0, 0, 0}, .to = {90, 90, 0}}}},
    };
}

std::vector<Probe::Number> readouts() {
    return {{"car-speed", "of the car now", "m/s"},
            {"lean", "of the car now, to the right", "deg"},
            {"flips", "places where up turns by more than 90 degrees within a car's length, 4 m"},
            {"vanished", "samples at which the rule has no up"},
            {"most-turn", "largest turn of up about the path, by the metre", "deg/m"},
            {"closing-angle", "by which the minimizing frame misses itself after a lap", "deg"},
            {"length", "of the lap, by the chosen rule", "m"},
            {"length-off", "how far that is off", "m"},
            {"axes-apart", "by three angles: angle between the axes of the first and the last now; 0 is lock", "deg"},
            {"turned-angles", "whole turn by three angles", "deg"},
            {"turned-slerp", "whole turn by slerp", "deg"},
            {"turned-nlerp", "whole turn by nlerp", "deg"},
            {"uneven-angles", "by three angles: largest speed by smallest"},
            {"uneven-slerp", "by slerp: largest speed by smallest"},
            {"uneven-nlerp", "by nlerp: largest speed by smallest"},
            {"axis-x", "of the axis about which slerp turns, by the smaller angle"},
            {"axis-y", "the same: y"},
            {"axis-z", "the same: z"},
            {"nose-turn", "smallest turn that takes the first nose to the second, whatever the roof does", "deg"}};
}

const bool added = addLesson(
    about,
    Lesson<Settings, Gpu>{
        .rows = panelRows(),
        .presets = presets(),
        .controls = {drag("spin-y", 0.5, "spin-x", 0.5)},
        .handles = {{"car", {"start"}, placeOfCar},
                    {"nose at from",
                     {"from-yaw", "from-pitch"},
                     [](const Settings& s, const FrameInfo& frame) { return placeOfNose(s, frame, s.poses.from); }},
                    {"nose at to",
                     {"to-yaw", "to-pitch"},
                     [](const Settings& s, const FrameInfo& frame) { return placeOfNose(s, frame, s.poses.to); }}},
        .readouts = readouts(),
        .draw = draw,
        .readOut = readOut,
        .values = values,
    });

}  // namespace

std::string nameOf(Up up) { return wordOf(upWords, up); }
std::string nameOf(LengthBy rule) { return wordOf(lengthWords, rule); }

}  // namespace mv::path
