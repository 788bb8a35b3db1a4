#include "mv/run/report.h"
#include "mv/run/words.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

namespace mv {
namespace {

// The readouts in columns: name, value with its unit, what it says.
std::string readoutLines(const Demo& demo) {
    std::vector<std::vector<std::string>> rows;
    for (const Readout* readout : demo.readouts()) {
        rows.push_back({"readout   " + readout->name(),
                        (readout->value() ? formatted("%.6g", *readout->value()) : std::string("-")) +
                            (readout->unit().empty() ? "" : " " + readout->unit()),
                        "(" + readout->help() + ")"});
    }
    return aligned(rows, 3);
}

}  // namespace

FrameTimes timeFrames(Stage& stage, int index, int runs, double firstMs) {
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) {
        const auto start = std::chrono::steady_clock::now();
        stage.draw(index);
        glFinish();
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    FrameTimes result{firstMs, median(times), 0, runs};
    for (double& time : times) time = std::abs(time - result.medianMs);
    result.madMs = median(times);
    return result;
}

std::string matrixText(const mat4& matrix) {
    std::string text;
    for (int row = 0; row < 4; ++row) {
        text += "   ";
        for (int column = 0; column < 4; ++column) text += formatted(" %11.6g", matrix[column][row]);
        text += "\n";
    }
    return text;
}

std::string stepsText(const FrameSteps& steps) {
    const auto into = [](bool isPicture, const std::string& target, int width, int height) {
        return (isPicture ? "the picture" : target) + ", " + std::to_string(width) + "x" + std::to_string(height);
    };
    std::string text =
        "until     " + std::to_string(steps.until) + " of " + std::to_string(steps.draws.size()) + " draws\n";
    for (std::size_t i = 0; i < steps.draws.size(); ++i) {
        const DrawStep& draw = steps.draws[i];
        const bool made = i < static_cast<std::size_t>(steps.until);
        text += (made ? "draw " : "left out ") + std::to_string(i + 1) + ": " + draw.mesh + " by program " +
                draw.program + ", " + std::to_string(draw.count) + (draw.indexed ? " indices" : " vertices") + " as " +
                draw.primitive + ", into " + into(draw.inPicture, draw.target, draw.width, draw.height) + "\n";
        for (const std::string& call : draw.state) text += "          " + call + "\n";
    }
    for (const BufferPicture& buffer : steps.shown.buffers) {
        text += "buffer    " + buffer.name + " of " +
                into(steps.shown.isPicture, steps.shown.target, steps.shown.width, steps.shown.height) + ": " +
                buffer.range + "\n";
    }
    return text;
}

std::string reportText(Stage& stage, int index, const FrameTimes& times) {
    const Target& target = stage.front();
    std::string text = stage.info().name + ", frame " + std::to_string(index) + ", " + std::to_string(target.width()) +
                       "x" + std::to_string(target.height()) + "\n";
    text += "host      " + stage.driver().host + "; " + stage.driver().renderer + "; OpenGL " + stage.driver().version +
            "\n";
    text += "knobs    ";
    for (const Knob* knob : stage.demo().knobs()) text += " " + knob->name() + "=" + knob->text();
    text += "\n";
    for (const Knob* knob : stage.demo().knobs()) {
        const std::string reason = stage.demo().idleReason(*knob);
        if (!reason.empty()) text += "idle      " + knob->name() + " (" + reason + ")\n";
    }
    text += readoutLines(stage.demo());
    text += "counters  " + std::to_string(stage.frameCounters().draws) + " draws, " +
            std::to_string(stage.frameCounters().triangles) + " triangles and " +
            std::to_string(stage.frameCounters().vertices) + " vertices submitted, " +
            std::to_string(stage.frameCounters().passes) + " passes";
    for (const auto& [name, amount] : stage.notes().counts) text += ", " + formatted("%.10g", amount) + " " + name;
    text += "\n";
    text += "buffers   color" + std::string(stage.info().needs.depth ? ", depth" : "") +
            (stage.info().needs.stencil ? ", stencil" : "") + ", " + std::to_string(stage.info().needs.samples) +
            " samples\n";
    text += "time      first " + formatted("%.3f", times.firstMs) + " ms, then median " +
            formatted("%.3f", times.medianMs) + " ms, MAD " + formatted("%.3f", times.madMs) + " ms of " +
            std::to_string(times.runs) + " runs\n";
    for (const auto& [name, matrix] : stage.notes().matrices) text += "matrix    " + name + "\n" + matrixText(matrix);
    for (const std::string& message : stage.notes().messages) text += "note      " + message + "\n";
    return text;
}

std::string reportJson(Stage& stage, int index, const FrameTimes& times) {
    nlohmann::ordered_json json;
    json["demo"] = stage.info().name;
    json["frame"] = index;
    json["width"] = stage.front().width();
    json["height"] = stage.front().height();
    json["host"] = stage.driver().host;
    json["renderer"] = stage.driver().renderer;
    json["opengl"] = stage.driver().version;
    json["knobs"] = nlohmann::ordered_json::object();
    for (const Knob* knob : stage.demo().knobs()) json["knobs"][knob->name()] = knob->text();
    json["idle"] = nlohmann::ordered_json::object();
    for (const Knob* knob : stage.demo().knobs()) {
        const std::string reason = stage.demo().idleReason(*knob);
        if (!reason.empty()) json["idle"][knob->name()] = reason;
    }
    json["readouts"] = nlohmann::ordered_json::object();
    for (const Readout* readout : stage.demo().readouts()) {
        auto& entry = json["readouts"][readout->name()];
        entry["value"] = readout->value() ? nlohmann::ordered_json(*readout->value()) : nlohmann::ordered_json();
        entry["unit"] = readout->unit();
    }
    json["counters"] = {{"draws", stage.frameCounters().draws},
                        {"triangles", stage.frameCounters().triangles},
                        {"vertices", stage.frameCounters().vertices},
                        {"passes", stage.frameCounters().passes}};
    for (const auto& [name, amount] : stage.notes().counts) json["counters"][name] = amount;
    json["buffers"] = {{"depth", stage.info().needs.depth},
                       {"stencil", stage.info().needs.stencil},
                       {"samples", stage.info().needs.samples}};
    json["milliseconds"] = {
        {"first", times.firstMs}, {"median", times.medianMs}, {"mad", times.madMs}, {"runs", times.runs}};
    json["matrices"] = nlohmann::ordered_json::object();
    for (const auto& [name, matrix] : stage.notes().matrices) {
        for (int row = 0; row < 4; ++row) {
            json["matrices"][name].push_back({matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]});
        }
    }
    json["messages"] = stage.notes().messages;
    if (stage.steps()) {
        const FrameSteps& steps = *stage.steps();
        json["until"] = steps.until;
        json["draws"] = nlohmann::ordered_json::array();
        for (const DrawStep& draw : steps.draws) {
            json["draws"].push_back({{"mesh", draw.mesh},
                                     {"program", draw.program},
                                     {"primitive", draw.primitive},
                                     {"count", draw.count},
                                     {"indexed", draw.indexed},
                                     {"target", draw.inPicture ? "the picture" : draw.target},
                                     {"target_width", draw.width},
                                     {"target_height", draw.height},
                                     {"state", draw.state}});
        }
        json["shown"] = {{"target", steps.shown.isPicture ? "the picture" : steps.shown.target},
                         {"target_width", steps.shown.width},
                         {"target_height", steps.shown.height}};
        for (const BufferPicture& buffer : steps.shown.buffers) json["shown"][buffer.name] = buffer.range;
    }
    return json.dump(2) + "\n";
}

std::string knobsText(const Demo& demo) {
    std::vector<std::vector<std::string>> rows;
    for (const Knob* knob : demo.knobs()) {
        const std::string idle = demo.idleReason(*knob);
        rows.push_back({"--" + knob->name(), knob->text(), knob->rangeInFull(),
                        "(" + knob->help() + ")" + (idle.empty() ? "" : " idle: " + idle)});
    }
    return aligned(rows, 4);
}

std::string presetsText(const DemoInfo& info) {
    std::vector<std::vector<std::string>> rows;
    for (const Preset& preset : info.presets) {
        const std::string settings = settingsText(preset);
        rows.push_back({"--preset " + preset.name, settings.empty() ? "the initial values" : settings,
                        "(" + preset.lookFor + ")"});
    }
    return aligned(rows, 3);
}

std::string knobsJson(const DemoInfo& info, const Demo& demo) {
    nlohmann::ordered_json json = {{"knobs", nlohmann::ordered_json::array()},
                                   {"presets", nlohmann::ordered_json::array()}};
    for (const Knob* knob : demo.knobs()) {
        json["knobs"].push_back({{"name", knob->name()},
                                 {"value", knob->text()},
                                 {"initial", knob->initialText()},
                                 {"range", knob->range()},
                                 {"scale", knob->scale() == Scale::logarithmic ? "logarithmic" : "linear"},
                                 {"unit", knob->unit()},
                                 {"help", knob->help()},
                                 {"idle", demo.idleReason(*knob)}});
    }
    for (const Preset& preset : info.presets) {
        auto settings = nlohmann::ordered_json::object();
        for (const auto& [name, value] : preset.settings) settings[name] = value;
        json["presets"].push_back({{"name", preset.name}, {"lookFor", preset.lookFor}, {"settings", settings}});
    }
    return json.dump(2) + "\n";
}

}  // namespace mv
