// Two demos for the tests of the window: one with every kind of knob, that moves, and one that cannot be opened.
//
// PROBE_SHADERS names a folder with probe.vert and probe.frag to read and watch, so that a test edits files of its own.
#include <cstdlib>
#include <string>

#include "mv/demo/demo.h"
#include "mv/gl/gl.h"
#include "mv/gl/object.h"
#include "mv/gl/shader_source.h"

using namespace mv;

namespace {

std::string watched(const std::string& name) {
    const char* folder = std::getenv("PROBE_SHADERS");
    return folder ? std::string(folder) + "/" + name : "";
}

const bool vertexAdded = addShaderFile("probe.vert", R"(
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(corner - 0.5, 0.0, 1.0);
}
)",
                                       watched("probe.vert"));
const bool fragmentAdded = addShaderFile("probe.frag", R"(
uniform float level;
out vec4 fragColor;
void main() { fragColor = vec4(level, 0.5, 0.5, 1.0); }
)",
                                         watched("probe.frag"));

enum class Mood { calm, loud };

struct Probe final : Demo {
    Real level{this, "level", 0.25, {0, 1}, "how red the square is; 1 is refused together with mood loud"};
    Whole count{this, "count", 3, {1, 9}, "a whole number", "pieces"};
    Toggle note{this, "note", false, "say a sentence about the picture"};
    Choice<Mood> mood{this,
                      "mood",
                      Mood::calm,
                      {{"calm", "nothing is refused and the picture is as it is"}, {"loud", "a level of 1 is refused"}},
                      "what is refused"};
    Angle angle{this, "angle", 0, "an angle that turns on"};

    Readout shown{this, "shown", "the frame that is shown"};
    Readout never{this, "never", "what no setting measures", "px"};

    Program program;
    VertexArray vertexArray;

    Probe() {
        bindKey(key('4'), count, "4");
        bindKeys(key('N'), key('S'), level, 0.125);  // S is the window's own key for saving, too
        bindDrag(angle, 1, level, 0.001);
    }

    void init() override {
        program = Program("probe");
        vertexArray = makeVertexArray();
    }
    void check() const override {
        if (mood == Mood::loud && level == 1) throw Error("--level", "must be less than 1 while --mood is loud");
    }
    void draw(const Frame& frame) override {
        glDisable(GL_SCISSOR_TEST);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glClearColor(0.2F, 0.3F, static_cast<float>(frame.index() % 60) / 60, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        program.use();
        program.set("level", double(level));
        glBindVertexArray(vertexArray.id());
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        glBindVertexArray(0);
        // Left on: the window must not show half of a picture for it.
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, frame.width() / 2, frame.height() / 2);
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
        frame.show("screenFromFrame", mat4(double(frame.index())));
        if (note) frame.say("This sentence is beside the picture because --note is on.");
        shown = frame.index();
    }
};

struct Broken final : Demo {
    void init() override { throw Error("broken", "must never open; that is what it is for"); }
    void draw(const Frame&) override {}
};

const bool probeAdded = addDemo<Probe>({
    .name = "probe",
    .sentence = "Every kind of knob, and a square whose background moves.",
    .lookFor = "The background goes from green to blue once a second.",
    .chapter = "Probes",
    .number = 1,
    .width = 400,
    .height = 300,
    .animated = true,
});
const bool brokenAdded = addDemo<Broken>({
    .name = "broken",
    .sentence = "A demo that cannot be opened.",
    .lookFor = "",
    .chapter = "Probes",
    .number = 2,
});

}  // namespace
