// The features of OpenGL that a demo uses and ES 3.0, and so WebGL 2, lacks: known from its calls and from the formats
// it draws into.
//
// Shaders are not looked at here, since all of them compile as GLSL ES 3.00 (a test holds them to it), but for those of
// programs with a stage that ES lacks.
#pragma once
#include <optional>
#include <set>
#include <string>

#include "mv/gl/functions.h"

namespace mv {

// The names, as DemoInfo::needs.beyondEs declares them.
namespace beyond_es {
inline constexpr const char* clipDistances = "clip distances";        // glEnable(GL_CLIP_DISTANCE0 + i)
inline constexpr const char* clipControl = "clip control";            // glClipControl, but for what is initially so
inline constexpr const char* polygonMode = "polygon mode";            // lines or points instead of faces
inline constexpr const char* borderClamp = "border clamp";            // GL_CLAMP_TO_BORDER
inline constexpr const char* floatTargets = "float targets";          // drawing into colours of floats
inline constexpr const char* floatBlending = "float blending";        // blending into those of 32 bits
inline constexpr const char* depthReadBack = "depth read-back";       // glReadPixels of a depth buffer
inline constexpr const char* stencilReadBack = "stencil read-back";   // glReadPixels of a stencil buffer
inline constexpr const char* countingQueries = "counting queries";    // of samples passed or primitives made
inline constexpr const char* indexedFeedback = "indexed feedback";    // glDrawElements under transform feedback
inline constexpr const char* expandedFeedback = "expanded feedback";  // strips and fans, captured as separate triangles
inline constexpr const char* geometryShaders = "geometry shaders";    //
inline constexpr const char* tessellation = "tessellation";           // OpenGL 4.0
inline constexpr const char* computeShaders = "compute shaders";      // OpenGL 4.3
inline constexpr const char* floatFiltering = "float filtering";      // of textures of 32-bit floats, linearly
inline constexpr const char* anisotropicFiltering = "anisotropic filtering";  // GL_TEXTURE_MAX_ANISOTROPY
inline constexpr const char* all[] = {clipDistances,   clipControl,     polygonMode,      borderClamp,
                                      floatTargets,    floatBlending,   depthReadBack,    stencilReadBack,
                                      countingQueries, indexedFeedback, expandedFeedback, geometryShaders,
                                      tessellation,    computeShaders,  floatFiltering,   anisotropicFiltering};
}  // namespace beyond_es

// The functions of OpenGL beyond 3.3 that a feature stands for; nothing for the others.
std::optional<Newer> newerThan33(const std::string& feature);

// Whether the context has one of these. OpenGL ES has few of them (clip control by GL_EXT_clip_control); OpenGL 3.3 has all but clip
// control, which came with 4.5 (or with GL_ARB_clip_control), tessellation (4.0), compute shaders (4.3), and anisotropic filtering,
// which came with 4.6 (or with GL_EXT_texture_filter_anisotropic). A lesson asks in its `fallback` where its settings
// need the feature. If the answer is no, the framework says so beside the picture, in the words of
// DemoInfo::needs.beyondEs. Error: clip control, tessellation or compute shaders are there, but the demo did not
// declare them.
bool has(const char* feature);
// The features that has() answered with no since the last call.
std::set<std::string> takeMissing();
// For tests: from now on, and for the demos that are opened from now on, these are as if the context lacked them.
void withhold(std::set<std::string> features);
bool isWithheld(const std::string& feature);

// Watches from now on, with nothing noted yet. Another switch of glEnable that ES 3.0 does not know is noted by its own
// name ("GL_DEPTH_CLAMP").
void watchBeyondEs();
// Ends it, and returns what was used.
std::set<std::string> stopWatchingBeyondEs();

// The same for a layer that is laid together with others: lays it over the table as it is, and takes what was noted.
void layBeyondEs();
std::set<std::string> takeBeyondEs();

}  // namespace mv
