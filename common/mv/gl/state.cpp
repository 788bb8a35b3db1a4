#include "mv/gl/state.h"

#include <array>
#include <cstdio>
#include <map>
#include <tuple>

#include "mv/error.h"
#include "mv/gl/functions.h"
#include "mv/gl/layer.h"
#include "mv/gl/state_names.h"

namespace mv {
namespace {

template <class Function>
struct Arguments;
template <class... A>
struct Arguments<void (*)(A...)> {
    using type = std::tuple<A...>;
};

// The calls that set one thing to what they are given: X(name, OpenGL's initial values).
#define MV_PLAIN_STATE(X)                                  \
    X(ActiveTexture, GL_TEXTURE0)                          \
    X(BindVertexArray, 0)                                  \
    X(BlendEquation, GL_FUNC_ADD)                          \
    X(BlendFuncSeparate, GL_ONE, GL_ZERO, GL_ONE, GL_ZERO) \
    X(ClearColor, 0, 0, 0, 0)                              \
    X(ClearDepth, 1)                                       \
    X(ClearStencil, 0)                                     \
    X(ClipControl, GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE)  \
    X(ColorMask, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE)       \
    X(CullFace, GL_BACK)                                   \
    X(DepthFunc, GL_LESS)                                  \
    X(DepthMask, GL_TRUE)                                  \
    X(DepthRange, 0, 1)                                    \
    X(FrontFace, GL_CCW)                                   \
    X(LineWidth, 1)                                        \
    X(PatchParameteri, GL_PATCH_VERTICES, 3)               \
    X(PolygonMode, GL_FRONT_AND_BACK, GL_FILL)             \
    X(PolygonOffset, 0, 0)                                 \
    X(SampleCoverage, 1, GL_FALSE)                         \
    X(StencilMask, ~0U)                                    \
    X(UseProgram, 0)

bool initiallyOn(GLenum capability) { return capability == GL_DITHER || capability == GL_MULTISAMPLE; }

using StencilTest = std::tuple<GLenum, GLint, GLuint>;
using StencilChange = std::tuple<GLenum, GLenum, GLenum>;

struct Values {
#define X(name, ...) Arguments<decltype(gl##name)>::type name{__VA_ARGS__};
    MV_PLAIN_STATE(X)
#undef X
    // front, back
    std::array<StencilTest, 2> stencilTest{StencilTest(GL_ALWAYS, 0, ~0U), StencilTest(GL_ALWAYS, 0, ~0U)};
    std::array<StencilChange, 2> stencilChange{StencilChange(GL_KEEP, GL_KEEP, GL_KEEP),
                                               StencilChange(GL_KEEP, GL_KEEP, GL_KEEP)};
    // The values that differ from the initial one, and nothing else: so that equal states are equal maps.
    std::map<GLenum, bool> switches;
    std::map<GLenum, GLint> pixelStore;                    // initially 4, the alignments
    std::map<GLenum, GLuint> buffers;                      // by target; initially 0
    std::map<std::pair<GLenum, GLenum>, GLuint> textures;  // by unit and target; initially 0
};
Values now;

template <class Map, class Key, class Value>
void keep(Map& map, const Key& key, const Value& value, const Value& initial) {
    if (value == initial) {
        map.erase(key);
    } else {
        map[key] = value;
    }
}

// ---- The layer hears each call that was taken.

template <class T>
void keepFaces(std::array<T, 2>& faces, GLenum face, const T& value) {
    if (face != GL_BACK) faces[0] = value;
    if (face != GL_FRONT) faces[1] = value;
}

// GL unbinds what is deleted; another object may then be given its name.
void forgetName(auto& bindings, GLuint name) {
    std::erase_if(bindings, [&](const auto& binding) { return binding.second == name; });
}

struct Keeper {
#define X(name, ...) \
    void after_##name(auto... arguments) { now.name = {arguments...}; }
    MV_PLAIN_STATE(X)
#undef X
    void after_Enable(GLenum capability) { keep(now.switches, capability, true, initiallyOn(capability)); }
    void after_Disable(GLenum capability) { keep(now.switches, capability, false, initiallyOn(capability)); }
    void after_BlendFunc(GLenum from, GLenum to) { now.BlendFuncSeparate = {from, to, from, to}; }
    void after_StencilFuncSeparate(GLenum face, GLenum function, GLint reference, GLuint mask) {
        keepFaces(now.stencilTest, face, {function, reference, mask});
    }
    void after_StencilFunc(GLenum function, GLint reference, GLuint mask) {
        keepFaces(now.stencilTest, GL_FRONT_AND_BACK, {function, reference, mask});
    }
    void after_StencilOpSeparate(GLenum face, GLenum fail, GLenum depthFail, GLenum pass) {
        keepFaces(now.stencilChange, face, {fail, depthFail, pass});
    }
    void after_StencilOp(GLenum fail, GLenum depthFail, GLenum pass) {
        keepFaces(now.stencilChange, GL_FRONT_AND_BACK, {fail, depthFail, pass});
    }
    void after_PixelStorei(GLenum name, GLint value) { keep(now.pixelStore, name, value, 4); }
    void after_BindTexture(GLenum target, GLuint texture) {
        keep(now.textures, std::pair{std::get<0>(now.ActiveTexture), target}, texture, 0U);
    }
    void after_BindBuffer(GLenum target, GLuint buffer) {
        if (target != GL_ELEMENT_ARRAY_BUFFER) keep(now.buffers, target, buffer, 0U);  // that one is the vertex array's
    }
    void after_DeleteTextures(GLsizei count, const GLuint* names) {
        for (GLsizei i = 0; i < count; ++i) forgetName(now.textures, names[i]);
    }
    void after_DeleteBuffers(GLsizei count, const GLuint* names) {
        for (GLsizei i = 0; i < count; ++i) forgetName(now.buffers, names[i]);
    }
    void after_DeleteVertexArrays(GLsizei count, const GLuint* names) {
        for (GLsizei i = 0; i < count; ++i) {
            if (std::get<0>(now.BindVertexArray) == names[i]) now.BindVertexArray = {0};
        }
    }
    void before_DeleteProgram(GLuint program) {
        // GL keeps one that is in use until another one is used, which then may not be this one again.
        if (program != 0 && std::get<0>(now.UseProgram) == program) glUseProgram(0);
    }
};
Keeper keeper;

// ---- Putting back

// The calls that lead from one state to another, gathered before any is: setting changes the map that is asked.
template <class Map, class Initial>
Map differences(const Map& from, const Map& to, Initial initial) {
    Map changes = to;
    for (const auto& [key, value] : from) {
        const auto [wanted, isNew] = changes.try_emplace(key, initial(key));
        if (!isNew && wanted->second == value) changes.erase(wanted);
    }
    return changes;
}

// Sets what differs from `wanted`, by the table, so that who listens hears it; how many calls it took.
int change(const Values& wanted) {
    int calls = 0;
    // The units' textures first: they move the active unit.
    for (const auto& [place, texture] : differences(now.textures, wanted.textures, [](auto) { return 0U; })) {
        if (std::get<0>(now.ActiveTexture) != place.first) glActiveTexture(place.first), ++calls;
        glBindTexture(place.second, texture);
        ++calls;
    }
#define X(name, ...)                       \
    if (now.name != wanted.name) {         \
        std::apply(gl##name, wanted.name); \
        ++calls;                           \
    }
    MV_PLAIN_STATE(X)
#undef X
    for (const int side : {0, 1}) {
        const auto at = static_cast<std::size_t>(side);
        const GLenum face = side == 0 ? GL_FRONT : GL_BACK;
        if (now.stencilTest[at] != wanted.stencilTest[at]) {
            std::apply([&](auto... v) { glStencilFuncSeparate(face, v...); }, wanted.stencilTest[at]);
            ++calls;
        }
        if (now.stencilChange[at] != wanted.stencilChange[at]) {
            std::apply([&](auto... v) { glStencilOpSeparate(face, v...); }, wanted.stencilChange[at]);
            ++calls;
        }
    }
    for (const auto& [capability, on] : differences(now.switches, wanted.switches, initiallyOn)) {
        on ? glEnable(capability) : glDisable(capability);
        ++calls;
    }
    for (const auto& [name, value] : differences(now.pixelStore, wanted.pixelStore, [](GLenum) { return 4; })) {
        glPixelStorei(name, value);
        ++calls;
    }
    for (const auto& [target, buffer] : differences(now.buffers, wanted.buffers, [](GLenum) { return 0U; })) {
        glBindBuffer(target, buffer);
        ++calls;
    }
    return calls;
}

}  // namespace

int restoreInitialState() { return change({}); }

void setEnabled(GLenum capability, bool isOn) {
    const auto found = now.switches.find(capability);
    const bool wasOn = found == now.switches.end() ? initiallyOn(capability) : found->second;
    if (wasOn != isOn) (isOn ? glEnable : glDisable)(capability);
}

void setOverlayState(Overlay overlay) {
    Values wanted = now;
    for (const auto capability : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_POLYGON_OFFSET_FILL}) {
        wanted.switches.erase(static_cast<GLenum>(capability));
    }
    wanted.switches[GL_BLEND] = true;
    wanted.BlendEquation = {GL_FUNC_ADD};
    wanted.BlendFuncSeparate = {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA};
    if (overlay == Overlay::hiddenByWhatIsNearer) {
        wanted.switches[GL_DEPTH_TEST] = true;
        wanted.DepthFunc = {GL_LEQUAL};
        wanted.DepthMask = {GL_FALSE};
    }
    change(wanted);
}

std::vector<std::string> changedState() {
    const Values initial;
    std::vector<std::string> calls;
#define X(name, ...)              \
    if (now.name != initial.name) \
        calls.emplace_back(#name == std::string("BlendFuncSeparate") ? "glBlendFunc" : "gl" #name);
    MV_PLAIN_STATE(X)
#undef X
    if (now.stencilTest != initial.stencilTest) calls.emplace_back("glStencilFunc");
    if (now.stencilChange != initial.stencilChange) calls.emplace_back("glStencilOp");
    for (const auto& [capability, on] : now.switches) {
        calls.push_back((on ? "glEnable(" : "glDisable(") + stateName(capability) + ")");
    }
    if (!now.pixelStore.empty()) calls.emplace_back("glPixelStorei");
    if (!now.buffers.empty()) calls.emplace_back("glBindBuffer");
    if (!now.textures.empty()) calls.emplace_back("glBindTexture");
    return calls;
}

namespace {

// One argument as it is written in a program: the calls of plain state take names where they take whole numbers, but for a
// mask and a number of vertices.
std::string argumentText(GLenum value) { return valueName(value); }
std::string argumentText(GLboolean value) { return value == GL_TRUE ? "GL_TRUE" : "GL_FALSE"; }
std::string argumentText(GLint value) { return std::to_string(value); }
std::string argumentText(double value) { return numberText(value); }
std::string argumentText(float value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%g", double(value));
    return text.data();
}

template <class... Values>
std::string callText(const std::string& name, const std::tuple<Values...>& values) {
    std::string text;
    std::apply([&](auto... value) { ((text += (text.empty() ? "" : ", ") + argumentText(value)), ...); }, values);
    return "gl" + name + "(" + text + ")";
}

// The words of one call, for each face where the two differ, else for both.
template <class Tuple, class Write>
void addFaces(std::vector<std::string>& calls, const std::string& name, const std::array<Tuple, 2>& faces,
              const Tuple& initial, const Write& write) {
    if (faces[0] == faces[1]) {
        if (faces[0] != initial) calls.push_back("gl" + name + "(" + write(faces[0]) + ")");
        return;
    }
    for (const int side : {0, 1}) {
        const Tuple& values = faces[static_cast<std::size_t>(side)];
        if (values != initial) {
            calls.push_back("gl" + name + "Separate(" + (side == 0 ? "GL_FRONT, " : "GL_BACK, ") + write(values) + ")");
        }
    }
}

}  // namespace

std::vector<std::string> stateOfDraw() {
    const Values initial;
    std::vector<std::string> calls;
    for (const auto& [capability, on] : now.switches) {
        calls.push_back((on ? "glEnable(" : "glDisable(") + stateName(capability) + ")");
    }
    const auto add = [&](const std::string& name, const auto& value, const auto& wanted) {
        if (value == wanted) return;
        if (name == "StencilMask") {
            calls.push_back("glStencilMask(" + hexadecimal(std::get<0>(now.StencilMask)) + ")");
        } else if (name != "ActiveTexture" && name != "BindVertexArray" && name != "UseProgram") {
            calls.push_back(callText(name, value));
        }
    };
#define X(name, ...) add(#name, now.name, initial.name);
    MV_PLAIN_STATE(X)
#undef X
    addFaces(calls, "StencilFunc", now.stencilTest, initial.stencilTest[0], [](const StencilTest& test) {
        return valueName(std::get<0>(test)) + ", " + std::to_string(std::get<1>(test)) + ", " +
               hexadecimal(std::get<2>(test));
    });
    addFaces(calls, "StencilOp", now.stencilChange, initial.stencilChange[0], [](const StencilChange& change) {
        const auto operation = [](GLenum value) {
            return value == GL_ZERO ? std::string("GL_ZERO") : valueName(value);
        };
        return operation(std::get<0>(change)) + ", " + operation(std::get<1>(change)) + ", " +
               operation(std::get<2>(change));
    });
    for (const auto& [place, texture] : now.textures) {
        calls.push_back("glBindTexture(" + valueName(place.second) + ", " + labelOf(GL_TEXTURE, texture) +
                        ") on unit " + std::to_string(place.first - GL_TEXTURE0));
    }
    return calls;
}

struct StateScope::Saved {
    Values values;
};
StateScope::StateScope() : saved_(std::make_unique<Saved>(Saved{now})) {}
StateScope::~StateScope() { change(saved_->values); }

void forgetState() { now = {}; }

void keepState() { Layer<Keeper>::layOver(keeper); }

}  // namespace mv
