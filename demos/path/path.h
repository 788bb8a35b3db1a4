#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "lap.h"
#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "mv/motion/minimizing_frame.h"
#include "mv/motion/orientation.h"
#include "mv/motion/path_frame.h"
#include "mv/motion/turn.h"
#include "pose_sphere.h"
#include "shared/car.h"
#include "track.h"

namespace mv::path {

enum class Show { track, poses };
enum class Up { fixed, acceleration, banking, minimizing };
enum class Pace { way, parameter };  // in equal steps of which the car is driven
enum class LengthBy { adaptive, chords, simpson, gauss };

// The car's ride on a track.
struct Ride {
    Track track = Track::park;
    Through curve = Through::spline;
    Up up = Up::banking;
    Transport transport = Transport::doubleReflection;
    int steps = 360;      // samples of the lap
    bool spread = false;  // turn the minimizing frame a little everywhere, so that it closes
    Pace pace = Pace::way;
    double speed = 14;  // m/s, averaged over the lap
    LengthBy lengthBy = LengthBy::adaptive;
    int pieces = 4;  // of the rule, between two keys
};
// A pose by three angles, degrees.
struct Pose {
    double yaw = 0, pitch = 0, roll = 0;
};
struct Poses {
    Pose from{0, 40, 0}, to{180, 55, 180};
    EulerOrder order = EulerOrder::yxz;
};
struct Settings {
    Show show = Show::track;
    Ride ride = {};
    double start = 42;  // %, of the lap, or between the poses
    Poses poses = {};
    double spinX = 0, spinY = 0;  // degrees
};

struct Gpu {
    Program program{"path"};
    Mesh car{carLookingAlongMinusZ(1), "car"};
    Drawing drawing;
    // The lap that was made last
    MadeFor<Track, Through, Up, Transport, int, bool, Pace, double> lapFor;
    Lap lap;
    std::vector<std::size_t> vanishedAt;
    Mesh trackOnGround;
};

constexpr double carLength = 4;  // metres
inline const vec3 worldUp(0, 1, 0);

// The car on the track: path.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame);
void drawTrack(Gpu& gpu, const Settings& s, const Frame& frame);
void makeLap(Gpu& gpu, const Ride& ride);
FramesByRule framesOf(const Ride& ride, const std::vector<PathSample>& samples);
std::vector<PathSample> samplesOf(const Ride& ride);
PathSample motionAt(const Ride& ride, double parameter);
double parameterAt(const Ride& ride, double part);
double lapPart(const Settings& s, const FrameInfo& frame);
void drawFrom(Gpu& gpu, const Pane& pane, const mat4& clipFromWorld, const mat4& worldFromCar);
const TrackPath& pathOf(const Ride& ride);
double lengthOf(const Ride& ride);
mat4 spinOf(const Settings& s);
Pane outsidePane(const FrameInfo& frame);
mat4 clipFromOutside(const Settings& s, const Pane& pane);

// Three ways between two poses: poses.cpp.
using Turnings = std::array<Turning, 3>;
void drawPoses(Gpu& gpu, const Settings& s, const Frame& frame);
quat poseAt(const Poses& poses, std::size_t way, double t);
vec3 anglesAt(const Poses& poses, double t);
quat orientationOf(const Pose& pose);
Turnings turningsOf(const Poses& poses);
double betweenAt(const Settings& s, const FrameInfo& frame);
Pane posePane(const FrameInfo& frame, std::size_t way);
mat4 clipFromPoses(const Settings& s, const Pane& pane);

// Lines, graphs and words: figure.cpp.
void showTrack(Gpu& gpu, const Settings& s, const PathSample& now, const PathFrame& axes, const FrameInfo& frame);
void showPose(Drawing& drawing, const Settings& s, std::size_t way, const Turning& turning, const FrameInfo& frame);
void tellLock(const Poses& poses, const Frame& frame);
void showTurnings(Drawing& drawing, const Turnings& turnings, const FrameInfo& frame);

// knobs.cpp, study.cpp.
std::string nameOf(Up up);
std::string nameOf(LengthBy rule);
void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers);
std::vector<double> values(const Settings& s);

}  // namespace mv::path
