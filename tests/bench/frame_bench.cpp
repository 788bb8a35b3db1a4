// One frame through the framework (knobs, checks, matrices in doubles, uniforms by name) against the same GL calls made
// directly, with matrices computed beforehand. Both into the same target, both finished.
#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "bench/benches.h"
#include "mv/demo/preset.h"
#include "mv/error.h"
#include "mv/gl/gl.h"
#include "mv/run/render.h"

namespace mv::bench {
namespace {

// A GL call that a frame made, with its arguments: recorded once, then made again directly through the driver's own
// function pointers, which is exactly what a program without the framework would call.

using Call = std::function<void()>;
std::vector<Call>* recording = nullptr;

template <class Function>
struct Recorder;

// Wraps one table entry for the time of a recording. Arrays of floats that a call points to are copied.
template <class... Arguments>
struct Recorder<void (*)(Arguments...)> {
    using Function = void (*)(Arguments...);
    template <Function* entry, Function* original>
    static void call(Arguments... arguments) {
        const Function driver = *original;
        recording->push_back([=] { driver(arguments...); });
        driver(arguments...);
    }
};

template <auto* entry>
struct Original {
    static inline std::remove_pointer_t<decltype(entry)> function = nullptr;
    static void begin() {
        function = *entry;
        using Function = std::remove_pointer_t<decltype(entry)>;
        *entry = &Recorder<Function>::template call<entry, &function>;
    }
    static void end() { *entry = function; }
};

// The two calls whose last argument points to floats: the floats are kept with the call.
PFNGLUNIFORMMATRIX4FVPROC driverUniformMatrix4fv = nullptr;
PFNGLUNIFORM4FVPROC driverUniform4fv = nullptr;
void recordUniformMatrix4fv(GLint location, GLsizei count, GLboolean transpose, const GLfloat* values) {
    const std::vector<GLfloat> kept(values, values + 16 * count);
    const auto driver = driverUniformMatrix4fv;
    recording->push_back([=] { driver(location, count, transpose, kept.data()); });
    driver(location, count, transpose, values);
}
void recordUniform4fv(GLint location, GLsizei count, const GLfloat* values) {
    const std::vector<GLfloat> kept(values, values + 4 * count);
    const auto driver = driverUniform4fv;
    recording->push_back([=] { driver(location, count, kept.data()); });
    driver(location, count, values);
}

template <auto*... entries>
std::vector<Call> recordFrame(const std::function<void()>& frame) {
    std::vector<Call> calls;
    recording = &calls;
    (Original<entries>::begin(), ...);
    driverUniformMatrix4fv = std::exchange(glUniformMatrix4fv, recordUniformMatrix4fv);
    driverUniform4fv = std::exchange(glUniform4fv, recordUniform4fv);
    frame();
    glUniformMatrix4fv = driverUniformMatrix4fv;
    glUniform4fv = driverUniform4fv;
    (Original<entries>::end(), ...);
    recording = nullptr;
    return calls;
}

constexpr int framesOfRun = 16;  // a frame takes about half a millisecond, so that a run is long enough to time

// The old page's picture: what a figure adds draws by more functions than are recorded.
void openOriginal(Stage& stage, const std::string& demo) {
    stage.open(findDemo(demo), 512, 512);
    const auto& presets = stage.info().presets;
    applyPreset(stage.demo(), *std::ranges::find(presets, std::string("original"), &Preset::name));
}

void drawRepeatedly(Stage& stage) {
    for (int i = 0; i < framesOfRun; ++i) {
        stage.draw(1);
        glFinish();
    }
}

// What it saves that a window does not ask for the driver's messages.
Row listeningRow(const std::string& demo, int rounds) {
    HeadlessStage headless;
    openOriginal(headless.stage, demo);
    const auto drawn = [&](bool listened) {
        return [&, listened] {
            listenToDriver(listened);
            drawRepeatedly(headless.stage);
        };
    };
    Row row{"frame: " + demo + ", the driver's messages not asked for / asked for", {}, 1.02};
    row.ratio = interleaved(drawn(false), drawn(true), rounds);
    listenToDriver(false);
    return row;
}

Row frameRow(const std::string& demo, int rounds) {
    HeadlessStage headless;
    Stage& stage = headless.stage;
    openOriginal(stage, demo);
    stage.draw(1);
    const Picture through = stage.picture();
    const std::vector<Call> calls =
        recordFrame<&glBindFramebuffer, &glViewport, &glClearColor, &glClear, &glEnable, &glDisable, &glCullFace,
                    &glFrontFace, &glDepthFunc, &glDepthMask, &glUseProgram, &glBindVertexArray, &glDrawArrays,
                    &glDrawElements, &glColorMask, &glUniform1i, &glUniform1f>([&] { stage.draw(1); });
    for (const Call& call : calls) call();
    if (stage.picture() != through)
        throw Error("bench", "must make the same picture of " + demo + " by the recorded calls");
    Row row{
        "frame: " + demo + " through the framework / its GL calls made directly (" + std::to_string(calls.size()) + ")",
        {},
        1.10};
    row.ratio = interleaved([&] { drawRepeatedly(stage); },
                            [&] {
                                for (int i = 0; i < framesOfRun; ++i) {
                                    for (const Call& call : calls) call();
                                    glFinish();
                                }
                            },
                            rounds);
    return row;
}

}  // namespace

std::vector<Row> frameBench(int rounds) {
    return {frameRow("cube-cull", rounds), frameRow("viewpoints", rounds), listeningRow("cube-cull", rounds)};
}

}  // namespace mv::bench
