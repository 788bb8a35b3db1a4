#include "mv/paper/report.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "mv/paper/json_text.h"
#include "mv/paper/tables.h"

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

std::string matrixText(const mat4& matrix) {
    std::string text;
    const double largest = largestEntry(matrix);
    for (int row = 0; row < 4; ++row) {
        text += "   ";
        for (int column = 0; column < 4; ++column)
            text += formatted(" %11.6g", withoutRounding(matrix[column][row], largest));
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

std::string remarksText(const std::vector<DriverRemark>& remarks, const std::string& before) {
    std::string text;
    for (const auto& [words, times] : remarks)
        text += before + words + (times > 1 ? ", " + std::to_string(times) + " times" : "") + "\n";
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
        const std::string reason = knob->idleReason();
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
            (stage.info().needs.stencil ? ", stencil" : "") + ", " + std::to_string(stage.samples()) + " samples\n";
    text += "time      first " + formatted("%.3f", times.firstMs) + " ms, then median " +
            formatted("%.3f", times.medianMs) + " ms, MAD " + formatted("%.3f", times.madMs) + " ms of " +
            std::to_string(times.runs) + " runs\n";
    for (const auto& [name, matrix] : stage.notes().matrices) text += "matrix    " + name + "\n" + matrixText(matrix);
    for (const std::string& message : stage.notes().messages) text += "note      " + message + "\n";
    text += remarksText(driverRemarks(), "driver    ");
    return text;
}

std::string reportJson(Stage& stage, int index, const FrameTimes& times) {
    JsonText json;
    json.object();
    json.add("demo", stage.info().name);
    json.add("frame", index);
    json.add("width", stage.front().width());
    json.add("height", stage.front().height());
    json.add("host", stage.driver().host);
    json.add("renderer", stage.driver().renderer);
    json.add("opengl", stage.driver().version);
    json.object("knobs");
    for (const Knob* knob : stage.demo().knobs()) json.add(knob->name(), knob->text());
    json.end().object("idle");
    for (const Knob* knob : stage.demo().knobs()) {
        const std::string reason = knob->idleReason();
        if (!reason.empty()) json.add(knob->name(), reason);
    }
    json.end().object("readouts");
    for (const Readout* readout : stage.demo().readouts()) {
        json.object(readout->name());
        readout->value() ? json.add("value", *readout->value()) : json.addNull("value");
        json.add("unit", readout->unit()).end();
    }
    json.end().object("counters");
    json.add("draws", stage.frameCounters().draws);
    json.add("triangles", stage.frameCounters().triangles);
    json.add("vertices", stage.frameCounters().vertices);
    json.add("passes", stage.frameCounters().passes);
    for (const auto& [name, amount] : stage.notes().counts) json.add(name, amount);
    json.end().object("buffers");
    json.add("depth", stage.info().needs.depth);
    json.add("stencil", stage.info().needs.stencil);
    json.add("samples", stage.samples());
    json.end().object("milliseconds");
    json.add("first", times.firstMs).add("median", times.medianMs).add("mad", times.madMs).add("runs", times.runs);
    json.end().object("matrices");
    for (const auto& [name, matrix] : stage.notes().matrices) {
        json.array(name);
        for (int row = 0; row < 4; ++row) {
            json.array();
            for (int column = 0; column < 4; ++column) json.add({}, matrix[column][row] + 0.0);  // no -0
            json.end();
        }
        json.end();
    }
    json.end().addAll("messages", stage.notes().messages);
    json.array("driver");
    for (const DriverRemark& remark : driverRemarks())
        json.object().add("says", remark.text).add("times", remark.times).end();
    json.end();
    if (stage.steps()) {
        const FrameSteps& steps = *stage.steps();
        const auto into = [&](bool isPicture, const std::string& target, int width, int height) {
            json.add("target", isPicture ? "the picture" : target);
            json.add("target_width", width).add("target_height", height);
        };
        json.add("until", steps.until).array("draws");
        for (const DrawStep& draw : steps.draws) {
            json.object().add("mesh", draw.mesh).add("program", draw.program).add("primitive", draw.primitive);
            json.add("count", draw.count).add("indexed", draw.indexed);
            into(draw.inPicture, draw.target, draw.width, draw.height);
            json.addAll("state", draw.state).end();
        }
        json.end().object("shown");
        into(steps.shown.isPicture, steps.shown.target, steps.shown.width, steps.shown.height);
        for (const BufferPicture& buffer : steps.shown.buffers) json.add(buffer.name, buffer.range);
        json.end();
    }
    return json.end().text() + "\n";
}

std::string knobsText(const Demo& demo) {
    std::vector<std::vector<std::string>> rows;
    for (const Knob* knob : demo.knobs()) {
        const std::string idle = knob->idleReason();
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
    JsonText json;
    json.object().array("knobs");
    for (const Knob* knob : demo.knobs()) {
        json.object().add("name", knob->name()).add("value", knob->text()).add("initial", knob->initialText());
        json.add("range", knob->range()).add("scale", knob->scale() == Scale::logarithmic ? "logarithmic" : "linear");
        json.add("unit", knob->unit()).add("help", knob->help()).add("idle", knob->idleReason()).end();
    }
    json.end().array("presets");
    for (const Preset& preset : info.presets) {
        json.object().add("name", preset.name).add("lookFor", preset.lookFor).object("settings");
        for (const auto& [name, value] : preset.settings) json.add(name, value);
        json.end().end();
    }
    return json.end().end().text() + "\n";
}

}  // namespace mv
