// A demo: a lesson (mv/demo/lesson.h) as those see it who show it: a picture, and knobs and readouts by name. The framework owns the
// loop. A standalone program with a window and a panel, the same program without a window, a row in the launcher, the tests that move every
// knob, and the tables of its page all stand on this.
#pragma once
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mv/demo/binding.h"
#include "mv/demo/frame.h"
#include "mv/demo/handle.h"
#include "mv/demo/knob.h"
#include "mv/demo/memory.h"
#include "mv/demo/preset.h"
#include "mv/demo/readout.h"
#include "mv/demo/study.h"
#include "mv/error.h"
#include "mv/geometry/scene.h"

namespace mv {

struct AnyRow;  // mv/demo/row.h

class Demo {
  public:
    virtual ~Demo() = default;
    Demo() = default;
    Demo(const Demo&) = delete;
    Demo& operator=(const Demo&) = delete;

    // Makes the lesson's Gpu; a context is current. Called once, before the first draw.
    virtual void init() = 0;
    // Draws frame.index(): a pure function of the knobs and the index. OpenGL is in its initial state; the picture is the
    // target, all of it the viewport, and cleared where the demo declares its background. The framework undoes after
    // draw() what it has changed.
    virtual void draw(const Frame& frame) = 0;
    // Draws over that what only people need: a legend, the light's own ball, glass to look through. OpenGL's state is as
    // draw() left it. Left out where a quantity is measured instead of a picture.
    virtual void annotate(const Frame&) {}
    // Throws Error where settings that are each in range make no picture together (near beyond far, eye at the target).
    // Headless that ends the program; the window keeps its last picture and shows the sentence.
    virtual void check() const {}

    // For a lesson with start and step: what it remembers at frame 0, by the present knobs; and the way from frame index - 1
    // to `index`, 1/60 s later. Neither asks OpenGL for anything.
    virtual void reset() {}
    virtual void step(int /*index*/) {}

    // For a demo whose picture the processor makes, better with each of so many passes: rays, say, first for blocks of pixels
    // and then many for each. draw() shows what the passes so far have left; without a window it comes once, after the last
    // one, and in a window after each, so that a pass should take no longer than a frame may. 0: the picture has no passes.
    virtual int passes(const FrameInfo&) const { return 0; }
    // Makes pass `pass`, from 0, of that picture by the present knobs: 0 begins it anew, another one follows the one before.
    // The result of the last pass is a function of knobs, frame number and size. Asks nothing of OpenGL.
    virtual void refine(const FrameInfo& /*frame*/, int /*pass*/) {}

    // For a demo that draws a Scene: what it is at the present settings, in the picture that `frame` describes. The one
    // answer for draw(), check(), references and probes.
    virtual Scene scene(const FrameInfo& frame) const;
    // For a study of values: computes them for the present settings, without GL. The framework times this call.
    virtual std::vector<double> values() const;
    // Further numbers of these values, by name, that do not depend on the machine: steps, evaluations, energy lost.
    // Tables show them beside the errors.
    virtual std::vector<std::pair<std::string, double>> valueCounts() const { return {}; }

    // For a lesson (mv/demo/lesson.h): its settings, if they are of the type that has this tag.
    virtual bool copySettings(const void* /*type*/, void* /*to*/) const { return false; }

    const std::vector<Knob*>& knobs() const { return knobs_; }
    const std::vector<Readout*>& readouts() const { return readouts_; }
    const std::vector<Binding>& bindings() const { return bindings_; }
    const std::vector<Handle>& handles() const { return handles_; }
    // None for most.
    AnyMemory* memory() const { return memory_; }

    // The knob of that name, or Error naming the nearest one.
    Knob& knob(std::string_view name) const;
    // The present value of a knob, by name: as a number, or as the text of its flag. Error: no such knob, or no number.
    double number(std::string_view name) const;
    std::string word(std::string_view name) const { return knob(name).text(); }

    // Gestures, in the order of their bindings; true when a knob moved.
    bool press(Key key);
    bool drag(double across, double down);
    bool wheel(double notches);

  protected:
    // Makes the knob of a row, over these settings. Error: there is one of that name.
    void addRow(const AnyRow& row, void* settings, const void* initial);
    void addReadout(const Probe::Number& number);
    void addControl(const Control& control);
    // A handle of a place that these numbers move; `where` as in Handle. Error: one of them is no number.
    void addPlace(Literal name, const std::vector<Literal>& numbers,
                  std::function<std::optional<vec2>(const FrameInfo&)> where);
    // One for each of the points; `where` says where the value of one is. Error: they are no row of points.
    void addPlaces(Literal name, Literal points,
                   std::function<std::optional<vec2>(const FrameInfo&, const vec2& value)> where);
    // Error: a file that is set cannot be read.
    void checkFiles() const;

  private:
    friend class Readout;
    friend class AnyMemory;
    void add(Readout* readout) { readouts_.push_back(readout); }

    std::vector<Knob*> knobs_;
    std::vector<Readout*> readouts_;
    std::vector<Binding> bindings_;
    std::vector<Handle> handles_;
    AnyMemory* memory_ = nullptr;
    std::vector<std::unique_ptr<Knob>> madeKnobs_;
    std::vector<std::unique_ptr<Readout>> madeReadouts_;
    friend void addProbedReadouts(Demo& demo, std::string_view name);
};

// Something that a demo uses and OpenGL ES 3.0, which is WebGL 2's, lacks; older OpenGL may lack it, too (clip
// control). A demo can ask whether it is there: has() in mv/gl/beyond_es.h.
struct BeyondEs {
    Literal feature;    // by the name that mv/gl/beyond_es.h finds it by: "clip distances"
    Literal otherwise;  // what the demo does without it, a clause
};

// The needs of a demo: of the context and of its framebuffer. The stage makes no buffer that is not asked for.
struct Needs {
    bool depth = false;
    bool stencil = false;
    int samples = 0;  // 0 or what the driver has; another number is refused by name
    int gl = 33;      // core version, 10 * major + minor
    // All that ES 3.0 lacks and the demo uses in any of its settings: the visits hold it to the calls and formats it sees.
    std::initializer_list<BeyondEs> beyondEs = {};
};

// Needless work that a demo does on purpose, because its lesson is about it.
struct DeclaredWaste {
    Literal kind;    // as --audit names it: "no-sample"
    Literal what;    // what --audit says of it, word for word: "draw of 'cube'"
    Literal reason;  // one clause
};

// A demo's declaration, a constant: its lists stand in the program, and whoever keeps a copy of it has those.
struct Declaration {
    Literal name = {};              // kebab-case; the program, the page and the shaders have the same name
    Literal sentence = {};          // what it shows
    Literal lookFor = {};           // what to look for, one sentence
    Literal chapter = {};           // the heading it stands under: one of mv/demo/chapters.h, or none
    int number = 0;                 // its row in the course's catalogue, which orders a chapter
    int width = 512, height = 512;  // the original's canvas
    bool animated = false;          // the picture depends on the frame index; always so with a Memory
    // The colour that the picture is cleared to before each draw, with depth to 1 and the stencil to 0; without one, the
    // demo clears. A measured quantity is cleared to -1, which is nothing to compare, by either.
    std::optional<vec4> background = {};
    Needs needs = {};
    std::initializer_list<DeclaredWaste> waste = {};
};

// The facts about a demo that are known before one is made.
struct DemoInfo : Declaration {
    // Two to six settings worth a look. The first has none of its own: it is the knobs' initial values, which are to teach
    // at first sight. The preset `original`, where there is an original, is its first picture.
    std::vector<Preset> presets = {};
    std::string page = {};  // "demos/cube-cull/cube-cull.md"
    // The measurements, error against run time (--study), and the probes: added by the demo's study.cpp.
    std::optional<Study> study = {};
    std::vector<Probe> probes = {};
    std::function<std::unique_ptr<Demo>()> make = {};
};

// All demos linked into this program, by chapters and in them by numbers.
const std::vector<DemoInfo>& catalogue();
// The demo of that name, or Error naming the nearest one.
const DemoInfo& findDemo(std::string_view name);
// Adds a demo, as addLesson() does. Error: two of one name, a chapter that there is not, or presets that checkPresets() refuses.
bool addDemo(const Declaration& declaration, std::vector<Preset> presets, std::string page,
             std::function<std::unique_ptr<Demo>()> make);

// Sets knobs by name. Error: no such knob, or a value that it refuses.
void applyKnobs(Demo& demo, const std::vector<KnobSetting>& settings);

// The candidate nearest to `word` by edit distance, or "" where none is near enough to be a slip of the hand.
std::string nearestName(std::string_view word, const std::vector<std::string>& candidates);
// ", did you mean 'x'?" or "".
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace mv
