// A demo: a class with knobs and readouts as members, an init and a draw. The framework owns the loop.
//
// From that one declaration come a standalone program with a window and a panel, the same program without a window, a
// row in the launcher, the tests that move every knob, and the tables of its page.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/binding.h"
#include "mv/demo/frame.h"
#include "mv/demo/handle.h"
#include "mv/demo/knob.h"
#include "mv/demo/points.h"
#include "mv/demo/readout.h"
#include "mv/demo/study.h"
#include "mv/error.h"

namespace mv {

class Demo {
  public:
    virtual ~Demo() = default;
    Demo() = default;
    Demo(const Demo&) = delete;
    Demo& operator=(const Demo&) = delete;

    // Makes the GL objects; a context is current. Called once, before the first draw.
    virtual void init() = 0;
    // Draws frame.index(): a pure function of the knobs and the index. OpenGL is in its initial state; the picture is the
    // target, all of it the viewport, and cleared where the demo declares its background. What draw() changes is undone
    // after it.
    virtual void draw(const Frame& frame) = 0;
    // Throws Error where settings that are each in range make no picture together (near beyond far, eye at the target).
    // Headless that ends the program; the window keeps its last picture and shows the sentence.
    virtual void check() const {}

    // For a demo with a study. What is right for the present settings, in the picture that `frame` describes (its size and
    // index; not drawn into); made by a method that shares nothing with the one under study. Slow ones report the part
    // that is done.
    virtual Reference reference(const Frame& frame, const std::function<void(double part)>& progress) const;
    // For a study of values: computes them for the present settings, without GL. This is what is timed.
    virtual std::vector<double> values() const;

    const std::vector<Knob*>& knobs() const { return knobs_; }
    const std::vector<Readout*>& readouts() const { return readouts_; }
    const std::vector<Binding>& bindings() const { return bindings_; }
    const std::vector<Handle>& handles() const { return handles_; }

    // The knob of that name, or Error naming the nearest one.
    Knob& knob(std::string_view name) const;

    // Gestures, in the order of their bindings; true when a knob moved.
    bool press(Key key);
    bool drag(double across, double down);
    bool wheel(double notches);

  protected:
    // Declared in a demo's constructor; `amount` as in Binding.
    void bindKeys(Key less, Key more, Knob& knob, double amount);
    void bindKey(Key key, Knob& knob, std::string text);
    void bindDrag(Knob& across, double perPixelAcross, Knob& down, double perPixelDown);
    void bindWheel(Knob& knob, double perNotch);
    // Something in the picture that is dragged there; `where` as in Handle.
    void bindHandle(std::string name, std::vector<Real*> knobs, std::function<std::optional<vec2>(const Frame&)> where);
    // One for each of the points; `where` says where the value of one is.
    void bindHandle(std::string name, Points& points,
                    std::function<std::optional<vec2>(const Frame&, const vec2& value)> where);

  private:
    friend class Knob;
    friend class Readout;
    friend struct Turntable;
    void add(Knob* knob);
    void add(Readout* readout) { readouts_.push_back(readout); }

    std::vector<Knob*> knobs_;
    std::vector<Readout*> readouts_;
    std::vector<Binding> bindings_;
    std::vector<Handle> handles_;
};

// Something that a demo uses and OpenGL ES 3.0, which is WebGL 2's, lacks; older OpenGL may lack it, too (clip control). A demo can ask
// whether it is there: has() in mv/gl/beyond_es.h.
struct BeyondEs {
    std::string feature;    // by the name that mv/gl/beyond_es.h finds it by: "clip distances"
    std::string otherwise;  // what the demo does without it, a clause
};

// What a demo needs of the context and of its framebuffer. What is not asked for is not made.
struct Needs {
    bool depth = false;
    bool stencil = false;
    int samples = 0;  // 0 or what the driver has; another number is refused by name
    int gl = 33;      // core version, 10 * major + minor
    // All that ES 3.0 lacks and the demo uses in any of its settings: the sweep holds it to the calls and formats it sees.
    std::vector<BeyondEs> beyondEs = {};
};

// Needless work that a demo does on purpose, because its lesson is about it.
struct DeclaredWaste {
    std::string kind;    // as --audit names it: "no-sample"
    std::string what;    // what --audit says of it, word for word: "draw of 'cube'"
    std::string reason;  // one clause
};

// What is known of a demo before one is made.
struct DemoInfo {
    std::string name;               // kebab-case; the program, the page and the shaders have the same name
    std::string sentence;           // what it shows
    std::string lookFor;            // what to look for, one sentence
    std::string chapter;            // the heading it stands under
    int number = 0;                 // its row in the course's catalogue, which orders the lists
    int width = 512, height = 512;  // the original's canvas
    bool animated = false;          // the picture depends on the frame index
    // The colour that the picture is cleared to before each draw, with depth to 1 and the stencil to 0; without one, the
    // demo clears. A measured quantity is cleared to -1, which is nothing to compare, by either.
    std::optional<vec4> background = {};
    Needs needs = {};
    // Knobs and values that show the demo better than its first picture does (a cube seen straight on): its small pictures
    // are drawn in this pose, and the sweep test moves one knob at a time from it.
    std::vector<std::pair<std::string, std::string>> pose = {};
    std::vector<DeclaredWaste> waste = {};
    // What is to be measured, error against run time (--study).
    std::optional<Study> study = {};
    std::function<std::unique_ptr<Demo>()> make = {};
};

// All demos linked into this program, in the order of their numbers.
const std::vector<DemoInfo>& catalogue();
// The demo of that name, or Error naming the nearest one.
const DemoInfo& findDemo(std::string_view name);
// Adds a demo; called at file scope by the last line of its file. Two of one name: Error.
bool addDemo(DemoInfo info);
template <class T>
bool addDemo(DemoInfo info) {
    info.make = [] { return std::make_unique<T>(); };
    return addDemo(std::move(info));
}

// Sets knobs by name. Error: no such knob, or a value that it refuses.
void applyKnobs(Demo& demo, const std::vector<KnobSetting>& settings);
// Sets the knobs of the demo's pose.
void strikePose(Demo& demo, const DemoInfo& info);

// The candidate nearest to `word` by edit distance, or "" where none is near enough to be a slip of the hand.
std::string nearestName(std::string_view word, const std::vector<std::string>& candidates);
// ", did you mean 'x'?" or "".
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace mv
