// A linked GLSL program, made from the shader files of its name.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mv/gl/functions.h"
#include "mv/math/types.h"

namespace mv {

// Vertex attributes have one fixed location each; a shader declares those it uses by these names.
enum class Attribute : GLuint { position = 0, normal = 1, color = 2, texCoord = 3 };

class Program {
  public:
    Program();
    // Compiles shaders/<stem>[.<variant>].vert and .frag (and .geom, .tesc, .tese where they exist) and links them; or .comp
    // alone, where there is such a file. The files of a demo with a folder of shaders are shaders/<stem>/<variant>.vert
    // ..., without a variant shaders/<stem>/<stem>.vert ... With stages of tessellation all of it is GLSL 4.00, a compute shader is 4.30.
    // Error: "shaders/<stem>.frag:7: message" for each mistake; a stage that the context lacks, or that the demo did not
    // declare: has() in mv/gl/beyond_es.h is to be asked before.
    explicit Program(const std::string& stem, const std::string& variant = "");
    // The same of these files, one a stage, known by their endings: programs may share files, and leave a stage out.
    //     Program::fromFiles("patch", {"hill.vert", "hill.tesc", "hill.tese", "lines.geom", "hill.frag"})
    static Program fromFiles(const std::string& name, const std::vector<std::string>& files);
    // From texts of the framework itself; `name` stands for the file name in messages.
    static Program fromText(const std::string& name, const std::string& vertex, const std::string& fragment);
    // The same of any stages, each by its ending: {{"vert", ...}, {"geom", ...}, {"frag", ...}}.
    static Program fromTexts(const std::string& name, const std::vector<std::pair<std::string, std::string>>& texts);
    Program(Program&&) noexcept;
    Program& operator=(Program&&) noexcept;
    ~Program();

    // Makes it the current program; set() and draws refer to that. Tells it whether to measure, see setMeasuring().
    void use() const;

    // Sets a uniform of the current program. Matrices and vectors are rounded to float here, once. The name may be that
    // of one element of an array: "place[3]". Error: no active uniform of that name, another type, another number of
    // elements, a number that is not finite, or the program is not in use.
    void set(const char* name, double value) const;
    void set(const char* name, int value) const;  // also bool and samplers (the texture unit)
    void set(const char* name, bool value) const { set(name, value ? 1 : 0); }
    void set(const char* name, const vec2& value) const;
    void set(const char* name, const vec3& value) const;
    void set(const char* name, const vec4& value) const;
    void set(const char* name, std::span<const vec3> values) const;  // all elements of an array, one at least
    void set(const char* name, const mat3& value) const;
    void set(const char* name, const mat4& value) const;

    GLuint id() const;
    // The primitive that the last stage before the rasterizer gives it, of a draw with this mode, as transform feedback
    // takes it: GL_POINTS, GL_LINES or GL_TRIANGLES; strips, fans and patches are those they stand for.
    GLenum primitiveOut(GLenum mode) const;

  private:
    friend struct ProgramList;
    struct State;
    explicit Program(std::unique_ptr<State> state);
    GLint location(const char* name, std::initializer_list<GLenum> types, int count = 1) const;
    std::unique_ptr<State> state_;
};

// From now on each program that declares `uniform bool measuring` (shaders/include/measure.glsl) is told this by use(): to
// draw a quantity instead of a picture. Returns what held before. For the framework, which asks a demo for its quantity.
bool setMeasuring(bool measuring);

// The results for the programs whose files were edited.
struct Reloaded {
    int programs = 0;                 // compiled anew
    std::vector<std::string> errors;  // one for each that failed; its last good version stays in use
    // The errors of now and of earlier calls whose files are still as they were: what a window goes on showing.
    std::vector<std::string> standing;
};
// Compiles each program again one of whose files on disk has changed, or is there again after it was moved away (meanwhile
// what was built in stands for it). For developer builds; else nothing changes.
Reloaded reloadChangedPrograms();

}  // namespace mv
