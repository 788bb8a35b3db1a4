#include "mv/gl/functions.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "mv/error.h"
#include "mv/gl/layer.h"
#include "mv/gl/state.h"
#include "mv/gl/version.h"

#define X(name, TYPE, version) PFNGL##TYPE##PROC gl##name = nullptr;
#include "mv/gl/function_list.inc"
#undef X

namespace mv {
namespace {

FunctionTable driver;  // what it gave, before counting and refusing are laid over it
PFNGLOBJECTLABELPROC driverObjectLabel = nullptr;

Counters counted;
GLuint vertexArray = 0;
bool newPass = true;  // nothing was drawn yet into the framebuffer that is bound
long live = 0;
int allowed = 33;
std::set<Newer> newerAllowed;  // beside that version
bool es = false;
int version = 33;
std::vector<std::string> faults;
std::vector<DriverRemark> remarks;
bool listening = false;
PFNGLDEBUGMESSAGECALLBACKPROC driverDebugMessageCallback = nullptr;
PFNGLDEBUGMESSAGECONTROLPROC driverDebugMessageControl = nullptr;
std::function<void()> extraLayer;
void (*checks)() = nullptr;
std::map<std::pair<GLenum, GLuint>, std::string> labels;

// ---- Functions that stand for a call newer than the demo declares: one refusal each, with the call's own signature.

struct FunctionFacts {
    const char* name;
    int version;
};

#define X(name, TYPE, version) constexpr FunctionFacts facts##name{"gl" #name, version};
#include "mv/gl/function_list.inc"
#undef X

template <const FunctionFacts& facts, class Function>
struct Refusal;
template <const FunctionFacts& facts, class Result, class... Arguments>
struct Refusal<facts, Result (*)(Arguments...)> {
    static Result call(Arguments...) {
        throw Error(facts.name, "needs OpenGL " + std::to_string(facts.version / 10) + "." +
                                    std::to_string(facts.version % 10) +
                                    "; declare it with .needs = {.gl = " + std::to_string(facts.version) + "}");
    }
};

// Functions that stand for a call that the context has not.
template <const FunctionFacts& facts, class Function>
struct Missing;
template <const FunctionFacts& facts, class Result, class... Arguments>
struct Missing<facts, Result (*)(Arguments...)> {
    static Result call(Arguments...) {
        throw Error(facts.name, es ? "is not in OpenGL ES 3.0; ask isEs() before it is called"
                                   : "is not in this driver, which says that it has it");
    }
};

// ES has these two for floats alone.
PFNGLCLEARDEPTHFPROC esClearDepth = nullptr;
PFNGLDEPTHRANGEFPROC esDepthRange = nullptr;
void clearDepthInEs(GLdouble depth) { esClearDepth(static_cast<GLfloat>(depth)); }
void depthRangeInEs(GLdouble near, GLdouble far) {
    esDepthRange(static_cast<GLfloat>(near), static_cast<GLfloat>(far));
}

// ES has no such switches: what they turn on in OpenGL is always on there.
PFNGLENABLEPROC esEnable = nullptr;
PFNGLDISABLEPROC esDisable = nullptr;
bool isAlwaysOnInEs(GLenum capability) {
    return capability == GL_PROGRAM_POINT_SIZE || capability == GL_TEXTURE_CUBE_MAP_SEAMLESS;
}
void enableInEs(GLenum capability) {
    if (!isAlwaysOnInEs(capability)) esEnable(capability);
}
void disableInEs(GLenum capability) {
    if (!isAlwaysOnInEs(capability)) esDisable(capability);
}

// ---- Counting

void countPrimitives(GLenum mode, GLsizei count) {
    ++counted.draws;
    if (newPass) ++counted.passes;
    newPass = false;
    counted.vertices += count;
    if (mode == GL_TRIANGLES) counted.triangles += count / 3;
    if ((mode == GL_TRIANGLE_STRIP || mode == GL_TRIANGLE_FAN) && count > 2) counted.triangles += count - 2;
}

void countedDrawArrays(GLenum mode, GLint first, GLsizei count) {
    countPrimitives(mode, count);
    driver.DrawArrays(mode, first, count);
}
void countedDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
    countPrimitives(mode, count);
    driver.DrawElements(mode, count, type, indices);
}

// A deleted object loses its label, too: drivers give a name only once, and labels of frames long gone would fill the
// memory.
void countDeleted(GLenum kind, GLuint name) {
    if (name == 0) return;  // GL ignores it
    --live;
    labels.erase({kind, name});
}

// Gen* and Delete* of the object kinds that all have the signatures (count, names).
using Generate = void (*)(GLsizei, GLuint*);
using Delete = void (*)(GLsizei, const GLuint*);
template <Generate FunctionTable::*function>
void countedGenerate(GLsizei count, GLuint* names) {
    (driver.*function)(count, names);
    live += count;
}
template <Delete FunctionTable::*function, GLenum kind>
void countedDelete(GLsizei count, const GLuint* names) {
    for (GLsizei i = 0; i < count; ++i) countDeleted(kind, names[i]);
    (driver.*function)(count, names);
}
GLuint countedCreateProgram() {
    ++live;
    return driver.CreateProgram();
}
GLuint countedCreateShader(GLenum kind) {
    ++live;
    return driver.CreateShader(kind);
}
void countedDeleteProgram(GLuint name) {
    countDeleted(GL_PROGRAM, name);
    driver.DeleteProgram(name);
}
void countedDeleteShader(GLuint name) {
    countDeleted(GL_SHADER, name);
    driver.DeleteShader(name);
}

void countedBindFramebuffer(GLenum target, GLuint framebuffer) {
    if (target != GL_READ_FRAMEBUFFER) newPass = true;
    driver.BindFramebuffer(target, framebuffer);
}

void trackedBindVertexArray(GLuint array) {
    vertexArray = array;
    driver.BindVertexArray(array);
}
void trackedDeleteVertexArrays(GLsizei count, const GLuint* names) {
    for (GLsizei i = 0; i < count; ++i) {
        if (names[i] == vertexArray) vertexArray = 0;  // GL unbinds what is deleted
    }
    countedDelete<&FunctionTable::DeleteVertexArrays, GL_VERTEX_ARRAY>(count, names);
}

void layCountersOver() {
    glBindVertexArray = trackedBindVertexArray;
    glBindFramebuffer = countedBindFramebuffer;
    glDrawArrays = countedDrawArrays;
    glDrawElements = countedDrawElements;
    glGenBuffers = countedGenerate<&FunctionTable::GenBuffers>;
    glGenFramebuffers = countedGenerate<&FunctionTable::GenFramebuffers>;
    glGenQueries = countedGenerate<&FunctionTable::GenQueries>;
    glGenRenderbuffers = countedGenerate<&FunctionTable::GenRenderbuffers>;
    glGenTextures = countedGenerate<&FunctionTable::GenTextures>;
    glGenVertexArrays = countedGenerate<&FunctionTable::GenVertexArrays>;
    glDeleteBuffers = countedDelete<&FunctionTable::DeleteBuffers, GL_BUFFER>;
    glDeleteFramebuffers = countedDelete<&FunctionTable::DeleteFramebuffers, GL_FRAMEBUFFER>;
    glDeleteQueries = countedDelete<&FunctionTable::DeleteQueries, GL_QUERY>;
    glDeleteRenderbuffers = countedDelete<&FunctionTable::DeleteRenderbuffers, GL_RENDERBUFFER>;
    glDeleteTextures = countedDelete<&FunctionTable::DeleteTextures, GL_TEXTURE>;
    glDeleteVertexArrays = trackedDeleteVertexArrays;
    glCreateProgram = countedCreateProgram;
    glCreateShader = countedCreateShader;
    glDeleteProgram = countedDeleteProgram;
    glDeleteShader = countedDeleteShader;
}

void fillIn(Newer what) {
    switch (what) {
        case Newer::clipControl:
            glClipControl = driver.ClipControl;
            break;
        case Newer::tessellation:
            glPatchParameteri = driver.PatchParameteri;
            break;
        case Newer::compute:
            glBindImageTexture = driver.BindImageTexture;
            glMemoryBarrier = driver.MemoryBarrier;
            glDispatchCompute = driver.DispatchCompute;
            break;
    }
}

// The calls allowed now, then the layers that count, keep the state, and listen.
void fillTable() {
#define X(name, TYPE, version)                                                    \
    gl##name = version > allowed ? &Refusal<facts##name, PFNGL##TYPE##PROC>::call \
               : driver.name     ? driver.name                                    \
                                 : &Missing<facts##name, PFNGL##TYPE##PROC>::call;
#include "mv/gl/function_list.inc"
#undef X
    for (const Newer what : newerAllowed) fillIn(what);
    layCountersOver();
    keepState();
    if (checks) checks();
    if (extraLayer) extraLayer();
    if (!driver.GetString || !driver.DrawArrays) throw Error("OpenGL", "has no functions; is a driver installed?");
}

// ---- KHR_debug, outside the table: it belongs to the framework, and it is newer than the floor.

// The word for a type of message that is no fault.
const char* remarkWord(GLenum type) {
    switch (type) {
        case GL_DEBUG_TYPE_PERFORMANCE:
            return "performance";
        case GL_DEBUG_TYPE_PORTABILITY:
            return "portability";
        case GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR:
            return "deprecated";
        default:
            return "other";
    }
}

// A driver's severity says how much it matters, its type whether it is a fault: NVIDIA explains a recompiled shader at medium.
void onDebugMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* message, const void*) {
    if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) return reportFault(message);
    const bool isMark =
        type == GL_DEBUG_TYPE_MARKER || type == GL_DEBUG_TYPE_PUSH_GROUP || type == GL_DEBUG_TYPE_POP_GROUP;
    if (isMark || severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
    const std::string text = std::string(remarkWord(type)) + ": " + message;
    const auto known = std::find_if(remarks.begin(), remarks.end(), [&](const auto& one) { return one.text == text; });
    known == remarks.end() ? remarks.push_back({text, 1}) : void(++known->times);
}

template <class Function>
Function lookUp(const std::function<void*(const char*)>& address, const char* name) {
    return reinterpret_cast<Function>(address(name));
}

}  // namespace

void loadFunctions(const std::function<void*(const char*)>& address) {
#define X(name, TYPE, version) driver.name = lookUp<PFNGL##TYPE##PROC>(address, "gl" #name);
#include "mv/gl/function_list.inc"
#undef X
    counted = {};
    live = 0;
    labels.clear();
    vertexArray = 0;
    forgetState();
    faults.clear();
    remarks.clear();
    listening = false;
    allowVersion(33);

    const auto driverVersion = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    if (!driverVersion) throw Error("OpenGL", "has no current context");
    es = std::string(driverVersion).rfind("OpenGL ES", 0) == 0;
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    version = es ? 10 * major + minor : std::min(10 * major + minor, newestVersion());
    if (es) {
        esClearDepth = lookUp<PFNGLCLEARDEPTHFPROC>(address, "glClearDepthf");
        esDepthRange = lookUp<PFNGLDEPTHRANGEFPROC>(address, "glDepthRangef");
        driver.ClearDepth = clearDepthInEs;
        driver.DepthRange = depthRangeInEs;
        esEnable = std::exchange(driver.Enable, enableInEs);
        esDisable = std::exchange(driver.Disable, disableInEs);
        driver.ClipControl = lookUp<PFNGLCLIPCONTROLPROC>(address, "glClipControlEXT");
        allowVersion(33);
    }

    driverObjectLabel = nullptr;
    driverDebugMessageCallback = nullptr;
    if (!hasExtension("GL_KHR_debug")) return;
    const auto find = [&]<class Function>(Function& function, const std::string& name) {
        function = lookUp<Function>(address, name.c_str());
        if (!function) function = lookUp<Function>(address, (name + "KHR").c_str());  // so it is called in ES
    };
    find(driverDebugMessageCallback, "glDebugMessageCallback");
    find(driverDebugMessageControl, "glDebugMessageControl");
    find(driverObjectLabel, "glObjectLabel");
    // A debug context speaks unasked.
    driver.Disable(GL_DEBUG_OUTPUT);
}

int contextVersion() { return version; }

void listenToDriver(bool on) {
    if (on == listening) return;
    listening = on;
    if (!driverDebugMessageCallback) return;
    driverDebugMessageCallback(on ? onDebugMessage : nullptr, nullptr);
    // Those of low severity are initially off, and a fault may be one.
    if (driverDebugMessageControl)
        driverDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    const auto turn = on ? driver.Enable : driver.Disable;
    turn(GL_DEBUG_OUTPUT);
    turn(GL_DEBUG_OUTPUT_SYNCHRONOUS);
}
bool listeningToDriver() { return listening; }

void allowVersion(int newest) {
    restoreInitialState();  // while what was set may still be called
    allowed = newest;
    newerAllowed.clear();
    fillTable();
}
int allowedVersion() { return allowed; }

int versionOf(Newer what) { return what == Newer::clipControl ? 45 : what == Newer::tessellation ? 40 : 43; }

bool contextHas(Newer what) {
    if (es) return what == Newer::clipControl && driver.ClipControl && hasExtension("GL_EXT_clip_control");
    switch (what) {
        case Newer::clipControl:
            return driver.ClipControl && (version >= versionOf(what) || hasExtension("GL_ARB_clip_control"));
        case Newer::tessellation:
            return driver.PatchParameteri && version >= versionOf(what);
        case Newer::compute:
            return driver.DispatchCompute && driver.BindImageTexture && driver.MemoryBarrier &&
                   version >= versionOf(what);
    }
    return false;
}

bool allow(Newer what) {
    if (!contextHas(what)) return false;
    newerAllowed.insert(what);
    fillTable();
    return true;
}

bool isAllowed(Newer what) { return newerAllowed.contains(what) || (!es && allowed >= versionOf(what)); }

void setLayer(std::function<void()> layOver) {
    extraLayer = std::move(layOver);
    fillTable();
}
void setChecks(void (*layOver)()) {
    checks = layOver;
    if (driver.GetString) fillTable();
}
bool isEs() { return es; }

const Counters& counters() { return counted; }
void resetCounters(const Counters& to) {
    counted = to;
    newPass = to.draws == 0;
}
GLuint boundVertexArray() { return vertexArray; }
long liveObjects() { return live; }
std::size_t labelledObjects() { return labels.size(); }

std::string labelOf(GLenum kind, GLuint id) {
    const auto found = labels.find({kind, id});
    return found == labels.end() ? "unnamed " + std::to_string(id) : "'" + found->second + "'";
}

void labelObject(GLenum kind, GLuint id, const std::string& label) {
    labels[{kind, id}] = label;
    if (driverObjectLabel) driverObjectLabel(kind, id, static_cast<GLsizei>(label.size()), label.c_str());
}

void reportFault(const std::string& sentence) {
    if (std::find(faults.begin(), faults.end(), sentence) == faults.end()) faults.push_back(sentence);
}

const std::vector<DriverRemark>& driverRemarks() { return remarks; }
void forgetRemarks() { remarks.clear(); }

std::vector<std::string> takeErrors() {
    std::vector<std::string> errors = std::exchange(faults, {});
    for (GLenum code = glGetError(); code != GL_NO_ERROR; code = glGetError()) {
        switch (code) {
            case GL_INVALID_ENUM:
                errors.emplace_back("GL_INVALID_ENUM");
                break;
            case GL_INVALID_VALUE:
                errors.emplace_back("GL_INVALID_VALUE");
                break;
            case GL_INVALID_OPERATION:
                errors.emplace_back("GL_INVALID_OPERATION");
                break;
            case GL_INVALID_FRAMEBUFFER_OPERATION:
                errors.emplace_back("GL_INVALID_FRAMEBUFFER_OPERATION");
                break;
            case GL_OUT_OF_MEMORY:
                errors.emplace_back("GL_OUT_OF_MEMORY");
                break;
            default:
                errors.emplace_back("GL error " + std::to_string(code));
                return errors;
        }
    }
    return errors;
}

}  // namespace mv
