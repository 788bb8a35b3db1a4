// What a page calls: one demo on one canvas. Texts are UTF-8; an answer lives until the next call. A call that can fail answers
// "" or a sentence that says why not.
#include <emscripten/emscripten.h>
#include <emscripten/html5.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "context.h"
#include "mv/demo/controls.h"
#include "mv/error.h"
#include "mv/gl/editing.h"
#include "mv/gl/gl.h"
#include "mv/paper/json_text.h"
#include "mv/paper/report.h"
#include "mv/run/copyable.h"
#include "mv/show/caught.h"
#include "mv/show/handle_input.h"
#include "mv/show/session.h"
#include "pictures.h"
#include "shaders.h"
#include "widgets.h"

namespace {

using namespace mv;

struct Page {
    std::unique_ptr<Context> context = openWebGl();
    Stage stage{*context, true};
    std::unique_ptr<Session> session;
    HandleInput hand;
    Picture picture;  // that was read last
};

std::unique_ptr<Page>& page() {
    static std::unique_ptr<Page> only;
    return only;
}
Session& session() { return *page()->session; }
Demo& demo() { return session().demo(); }

FrameInfo shownFrame() { return page()->stage.frame(session().playback().frame()); }
// Of a place in the page's pixels from the picture's upper left corner, that in the picture's own from its lower left one.
vec2 placeOf(double x, double y) {
    const Stage& stage = page()->stage;
    return {x * stage.density(), stage.front().height() - y * stage.density()};
}

std::string answer;
const char* say(std::string words) {
    answer = std::move(words);
    return answer.c_str();
}

// "" where it succeeds, else what is told of the exception: none of C++ leaves the module.
template <class Action>
const char* attempt(const Action& action) {
    try {
        action();
        return say("");
    } catch (const std::exception&) {
        return say(caughtSentence("demo"));
    }
}

// A line for each knob: its name, a space, its value.
std::vector<KnobSetting> settingsOf(std::string_view lines) {
    std::vector<KnobSetting> settings;
    while (!lines.empty()) {
        const std::string_view line = lines.substr(0, lines.find('\n'));
        const std::size_t space = line.find(' ');
        if (space == line.npos) throw Error("settings", "must be lines of a knob and its value", std::string(line));
        settings.push_back({std::string(line.substr(0, space)), std::string(line.substr(space + 1))});
        lines.remove_prefix(std::min(lines.size(), line.size() + 1));
    }
    return settings;
}

}  // namespace

extern "C" {

// ---- the demo

// `width` and `height` are those of the first picture, in pixels; 0: the demo's own.
EMSCRIPTEN_KEEPALIVE const char* mvOpen(const char* demo, const char* settings, int frame, bool paused, int width,
                                        int height) {
    return attempt([&] {
        if (!page()) page() = std::make_unique<Page>();
        const DemoInfo& info = findDemo(demo);
        page()->session.reset();
        page()->hand = {};
        const SessionStart start{.width = width ? width : info.width,
                                 .height = height ? height : info.height,
                                 .knobs = settingsOf(settings),
                                 .frame = frame,
                                 .paused = paused};
        page()->session = std::make_unique<Session>(page()->stage, info, start);
    });
}

// "knobs" and "presets", as --knobs=json says them.
EMSCRIPTEN_KEEPALIVE const char* mvKnobsAndPresets() { return say(knobsJson(session().info(), demo())); }

// "widgets", "width", "height", "animated", what each of the "readouts" says, and "controls": what is done and what that does; "drags"
// where the pointer moves a knob by itself, "wheels", which knobs the wheel moves, and by how much a notch, "handles" where things are
// dragged in the picture, "remembers" where a frame follows from the one before.
EMSCRIPTEN_KEEPALIVE const char* mvDescribe() {
    JsonText json;
    const DemoInfo& info = session().info();
    json.object().object("widgets");
    addWidgets(json, demo());
    json.end().add("width", info.width).add("height", info.height).add("animated", info.animated);
    json.object("readouts");
    for (const Readout* readout : demo().readouts()) json.add(readout->name(), readout->help());
    json.end().array("controls");
    for (const auto& [does, to] : controlsOf(demo())) json.array().add({}, does).add({}, to).end();
    json.end();
    bool drags = false;
    json.object("wheels");
    for (const Binding& binding : demo().bindings()) {
        if (binding.gesture == Gesture::wheel) json.add(binding.knob->name(), binding.amount);
        drags |= binding.gesture == Gesture::dragAcross || binding.gesture == Gesture::dragDown;
    }
    json.end().add("drags", drags).add("remembers", demo().memory() != nullptr);
    json.add("handles", !demo().handles().empty());
    return say(json.end().text());
}

// Which buttons of knobs can be pressed now, as "widgets" has them.
EMSCRIPTEN_KEEPALIVE const char* mvWidgets() {
    JsonText json;
    json.object();
    addWidgets(json, demo());
    return say(json.end().text());
}

EMSCRIPTEN_KEEPALIVE const char* mvSet(const char* knob, const char* text) { return say(session().set(knob, text)); }

// The picture is to be drawn anew for something that no knob says.
EMSCRIPTEN_KEEPALIVE void mvTouch() { session().touch(); }

// These knobs, and the others to their initial values.
EMSCRIPTEN_KEEPALIVE const char* mvSetAll(const char* settings) {
    return attempt([&] {
        session().touch();  // also where one is refused: those before it are set
        for (Knob* knob : demo().knobs()) knob->reset();
        applyKnobs(demo(), settingsOf(settings));
    });
}

// "beginning" and "changes" since, { "frame", "knob", "value" } each, where there are any: the picture follows from them. Else {}.
EMSCRIPTEN_KEEPALIVE const char* mvTimeline() {
    const Timeline& timeline = page()->stage.timeline();
    const std::vector<TimedChange> changes = timeline.changesUntil(session().drawnFrame());
    JsonText json;
    json.object();
    if (!changes.empty()) {
        json.object("beginning");
        for (const KnobSetting& knob : timeline.beginning()) json.add(knob.name, knob.text);
        json.end().array("changes");
        for (const TimedChange& change : changes)
            json.object().add("frame", change.frame).add("knob", change.knob).add("value", change.text).end();
        json.end();
    }
    return say(json.end().text());
}

// The present settings are a beginning, and these changes come, a line for each: a frame, a space, a knob, a space and its value.
EMSCRIPTEN_KEEPALIVE const char* mvSetChanges(const char* lines) {
    return attempt([&] {
        std::vector<TimedChange> changes;
        for (const KnobSetting& line : settingsOf(lines)) {
            const KnobSetting change = settingsOf(line.text + "\n").front();
            demo().knob(change.name);  // Error: none of that name
            changes.push_back({std::stoi(line.name), change.name, change.text});
        }
        session().restart();
        page()->stage.timeline().setChanges(std::move(changes));
    });
}

// Where the pixels of a picture are to be written that knobs may name from now on, as mvPixels() has them; null: sides that no picture has,
// or no memory.
EMSCRIPTEN_KEEPALIVE unsigned char* mvReceivePicture(const char* name, int width, int height) {
    try {
        return receivePicture(name, width, height);
    } catch (const std::exception&) {
        return nullptr;
    }
}

// The same of a model's text. `bytes`: how many it has.
EMSCRIPTEN_KEEPALIVE char* mvReceiveText(const char* name, int bytes) {
    try {
        return receiveText(name, static_cast<std::size_t>(bytes));
    } catch (const std::exception&) {
        return nullptr;
    }
}

EMSCRIPTEN_KEEPALIVE const char* mvPressButton(const char* knob, const char* label) {
    return attempt([&] {
        if (pressButton(demo().knob(knob), label)) session().touch();
    });
}

// The text of a shader file, and the programs that read it anew. Where one of them is none, the last good one stays, and the answer
// has each mistake with its file and line.
EMSCRIPTEN_KEEPALIVE const char* mvWriteShader(const char* name, const char* text) {
    try {
        writeShader(name, text);
        const Reloaded reloaded = reloadChangedPrograms();
        if (reloaded.programs > 0) session().touch();
        std::string errors;
        for (const std::string& error : reloaded.standing) errors += (errors.empty() ? "" : "\n") + error;
        const std::string_view file(name);
        const bool isWhole = !file.ends_with(".glsl");  // a file that others include compiles with them
        if (errors.empty() && isWhole) errors = mistakesOf(name);
        return say(std::move(errors));
    } catch (const std::exception&) {
        return say(caughtSentence(name));
    }
}

// The names of the shader files that the programs there are now are made of.
EMSCRIPTEN_KEEPALIVE const char* mvShadersInUse() {
    JsonText json;
    json.array();
    for (const auto& file : filesOfPrograms()) json.add({}, file.string());
    return say(json.end().text());
}

// ---- time

EMSCRIPTEN_KEEPALIVE void mvAdvance(double seconds) { session().advance(seconds); }
EMSCRIPTEN_KEEPALIVE void mvToggle() { session().playback().toggle(); }
EMSCRIPTEN_KEEPALIVE void mvStep() {
    session().playback().step();
    session().touch();
}
EMSCRIPTEN_KEEPALIVE void mvGoTo(int frame) {
    session().playback().goTo(frame);
    session().touch();
}
EMSCRIPTEN_KEEPALIVE void mvRestart() { session().restart(); }
EMSCRIPTEN_KEEPALIVE void mvSetSpeed(double speed) { session().playback().setSpeed(speed); }

// ---- the hand

// A key of the demo's own, by its name ("Up", "7", "W"); false: the page may take it for itself.
EMSCRIPTEN_KEEPALIVE bool mvPress(const char* name) {
    for (const Binding& binding : demo().bindings()) {
        if (binding.gesture == Gesture::key && keyName(binding.key) == name) return session().press(binding.key);
    }
    return false;
}
// Places are in the page's pixels from the picture's upper left corner, `reach` is how near to a handle the pointer takes it.
EMSCRIPTEN_KEEPALIVE void mvPointerDown(double x, double y, double reach) {
    if (page()->hand.press(demo(), shownFrame(), placeOf(x, y), reach * page()->stage.density())) {
        session().pointerUp();
    } else {
        session().pointerDown(x, y);
    }
}
EMSCRIPTEN_KEEPALIVE void mvPointerMove(double x, double y) {
    if (page()->hand.drag(demo(), shownFrame(), placeOf(x, y))) session().touch();
    session().pointerMove(x, y);
}
EMSCRIPTEN_KEEPALIVE void mvPointerUp() {
    page()->hand.release();
    session().pointerUp();
}
// Where the pointer is while nothing is dragged; a negative reach: not over the picture.
EMSCRIPTEN_KEEPALIVE void mvHover(double x, double y, double reach) {
    page()->hand.hover(demo(), shownFrame(), reach < 0 ? std::nullopt : std::optional(placeOf(x, y)),
                       reach * page()->stage.density());
}
// What a key of that name does to what can be dragged. Whether it was for this.
EMSCRIPTEN_KEEPALIVE bool mvHandKey(const char* name, bool far) {
    using Move = HandleInput::Move;
    static const std::map<std::string_view, Move> moves{
        {"H", Move::next},    {"Insert", Move::more}, {"Delete", Move::less}, {"Escape", Move::letGo},
        {"Left", Move::left}, {"Right", Move::right}, {"Up", Move::up},       {"Down", Move::down}};
    const auto move = moves.find(name);
    if (move == moves.end()) return false;
    bool moved = false;
    const bool taken = page()->hand.key(demo(), shownFrame(), move->second, far, moved);
    if (moved) session().touch();
    return taken;
}
// [{"name", "x", "y", "active"}] of what can be dragged, in the picture's pixels from its upper left corner.
EMSCRIPTEN_KEEPALIVE const char* mvHandles() {
    JsonText json;
    json.array();
    for (const HandleInput::Place& place : page()->hand.places(demo(), shownFrame())) {
        json.object().add("name", place.name).add("x", place.at.x);
        json.add("y", page()->stage.front().height() - place.at.y).add("active", place.active).end();
    }
    return say(json.end().text());
}
EMSCRIPTEN_KEEPALIVE void mvWheel(double notches) { session().wheel(notches); }

// ---- the picture

// Draws where due, and shows what there is; whether there is more to draw at once, as a picture made in passes has.
EMSCRIPTEN_KEEPALIVE bool mvDraw(int width, int height, bool readouts) {
    if (!session().due(width, height)) return false;
    session().draw(width, height, readouts);
    if (session().hasPicture()) {
        const Target& target = page()->stage.front();
        emscripten_set_canvas_element_size(canvasName, target.width(), target.height());
        target.blitToWindow(0, 0);
    }
    return session().stale();
}

// The canvas' pixels for each of the page's: words and lines of figures are no smaller than can be read.
EMSCRIPTEN_KEEPALIVE void mvDensity(double density) { session().setDensity(density); }

EMSCRIPTEN_KEEPALIVE bool mvIsDue(int width, int height) { return session().due(width, height); }

// {"knob": "value"}, of all.
EMSCRIPTEN_KEEPALIVE const char* mvKnobs() {
    JsonText json;
    json.object();
    for (const Knob* knob : demo().knobs()) json.add(knob->name(), knob->text());
    return say(json.end().text());
}

// "error", "frame", "playing", "speed", "passes", "passesDone", and how many "pictures" were drawn so far.
EMSCRIPTEN_KEEPALIVE const char* mvState() {
    const Session& now = session();
    JsonText json;
    json.object().add("error", now.error()).add("frame", now.playback().frame());
    json.add("playing", now.playback().playing()).add("speed", now.playback().speed());
    json.add("passes", now.passes()).add("passesDone", now.passesDone()).add("pictures", now.picturesDrawn());
    return say(json.end().text());
}

// As --report=json.
EMSCRIPTEN_KEEPALIVE const char* mvReport() {
    return say(reportJson(page()->stage, session().drawnFrame(), session().times()));
}

// The line that makes this picture by the native program, in the size of its canvas there: that of this one is the page's and the
// screen's. `knob` is compared with its value `other`, or "" for none.
EMSCRIPTEN_KEEPALIVE const char* mvCommand(const char* knob, const char* other) {
    const DemoInfo& info = session().info();
    return say(copyableCommand("./run " + info.name, info, demo(), session().drawnFrame(), info.width, info.height,
                               {knob, other}, &page()->stage.timeline(), *knob ? std::nullopt : session().until()));
}

// The last picture's bytes, red, green, blue, alpha, the upper row first; as many as its size says.
EMSCRIPTEN_KEEPALIVE const unsigned char* mvPixels() {
    page()->picture = page()->stage.picture();
    return page()->picture.rgba.data();
}

// ---- a frame draw by draw

// Stops the picture after so many of its draws, a negative number: never. Where it is stopped, the report has its "draws", the number
// "until", and what is "shown", see mv/gl/steps.h.
EMSCRIPTEN_KEEPALIVE void mvStopAfter(int draws) {
    session().stopAfter(draws < 0 ? std::nullopt : std::optional(draws));
}

// Of the buffers that the last of these draws drew into, in the order of "shown", the widths and heights; 0 where there is no picture.
EMSCRIPTEN_KEEPALIVE const char* mvBuffers() {
    JsonText json;
    json.array();
    if (session().steps()) {
        for (const BufferPicture& buffer : session().steps()->shown.buffers)
            json.object().add("width", buffer.picture.width).add("height", buffer.picture.height).end();
    }
    return say(json.end().text());
}

// The picture of one of them, by its number there, as mvPixels() has one; it is not to be asked for where there is none.
EMSCRIPTEN_KEEPALIVE const unsigned char* mvBufferPixels(int index) {
    return session().steps()->shown.buffers[static_cast<std::size_t>(index)].picture.rgba.data();
}

}  // extern "C"
