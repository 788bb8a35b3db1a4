#include "visits/visit.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "mv/math/types.h"
#include "mv/run/copyable.h"

namespace mv::test {
namespace {

std::string presentCommand(int frame) {
    return copyableCommand(stage().info().name, stage().info(), stage().demo(), frame, stage().front().width(),
                           stage().front().height());
}

bool allFinite(const mat4& matrix) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(matrix[column][row])) return false;
        }
    }
    return true;
}

}  // namespace

std::optional<Picture> drawnOnce(int frame, bool readouts) {
    try {
        // A draw throws where a readout is not finite, and Program::set where a uniform is not.
        stage().draw(frame, readouts);
        for (const auto& [name, matrix] : stage().notes().matrices) EXPECT_TRUE(allFinite(matrix)) << name;
        for (const auto& [name, amount] : stage().notes().counts) EXPECT_TRUE(std::isfinite(amount)) << name;
        return stage().picture();
    } catch (const std::exception& error) {
        ADD_FAILURE() << error.what() << "\nin: " << presentCommand(frame);
        return {};
    }
}

std::optional<Picture> visit(int frame, Times times) {
    SCOPED_TRACE(presentCommand(frame));
    std::optional<Picture> first = drawnOnce(frame, times == Times::once);
    if (first && times == Times::twice) {
        EXPECT_EQ(drawnOnce(frame, true), first) << "another picture the second time, when its readouts are measured";
    }
    return first;
}

std::string visitRefused(DemoRun& run) {
    std::string refusal = run.refusal();
    const auto& knobs = run.demo().knobs();
    EXPECT_TRUE(std::any_of(knobs.begin(), knobs.end(),
                            [&](const Knob* knob) { return refusal.starts_with("--" + knob->name() + ": "); }))
        << "a refusal begins with the flag of a knob: " << refusal;
    EXPECT_NE(refusal.find("must"), std::string::npos) << "a refusal says what would be right: " << refusal;
    EXPECT_THROW(stage().draw(1), Error);
    return refusal;
}

std::optional<Picture> visitScene(const std::string& setting, Times times) {
    SCOPED_TRACE(setting);
    std::optional<Picture> picture = visit(1, times);
    if (picture) {
        EXPECT_GT(countColors(*picture, 2), 1)
            << "one colour: a useless setting; saved " << saveFailure("visits", *picture);
    }
    return picture;
}

void drawSmall() {
    const int by = coarserOften(stage().info());
    stage().resize(stage().front().width() / by, stage().front().height() / by);
}

std::string affordable(const std::string& knob, const std::string& value) {
    std::ifstream lines(MVGL_SOURCE_DIR "/tests/visits/affordable.txt");
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string demo, dearKnob, dear, instead;
        words >> demo >> dearKnob >> dear >> instead;
        if (demo == stage().info().name && dearKnob == knob && dear == value) return instead;
    }
    return value;
}

INSTANTIATE_TEST_SUITE_P(Demos, Visits, testing::ValuesIn(demoNames()), parameterWord);

}  // namespace mv::test
