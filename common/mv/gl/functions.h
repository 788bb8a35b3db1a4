// The OpenGL functions, filled in by loadFunctions() from the host's own getProcAddress.
//
// No packaged loader serves OSMesa, EGL and GLFW alike, so the table is ours. The variables are called glEnable,
// glClear ... as in every book; their symbols are mv_glEnable, mv_glClear ..., so that no gl* call of another library
// (OSMesa and libGL export the plain names) can ever bind to them.
#pragma once
#include <GL/glcorearb.h>

#include <functional>
#include <string>
#include <vector>

#define X(name, TYPE, version) extern PFNGL##TYPE##PROC gl##name __asm__("mv_gl" #name);
#include "mv/gl/function_list.inc"
#undef X

namespace mv {

// Fills the table for the current context. Error: a function of OpenGL 3.3 is missing.
void loadFunctions(const std::function<void*(const char*)>& address);

// The version of the current context, 10 * major + minor, and at most newestVersion() (mv/gl/version.h).
int contextVersion();

// Only functions of this core version (10 * major + minor) and older may be called; a newer one throws Error with its
// name. Set to what the demo declares, so that a demo that says 3.3 runs on 3.3.
void allowVersion(int version);
int allowedVersion();

// Features newer than 3.3 that may be there all the same: glClipControl (OpenGL 4.5, or GL_ARB_clip_control), the
// stages of tessellation (4.0) and of compute shaders (4.3). OpenGL ES 3.0 has none of them.
enum class Newer { clipControl, tessellation, compute };
int versionOf(Newer what);  // that brought it, 10 * major + minor
bool contextHas(Newer what);
// Lets its functions be called, too, where the context has it, until the next allowVersion. False: it has not, and the
// calls stay refused.
bool allow(Newer what);
bool isAllowed(Newer what);
// Lays something more over the table (the audit does), now and whenever the table is filled anew; empty: no more.
void setLayer(std::function<void()> layOver);
// Lays checks under that, over what counts and keeps the state; null: none.
void setChecks(void (*layOver)());
// Whether the current context is OpenGL ES.
bool isEs();
// Whether the current context has the extension ("GL_EXT_color_buffer_float").
bool hasExtension(const char* name);

// The calls since the last resetCounters().
struct Counters {
    long draws = 0;
    long triangles = 0;  // submitted
    long vertices = 0;   // submitted
    long passes = 0;     // framebuffers bound and then drawn into
};
const Counters& counters();
void resetCounters(const Counters& to = {});

// The vertex array that is bound, without asking the driver.
GLuint boundVertexArray();

// GL objects made and not yet deleted.
long liveObjects();

// Names a GL object for debuggers and debug messages, where the context has KHR_debug.
void labelObject(GLenum kind, GLuint id, const std::string& label);
// That name in quotes, or "unnamed" and the number. The name ends with the object.
std::string labelOf(GLenum kind, GLuint id);
// Names that are kept: never more than there are objects.
std::size_t labelledObjects();

// ---- What the driver says, and what is wrong

// Whether the driver is asked to speak, by KHR_debug where the context has it; initially not. Listening costs time in
// each call, and so is asked for where somebody reads the messages: tests, --audit, --report, --until.
void listenToDriver(bool on);
bool listeningToDriver();

// Its remarks, "performance: ...", each sentence once and with its number of times, oldest first. Only what is no
// fault: a hint at time, at other drivers, at what is to be removed. Drivers explain themselves so, at any severity but
// notification's.
struct DriverRemark {
    std::string text;
    int times = 1;
    bool operator==(const DriverRemark&) const = default;
};
// Those since forgetRemarks().
const std::vector<DriverRemark>& driverRemarks();
void forgetRemarks();

// The faults since the last call: messages of KHR_debug whose type is error or undefined behavior, whatever their
// severity, glGetError's codes by name, and what was reported.
std::vector<std::string> takeErrors();
// For who finds a fault by other means; told once until it is taken.
void reportFault(const std::string& sentence);

}  // namespace mv
