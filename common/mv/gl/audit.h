// Watches every GL call of a frame: what it cost, and what of it was needless.
//
// A layer over the function table that is there only between startAudit() and stopAudit(). An audited frame makes the
// same picture, and takes much longer: each draw is counted by an occlusion query and drawn once more for its
// triangles. Audited frames are never timed.
#pragma once
#include <string>
#include <vector>

#include "mv/gl/triangle_count.h"

namespace mv {

// The kinds of waste, by the names that DemoInfo::waste and --audit use. The first two are told, and the others end --audit with
// status 1 where a demo does not declare them.
namespace waste {
inline constexpr const char* stateAgain = "state-again";      // state set to what it was in this frame
inline constexpr const char* uniformAgain = "uniform-again";  // a uniform set to what it was, or twice for no draw
inline constexpr const char* uploadAgain = "upload-again";    // the same bytes to a buffer or texture of the same label
inline constexpr const char* noSample = "no-sample";          // a draw that touched no sample
inline constexpr const char* outsideView = "outside-view";    // a draw all of whose triangles are out of view
inline constexpr const char* unusedBuffer = "unused-buffer";  // an attachment never tested, written or read
inline constexpr const char* unsampled = "unsampled-texture";  // a texture bound and never sampled
inline constexpr const char* unreadPass = "unread-pass";       // a pass into a target of its own that nobody reads
inline constexpr const char* repeatedPass = "repeated-pass";   // such a pass again, though nothing had changed
inline constexpr const char* unusedObject = "unused-object";   // made, and used neither in this frame nor before
inline constexpr const char* unreadPart =
    "unread-part";  // an attribute or the mipmaps, which no draw so much as asks for
inline constexpr const char* needlessWork = "needless-work";  // what no call shows, and the demo itself says
inline constexpr const char* all[] = {stateAgain, uniformAgain, uploadAgain,  noSample,     outsideView, unusedBuffer,
                                      unsampled,  unreadPass,   repeatedPass, unusedObject, unreadPart,  needlessWork};
}  // namespace waste

struct Finding {
    std::string kind;  // one of the above
    std::string what;  // the call or the object, by name
    int times = 1;
    long bytes = 0;  // uploaded in all these times
    bool operator==(const Finding&) const = default;
};

// The work of one frame.
struct FrameWork {
    long draws = 0;
    TriangleCount triangles;
    long samplesPassed = 0;
    long passes = 0;
    long bytesUploaded = 0;  // vertices, textures and uniforms
    long stateChanges = 0;   // calls that set state, the needless ones too
};

// Begins to watch. Objects made from now on are expected to be used.
void startAudit();
// A frame begins and ends; the framebuffer bound at its beginning is the picture's. `repeats`: it draws once more what
// the frame before it drew.
void beginAuditedFrame(bool repeats);
FrameWork endAuditedFrame();
// Ends it, and returns what was needless in all frames, each finding once with its number of times. The features used
// that ES 3.0 lacks are then left for takeBeyondEs().
std::vector<Finding> stopAudit();
bool auditing();

}  // namespace mv
