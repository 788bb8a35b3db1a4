// Every demo under stress: the ends of its knobs in pairs, pictures of extreme shapes, and the frame after a whole day.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>

#include "mv/gl/text.h"
#include "mv/math/types.h"
#include "mv/run/copyable.h"
#include "support/covering_array.h"
#include "support/demo_run.h"
#include "support/live_bytes.h"

using namespace mv;
using namespace mv::test;

namespace {

class Stress : public testing::TestWithParam<std::string> {};
// Minutes: for ./test --long.
class StressLong : public testing::TestWithParam<std::string> {};

// Ends that cost seconds a picture, and what is tried instead of them but for ./test --long: tests/stress.txt.
std::string affordable(const std::string& knob, const std::string& value) {
    std::ifstream lines(MVGL_SOURCE_DIR "/tests/stress.txt");
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string demo, dearKnob, dear, instead;
        words >> demo >> dearKnob >> dear >> instead;
        if (demo == stage().info().name && dearKnob == knob && dear == value) return instead;
    }
    return value;
}

// The knobs of the open demo, each with the values that are tried: every option of a choice, both of a toggle, and of a
// number its ends and its initial value.
class Settings {
  public:
    Settings(Demo& demo, bool all) : demo_(demo) {
        for (const Knob* knob : demo.knobs()) {
            std::vector<std::string> values;
            const auto add = [&](const std::string& value) {
                if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
            };
            const std::vector<std::string> ends = knob->sweep();
            const bool number = knob->options().empty() && ends.size() > 2;
            const auto tried = [&](const std::string& value) { return all ? value : affordable(knob->name(), value); };
            for (const std::string& value : number ? std::vector{ends.front(), knob->text(), ends.back()} : ends) {
                add(tried(value));
            }
            const auto usual = std::find(values.begin(), values.end(), tried(knob->text()));
            usual_.push_back(static_cast<int>(usual - values.begin()));
            levels_.push_back(static_cast<int>(values.size()));
            values_.push_back(std::move(values));
        }
    }

    const std::vector<int>& levels() const { return levels_; }
    const Row& usual() const { return usual_; }

    void strike(const Row& row) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            demo_.knobs()[i]->parse(values_[i][static_cast<std::size_t>(row[i])]);
        }
    }
    bool allowed(const Row& row) {
        strike(row);
        try {
            demo_.check();
            return true;
        } catch (const Error&) {
            return false;
        }
    }
    Row usualWith(const ValuePair& pair) const {
        Row row = usual_;
        row[static_cast<std::size_t>(pair.factorA)] = pair.valueA;
        row[static_cast<std::size_t>(pair.factorB)] = pair.valueB;
        return row;
    }

  private:
    Demo& demo_;
    std::vector<std::vector<std::string>> values_;
    std::vector<int> levels_;
    Row usual_;
};

bool allFinite(const mat4& matrix) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(matrix[column][row])) return false;
        }
    }
    return true;
}

// One frame of the present settings, with its readouts. The stage throws where GL reports an error, a readout where it is
// not finite, and Program::set where a uniform is not.
Picture soundPicture(int frame) {
    stage().draw(frame, true);
    for (const auto& [name, matrix] : stage().notes().matrices) EXPECT_TRUE(allFinite(matrix)) << name;
    for (const auto& [name, amount] : stage().notes().counts) EXPECT_TRUE(std::isfinite(amount)) << name;
    return stage().picture();
}

std::string presentCommand(int frame) {
    const Picture size = stage().picture();
    return copyableCommand(stage().info().name, stage().info(), stage().demo(), frame, size.width, size.height);
}

// The frame is drawn, without an error and with the same bytes the second time.
void expectSound(int frame = 1) {
    try {
        const Picture first = soundPicture(frame);
        EXPECT_EQ(soundPicture(frame), first) << "another picture the second time: " << presentCommand(frame);
    } catch (const std::exception& error) {
        ADD_FAILURE() << error.what() << "\nin: " << presentCommand(frame);
    }
}

// The settings are refused, by check() and so by draw(), in a sentence that begins with a knob's flag and tells a rule.
void expectRefused(DemoRun& run) {
    const std::string refusal = run.refusal();
    const auto& knobs = run.demo().knobs();
    EXPECT_TRUE(std::any_of(knobs.begin(), knobs.end(),
                            [&](const Knob* knob) { return refusal.rfind("--" + knob->name() + ": ", 0) == 0; }))
        << "a refusal begins with the flag of a knob: " << refusal;
    EXPECT_NE(refusal.find("must"), std::string::npos) << "a refusal says what would be right: " << refusal;
    EXPECT_THROW(stage().draw(1), Error);
}

// The settings of one row after the other, and then in reverse: each has the same bytes both times, whatever was drawn
// before it. What a demo keeps from frame to frame and should not have kept shows where neighbours differ by one knob.
void expectSoundBothWays(Settings& settings, const std::vector<Row>& rows) {
    std::vector<std::optional<Picture>> pictures;
    const auto draw = [&](const Row& row) -> std::optional<Picture> {
        settings.strike(row);
        try {
            return soundPicture(1);
        } catch (const std::exception& error) {
            ADD_FAILURE() << error.what() << "\nin: " << presentCommand(1);
            return {};
        }
    };
    for (const Row& row : rows) pictures.push_back(draw(row));
    for (std::size_t i = rows.size(); i-- > 0;) {
        if (pictures[i]) {
            EXPECT_EQ(draw(rows[i]), pictures[i]) << "another picture the second time: " << presentCommand(1);
        }
    }
}

// Every pair of ends of two knobs is drawn, in few rows that have as many pairs as can be, or refused by itself.
TEST_P(Stress, pairs_of_ends) {
    DemoRun run(GetParam(), 64, 48);
    Settings settings(run.demo(), false);
    const CoveringArray array =
        coveringArray(settings.levels(), settings.usual(), [&](const Row& row) { return settings.allowed(row); });
    expectSoundBothWays(settings, array.rows);
    for (const ValuePair& pair : array.refused) {
        settings.strike(settings.usualWith(pair));
        expectRefused(run);
    }
    std::printf("%s: %zu knobs, %zu settings, %zu pairs refused\n", GetParam().c_str(), settings.levels().size(),
                array.rows.size(), array.refused.size());
}

// The same pairs, each by itself: all other knobs are as they open.
TEST_P(StressLong, all_pairs_of_ends) {
    DemoRun run(GetParam(), 64, 48);
    Settings settings(run.demo(), true);
    std::set<Row> rows;  // without those that come again: a pair of initial values is all of them
    int refused = 0;
    forEachPair(settings.levels(), [&](const ValuePair& pair) {
        const Row row = settings.usualWith(pair);
        if (settings.allowed(row)) {
            rows.insert(row);
        } else {
            expectRefused(run);
            ++refused;
        }
    });
    expectSoundBothWays(settings, {rows.begin(), rows.end()});
    std::printf("%s: %zu settings, %d refused\n", GetParam().c_str(), rows.size(), refused);
}

// A single pixel, a column and a row of them.
TEST_P(Stress, extreme_sizes) {
    DemoRun run(GetParam(), 1, 1);
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 4096}, {16384, 16}}) {
        stage().resize(width, height);
        expectSound();
        const Picture picture = stage().picture();
        EXPECT_EQ(picture.width, width);
        EXPECT_EQ(picture.height, height);
    }
}

// Frame 5 184 000 is the one after 24 hours at 60 a second. A demo is a pure function of the frame's number: the picture
// is the same whatever was drawn before, and the first frame is again what it was. A demo that has to compute each frame
// from the one before, in milliseconds, is given fewer by tests/stress.txt, as a knob "frame".
TEST_P(Stress, a_day_of_frames) {
    DemoRun run(GetParam(), 64, 48);
    const int day = std::stoi(affordable("frame", "5184000"));
    const Picture first = soundPicture(1);
    const Picture later = soundPicture(day);
    expectSound(day - 1);
    EXPECT_EQ(soundPicture(day), later) << "another picture after the frame before";
    EXPECT_EQ(soundPicture(1), first) << "another first picture after a day";
    if (stage().info().animated) {
        EXPECT_NE(soundPicture(day + 17), later) << "it no longer moves";
    } else {
        EXPECT_EQ(later, first);
    }
}

// What a user draws who plays with each knob: one after the other, each knob at each of its ends, and between them the demo
// as it opens, with its readouts after each knob. Frames are numbered on, as in a window; but of a demo that remembers each
// round begins with frame 1, since a knob that has moved leads it through all frames before the one that is asked for.
class Rounds {
  public:
    explicit Rounds(Demo& demo) : demo_(demo) {}
    void draw() {
        if (demo_.memory()) number_ = 0;
        for (Knob* knob : demo_.knobs()) {
            const std::string before = knob->text();
            for (const std::string& end : knob->sweep()) {
                knob->parse(affordable(knob->name(), end));
                try {
                    drawNext();
                } catch (const Error&) {  // refused by check(), which other tests look at
                }
                knob->parse(before);
                drawNext();
            }
            drawNext(true);
        }
        // What a demo with a memory has been through is kept, a bounded number of frames of it (Timeline's own test).
        stage().timeline().beginAnew();
        stage().draw(1);
        glFinish();
    }
    int frames() const { return frames_; }

  private:
    void drawNext(bool readouts = false) {
        ++frames_;
        stage().draw(++number_, readouts);
    }
    Demo& demo_;
    int frames_ = 0, number_ = 0;
};

// Two rounds fill whatever is kept. After them each ends with as many GL objects as the one before, and with as many bytes
// but for what vectors keep in reserve: at most 8 a frame, where the smallest thing that is forgotten in each is of 24.
void expectFlat(const std::string& name, int frames) {
    DemoRun run(name, 64, 48);
    // What drawText keeps of its last sixteen calls: a demo with fewer different words, of which one changes with the frame,
    // would fill it over many rounds. These are longer than a demo's.
    for (int i = 0; i < 16; ++i) {
        drawText(FrameInfo(1, 64, 48), std::vector<TextLine>(20, {0, 0, std::to_string(i) + std::string(100, 'x')}));
    }
    Rounds rounds(run.demo());
    rounds.draw();
    rounds.draw();
    const int begun = rounds.frames();
    const std::size_t bytes = liveBytes();
    const long objects = liveObjects();
    do {
        rounds.draw();
        EXPECT_EQ(liveObjects(), objects) << "at frame " << rounds.frames();
        EXPECT_LE(labelledObjects(), static_cast<std::size_t>(liveObjects())) << "labels of what is gone are kept";
    } while (rounds.frames() < frames);
    std::printf("%s: %d frames\n", name.c_str(), rounds.frames());
    EXPECT_LE(liveBytes(), bytes + 8 * static_cast<std::size_t>(rounds.frames() - begun));
}

TEST_P(Stress, memory_stays) { expectFlat(GetParam(), 200); }
TEST_P(StressLong, memory_stays_for_5000_frames) { expectFlat(GetParam(), 5000); }

INSTANTIATE_TEST_SUITE_P(Demos, Stress, testing::ValuesIn(demoNames()), parameterWord);
INSTANTIATE_TEST_SUITE_P(Demos, StressLong, testing::ValuesIn(demoNames()), parameterWord);

}  // namespace
