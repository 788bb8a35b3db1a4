#include "mv/gl/program.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "mv/error.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/editing.h"
#include "mv/gl/object.h"
#include "mv/gl/shader_source.h"
#include "mv/gl/tangent_buffer.h"
#include "mv/math/require.h"

namespace mv {
namespace {

struct Stage {
    const char* extension;
    GLenum kind;
    int since;            // the version of OpenGL that brought it
    const char* feature;  // what it is called in mv/gl/beyond_es.h, where ES 3.0 lacks it
};
constexpr Stage stages[] = {{"vert", GL_VERTEX_SHADER, 33, nullptr},
                            {"frag", GL_FRAGMENT_SHADER, 33, nullptr},
                            {"geom", GL_GEOMETRY_SHADER, 33, beyond_es::geometryShaders},
                            {"tesc", GL_TESS_CONTROL_SHADER, 40, beyond_es::tessellation},
                            {"tese", GL_TESS_EVALUATION_SHADER, 40, beyond_es::tessellation},
                            {"comp", GL_COMPUTE_SHADER, 43, beyond_es::computeShaders}};

const Stage& stageOf(const std::string& file) {
    for (const Stage& stage : stages) {
        if (file.ends_with(std::string(".") + stage.extension)) return stage;
    }
    throw Error("shaders/" + file, "must end in .vert, .tesc, .tese, .geom, .frag or .comp");
}

// The version that all stages of a program are compiled for: as new as the newest of them needs.
int versionFor(const std::string& program, const std::vector<std::string>& files) {
    int version = 33;
    for (const std::string& file : files) {
        const Stage& stage = stageOf(file);
        version = std::max(version, stage.since);
        if (!stage.feature) continue;
        const std::optional<Newer> newer = newerThan33(stage.feature);
        if (isEs() || (newer && !isAllowed(*newer))) {
            throw Error("program " + program,
                        std::string("needs ") + stage.feature +
                            "; declare them in .needs = {.beyondEs = ...}, and ask has() before it is made");
        }
    }
    return version;
}

struct Uniform {
    GLint location;
    GLenum type;
    GLint count;  // elements, 1 but for an array
};

// The sources of a program, by stage; made anew for each compilation, so that an edited file is read again.
using Sources = std::vector<std::pair<GLenum, ShaderSource>>;

struct Linked {
    ProgramObject program;
    std::optional<GLenum> lastPrimitive;  // what the geometry stage gives, or else the tessellation
    std::map<std::string, Uniform, std::less<>> uniforms;
    std::optional<bool> measuring;  // as the program was told last
    bool edited = false;
};

std::string shaderLog(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    return log;
}

// Not asked how that went: the driver may still be at it.
ShaderObject compile(GLenum kind, const ShaderSource& source) {
    ShaderObject shader(glCreateShader(kind));
    const char* text = source.text.c_str();
    glShaderSource(shader.id(), 1, &text, nullptr);
    glCompileShader(shader.id());
    labelObject(GL_SHADER, shader.id(), source.files.front());
    return shader;
}

void requireCompiled(const ShaderObject& shader, const ShaderSource& source) {
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return;
    takeErrors();  // KHR_debug repeats the log, which the Error has
    throw Error(source.files.front(), "must compile", "\n" + readableLog(shaderLog(shader.id()), source));
}

std::map<std::string, Uniform, std::less<>> activeUniforms(GLuint program) {
    std::map<std::string, Uniform, std::less<>> uniforms;
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        char name[256];
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, static_cast<GLuint>(i), sizeof name, nullptr, &size, &type, name);
        // OpenGL tells an array by the name of its first element. The array is known by its own name, and by those of
        // its elements.
        const std::string first(name);
        const bool isArray = first.ends_with("[0]");
        const std::string whole = isArray ? first.substr(0, first.size() - 3) : first;
        uniforms[whole] = {glGetUniformLocation(program, name), type, size};
        for (GLint element = 0; isArray && element < size; ++element) {
            const std::string one = whole + "[" + std::to_string(element) + "]";
            uniforms[one] = {glGetUniformLocation(program, one.c_str()), type, 1};
        }
    }
    return uniforms;
}

// As transform feedback takes it.
GLenum separatePrimitive(GLenum mode) {
    switch (mode) {
        case GL_POINTS:
            return GL_POINTS;
        case GL_LINES:
        case GL_LINE_STRIP:
        case GL_LINE_LOOP:
        case GL_ISOLINES:
            return GL_LINES;
        default:
            return GL_TRIANGLES;
    }
}

std::optional<GLenum> lastPrimitive(GLuint program, const Sources& sources) {
    const auto has = [&](GLenum kind) {
        return std::any_of(sources.begin(), sources.end(), [&](const auto& source) { return source.first == kind; });
    };
    const auto ask = [&](GLenum what) {
        GLint answer = 0;
        glGetProgramiv(program, what, &answer);
        return static_cast<GLenum>(answer);
    };
    if (has(GL_GEOMETRY_SHADER)) return separatePrimitive(ask(GL_GEOMETRY_OUTPUT_TYPE));
    if (!has(GL_TESS_EVALUATION_SHADER)) return {};
    return ask(GL_TESS_GEN_POINT_MODE) == GL_TRUE ? GLenum(GL_POINTS) : separatePrimitive(ask(GL_TESS_GEN_MODE));
}

Linked link(const std::string& name, const Sources& sources) {
    Linked linked;
    for (const auto& [kind, source] : sources) linked.edited = linked.edited || source.edited;
    linked.program = ProgramObject(glCreateProgram());
    const GLuint program = linked.program.id();
    std::vector<ShaderObject> shaders;
    for (const auto& [kind, source] : sources) {
        shaders.push_back(compile(kind, source));
        glAttachShader(program, shaders.back().id());
    }
    glBindAttribLocation(program, static_cast<GLuint>(Attribute::position), "position");
    glBindAttribLocation(program, static_cast<GLuint>(Attribute::normal), "normal");
    glBindAttribLocation(program, static_cast<GLuint>(Attribute::color), "color");
    glBindAttribLocation(program, static_cast<GLuint>(Attribute::texCoord), "texCoord");
    glBindAttribLocation(program, tangentLocation, "tangent");
    // So that countTriangles() can read back where each vertex went; costs nothing while no capture is active.
    if (sources.front().first != GL_COMPUTE_SHADER) {
        const char* captured = "gl_Position";
        glTransformFeedbackVaryings(program, 1, &captured, GL_INTERLEAVED_ATTRIBS);
    }
    glLinkProgram(program);
    for (const ShaderObject& shader : shaders) glDetachShader(program, shader.id());

    GLint ok = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    if (ok != GL_TRUE) {
        for (std::size_t i = 0; i < shaders.size(); ++i) requireCompiled(shaders[i], sources[i].second);
        takeErrors();
        GLint length = 0;
        glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
        std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
        glGetProgramInfoLog(program, length, nullptr, log.data());
        throw Error("program " + name, "must link", "\n" + readableLog(log, {}));
    }
    labelObject(GL_PROGRAM, program, name);
    linked.uniforms = activeUniforms(program);
    linked.lastPrimitive = lastPrimitive(program, sources);
    return linked;
}

// A number beyond float's range would arrive as infinity: it is refused like one.
void requireFinite(const char* name, const double* values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        if (!fitsFloat(values[i]))
            throw Error(std::string("uniform ") + name, "must be finite as a float", numberText(values[i]));
    }
}

}  // namespace

struct Program::State {
    std::string name;
    std::function<Sources()> sources;
    Linked linked;
    decltype(ShaderSource::readFrom) files;  // all that were read for it, those that made no program, too
    std::string error;                       // why the files as they are now make no program; "" where they do

    // Reads the files as they are now, and makes the program of them. Error: they make none; the last one stays.
    void build() {
        const Sources read = sources();
        decltype(files) now;
        for (const auto& [kind, source] : read) now.insert(source.readFrom.begin(), source.readFrom.end());
        files.insert(now.begin(), now.end());
        linked = link(name, read);
        files = std::move(now);
    }
    // Whether a file was written anew, or is there again. One that is gone is waited for: an editor may be replacing it.
    bool changed() {
        bool any = false;
        for (auto& [path, time] : files) {
            const auto now = writtenAt(path);
            if (!now || now == time) continue;
            time = now;
            any = true;
        }
        return any;
    }
};

// The live programs, for reloading.
struct ProgramList {
    static std::vector<Program::State*>& all() {
        static auto& list = *new std::vector<Program::State*>;  // outlives every static that owns a Program
        return list;
    }
    static std::vector<std::filesystem::path> files() {
        std::set<std::filesystem::path> every;
        for (const Program::State* state : all()) {
            for (const auto& [path, time] : state->files) every.insert(path);
        }
        return {every.begin(), every.end()};
    }
    static Reloaded reload() {
        Reloaded result;
        for (Program::State* state : all()) {
            if (!state->changed()) continue;
            try {
                state->build();
                state->error.clear();
                ++result.programs;
            } catch (const Error& error) {
                state->error = error.what();
                result.errors.push_back(state->error);
            }
        }
        for (const Program::State* state : all()) {
            if (!state->error.empty()) result.standing.push_back(state->error);
        }
        return result;
    }
};

namespace {
GLuint programInUse = 0;
bool isMeasuring = false;
std::map<std::string, std::set<std::string>> unusedUniforms;  // by program
}  // namespace

std::vector<std::string> takeUnusedUniforms() {
    std::vector<std::string> all;
    for (const auto& [program, names] : std::exchange(unusedUniforms, {})) {
        std::string list;
        for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
        all.push_back(list + " of " + program);
    }
    return all;
}

std::vector<std::filesystem::path> filesOfPrograms() { return ProgramList::files(); }

std::string mistakesOf(const std::string& file) {
    const Stage& stage = stageOf(file);
    if (stage.feature && isEs()) return "";
    try {
        const ShaderSource source = assembleShader(file, stage.since);
        requireCompiled(compile(stage.kind, source), source);
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

bool setMeasuring(bool measuring) { return std::exchange(isMeasuring, measuring); }

Program::Program() = default;

Program::Program(std::unique_ptr<State> state) : state_(std::move(state)) {
    state_->build();
    ProgramList::all().push_back(state_.get());
}

Program::Program(const std::string& stem, const std::string& variant) {
    const std::string name = variant.empty() ? stem : stem + "." + variant;
    // In the demo's own folder, where it has one
    const std::string inFolder = stem + "/" + (variant.empty() ? stem : variant);
    const bool isInFolder = hasShaderFile(inFolder + ".vert") || hasShaderFile(inFolder + ".comp");
    const std::string& path = isInFolder ? inFolder : name;
    std::vector<std::string> files{path + ".comp"};
    if (!hasShaderFile(files.front())) {
        files = {path + ".vert", path + ".frag"};
        for (const char* more : {".geom", ".tesc", ".tese"}) {
            if (hasShaderFile(path + more)) files.push_back(path + more);
        }
    }
    *this = fromFiles(name, files);
}

Program Program::fromFiles(const std::string& name, const std::vector<std::string>& files) {
    auto state = std::make_unique<State>();
    state->name = name;
    state->sources = [name, files] {
        Sources sources;
        const int version = versionFor(name, files);
        for (const std::string& file : files) sources.emplace_back(stageOf(file).kind, assembleShader(file, version));
        return sources;
    };
    return Program(std::move(state));
}

Program Program::fromTexts(const std::string& name, const std::vector<std::pair<std::string, std::string>>& texts) {
    auto state = std::make_unique<State>();
    state->name = name;
    state->sources = [name, texts] {
        std::vector<std::string> files(texts.size(), name + ".");
        for (std::size_t i = 0; i < texts.size(); ++i) files[i] += texts[i].first;
        Sources sources;
        const int version = versionFor(name, files);
        for (std::size_t i = 0; i < files.size(); ++i)
            sources.emplace_back(stageOf(files[i]).kind, assembleShaderText(files[i], texts[i].second, version));
        return sources;
    };
    return Program(std::move(state));
}

Program Program::fromText(const std::string& name, const std::string& vertex, const std::string& fragment) {
    return fromTexts(name, {{"vert", vertex}, {"frag", fragment}});
}

Program::Program(Program&&) noexcept = default;

Program& Program::operator=(Program&& other) noexcept {
    std::swap(state_, other.state_);
    return *this;
}

Program::~Program() {
    if (!state_) return;
    std::erase(ProgramList::all(), state_.get());
    if (programInUse == id()) programInUse = 0;
}

GLuint Program::id() const { return state_ ? state_->linked.program.id() : 0; }

GLenum Program::primitiveOut(GLenum mode) const {
    if (!state_) throw Error("Program", "must be made from shaders before it is asked");
    return state_->linked.lastPrimitive.value_or(separatePrimitive(mode));
}

void Program::use() const {
    if (!state_) throw Error("Program", "must be made from shaders before it is used");
    glUseProgram(id());
    programInUse = id();
    Linked& linked = state_->linked;  // a program made anew has been told nothing
    if (linked.measuring == isMeasuring) return;
    linked.measuring = isMeasuring;
    if (const auto found = linked.uniforms.find(std::string_view("measuring")); found != linked.uniforms.end())
        glUniform1i(found->second.location, isMeasuring ? 1 : 0);
}

GLint Program::location(const char* name, std::initializer_list<GLenum> types, int count) const {
    if (id() == 0 || programInUse != id()) {
        throw Error(std::string("uniform ") + name, "is set on the program in use; call use() first");
    }
    const auto found = state_->linked.uniforms.find(std::string_view(name));
    if (found == state_->linked.uniforms.end() && state_->linked.edited) {
        unusedUniforms[state_->name].insert(name);
        return -1;  // what OpenGL leaves out without a word
    }
    if (found == state_->linked.uniforms.end()) {
        std::string list;
        for (const auto& [active, uniform] : state_->linked.uniforms) list += (list.empty() ? "" : ", ") + active;
        throw Error(std::string("uniform ") + name,
                    "must be in program " + state_->name + " and used by it; it has " + (list.empty() ? "none" : list));
    }
    if (std::find(types.begin(), types.end(), found->second.type) == types.end()) {
        throw Error(std::string("uniform ") + name, "must be set with the type the shader declares");
    }
    if (found->second.count != count) {
        throw Error(std::string("uniform ") + name,
                    "must be set with as many elements as it has, " + std::to_string(found->second.count),
                    std::to_string(count));
    }
    return found->second.location;
}

void Program::set(const char* name, double value) const {
    requireFinite(name, &value, 1);
    glUniform1f(location(name, {GL_FLOAT}), static_cast<GLfloat>(value));
}
void Program::set(const char* name, int value) const {
    glUniform1i(location(name, {GL_INT, GL_BOOL, GL_SAMPLER_2D, GL_SAMPLER_2D_SHADOW, GL_SAMPLER_3D, GL_SAMPLER_CUBE,
                                GL_UNSIGNED_INT_SAMPLER_2D}),
                value);
}
void Program::set(const char* name, const vec2& value) const {
    requireFinite(name, &value.x, 2);
    const fvec2 rounded(value);
    glUniform2fv(location(name, {GL_FLOAT_VEC2}), 1, &rounded.x);
}
void Program::set(const char* name, const vec3& value) const {
    requireFinite(name, &value.x, 3);
    const fvec3 rounded(value);
    glUniform3fv(location(name, {GL_FLOAT_VEC3}), 1, &rounded.x);
}
void Program::set(const char* name, std::span<const vec3> values) const {
    std::vector<fvec3> rounded;
    for (const vec3& value : values) {
        requireFinite(name, &value.x, 3);
        rounded.emplace_back(value);
    }
    const auto count = static_cast<GLsizei>(values.size());
    glUniform3fv(location(name, {GL_FLOAT_VEC3}, count), count, &rounded.front().x);
}
void Program::set(const char* name, const vec4& value) const {
    requireFinite(name, &value.x, 4);
    const fvec4 rounded(value);
    glUniform4fv(location(name, {GL_FLOAT_VEC4}), 1, &rounded.x);
}
void Program::set(const char* name, const mat3& value) const {
    requireFinite(name, &value[0].x, 9);
    const fmat3 rounded(value);
    glUniformMatrix3fv(location(name, {GL_FLOAT_MAT3}), 1, GL_FALSE, &rounded[0].x);
}
void Program::set(const char* name, const mat4& value) const {
    requireFinite(name, &value[0].x, 16);
    const fmat4 rounded(value);
    glUniformMatrix4fv(location(name, {GL_FLOAT_MAT4}), 1, GL_FALSE, &rounded[0].x);
}

Reloaded reloadChangedPrograms() { return ProgramList::reload(); }

}  // namespace mv
