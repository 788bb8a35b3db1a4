#include "mv/window/window_report.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "mv/error.h"
#include "mv/paper/tables.h"

namespace mv {
namespace {

std::string pixelsText(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

}  // namespace

nlohmann::ordered_json windowJson(const WindowState& state) {
    return {{"settled", state.settled},
            {"hidden", state.hidden},
            {"closing", state.closing},
            {"seconds", state.seconds},
            {"window_frames", state.frames},
            {"size", pixelsText(state.size.width(), state.size.height())},
            {"pixels", pixelsText(state.size.pixelWidth(), state.size.pixelHeight())},
            {"keys", state.inputs.keys},
            {"keys_held", state.inputs.keysHeld},
            {"buttons", state.inputs.buttons},
            {"buttons_held", state.inputs.buttonsHeld},
            {"wheel", state.inputs.wheel},
            {"mouse", numberText(state.inputs.mouseX) + "," + numberText(state.inputs.mouseY)}};
}

nlohmann::ordered_json placesJson(const Places& places) {
    auto json = nlohmann::ordered_json::object();
    for (const auto& [name, r] : places) {
        json[name] = numberText(r.x) + "," + numberText(r.y) + "," + numberText(r.z) + "," + numberText(r.w);
    }
    return json;
}

std::string windowText(const WindowState& state) {
    const Inputs& inputs = state.inputs;
    return "window    " + std::to_string(state.frames) + " window frames drawn in " + formatted("%.2f", state.seconds) +
           " s" + (state.hidden ? ", hidden" : "") +
           (state.closing   ? ", closing"
            : state.settled ? ", at rest"
                            : "") +
           "\ninputs    " + std::to_string(inputs.keys) + " keys, " + std::to_string(inputs.buttons) + " buttons, " +
           std::to_string(inputs.wheel) + " turns of the wheel\n";
}

void printReport(const std::string& text) {
    std::cout << text << std::flush;
    if (!std::cout) throw Error("standard output", "could not be written");
}

}  // namespace mv
