// At each end of each knob, each of its words, and pairs of these.
#include <algorithm>
#include <set>

#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"
#include "support/covering_array.h"
#include "visits/visit.h"

namespace mv::test {
namespace {

// Each value of each knob that is tried, beside the initial ones: how many, how many of them were refused, and the sentences that
// were said beside the pictures, or in refusals.
struct Tried {
    int cases = 0, refused = 0;
    std::set<std::string> sentences;
};

// Each is drawn once: `pairs_of_ends` draws each twice in ./test --long, but for those that cost seconds.
Tried visitEnds(DemoRun& run) {
    Tried tried;
    // By index: a range-for over make()->knobs() would read a dead temporary; here the stage keeps the demo alive.
    const std::vector<Knob*>& knobs = run.demo().knobs();
    for (Knob* knob : knobs) {
        const std::string before = knob->text();
        for (const std::string& end : knob->sweep()) {
            const std::string value = sanitized ? affordable(knob->name(), end) : end;
            knob->parse(value);
            EXPECT_EQ(knob->text(), value);
            ++tried.cases;
            if (run.refusal().empty()) {
                visitScene(knob->name() + " = " + value, Times::once);
                for (const std::string& message : run.messages()) tried.sentences.insert(message);
            } else {
                ++tried.refused;
                tried.sentences.insert(visitRefused(run));
            }
        }
        knob->parse(before);
    }
    EXPECT_LE(tried.refused, tried.cases / 10) << "at least 90 % of the settings draw";
    return tried;
}

// The target has the buffers that the demo declares, and no other.
void expectBuffersAsDeclared() {
    stage().front().bind();
    const Needs& needs = stage().info().needs;
    const auto present = [](GLenum attachment) {
        GLint kind = 0;
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &kind);
        return kind != GL_NONE;
    };
    EXPECT_EQ(present(GL_DEPTH_ATTACHMENT), needs.depth || needs.stencil);
    EXPECT_EQ(present(GL_STENCIL_ATTACHMENT), needs.stencil);
    GLint samples = -1;
    glGetIntegerv(GL_SAMPLES, &samples);
    EXPECT_EQ(samples, needs.samples);
}

// The declaration is true: its buffers, whether it moves, and all that ES 3.0 lacks and these frames have used. In
// ./test --full the sanitizers' program asks it, in --long the other one, too.
TEST_P(Visits, ends) {
    if (!sanitized && !isLong()) return;
    stage();
    watchBeyondEs();
    DemoRun run(GetParam());
    drawSmall();
    expectBuffersAsDeclared();
    const auto opening = visitScene("initial");
    EXPECT_EQ(drawnOnce(17, true) != opening, stage().info().animated);
    const Tried tried = visitEnds(run);
    std::set<std::string> declared;
    for (const BeyondEs& lacking : stage().info().needs.beyondEs) declared.insert(lacking.feature);
    EXPECT_EQ(stopWatchingBeyondEs(), declared) << ".needs = {.beyondEs = ...} is not what the demo uses";
    std::printf("%s on %s: %d settings, %d refused\n", GetParam().c_str(), stage().driver().host.c_str(), tried.cases,
                tried.refused);
}

// The features that a demo asks for by has(), as if the context lacked it: it draws all the same, does not use it, and says so.
TEST_P(Visits, ends_without_what_a_context_may_lack) {
    stage();
    const DemoInfo& info = findDemo(GetParam());
    for (const BeyondEs& lacking : info.needs.beyondEs) {
        const std::set<std::string> asked{
            beyond_es::clipControl,  beyond_es::floatBlending,  beyond_es::clipDistances,  beyond_es::geometryShaders,
            beyond_es::tessellation, beyond_es::computeShaders, beyond_es::countingQueries};
        if (!asked.contains(lacking.feature)) continue;  // others are asked by isEs(), and met in ES itself
        SCOPED_TRACE("without " + lacking.feature);
        withhold({lacking.feature});
        watchBeyondEs();
        {
            DemoRun run(GetParam());
            drawSmall();
            visitScene("initial");
            if (!sanitized) {
                Tried tried;
                for (const std::string& message : run.messages()) tried.sentences.insert(message);
                tried.sentences.merge(visitEnds(run).sentences);
                const bool said = std::any_of(
                    tried.sentences.begin(), tried.sentences.end(),
                    [&](const std::string& one) { return one.find("has no " + lacking.feature) != std::string::npos; });
                EXPECT_TRUE(said) << "no setting says what it lacks";
            }
        }
        EXPECT_FALSE(stopWatchingBeyondEs().contains(lacking.feature));
        withhold({});
        stage().close();
    }
}

// Knobs that change no picture on purpose.
const std::set<std::string> unseen{
    "shadow-map keep",       // what is kept is what would be drawn again
    "shadow-lights keep",    // the same
    "shadow-methods keep",   // the same
    "environment keep",      // the same
    "mirror keep",           // the same
    "mirror leave-out",      // what is left out is not seen
    "displacement cull",     // the same
    "rasterizer places",     // is asked for only where edges are sampled
    "lights ask",            // lights that are off, or reach nothing, give nothing
    "springs confirm",       // a line of words, likewise
    "gpu-stages direct3d",   // names of stages, likewise
    "color-models written",  // numbers in words, likewise
    "pipeline far",          // the depth, in words likewise
    "clipping polygon",      // its ends, all corners in one place or on one line, are refused: they are no polygon
    "clipping against",      // the same
    "clipping offset",       // digits of coordinates, in words for which pictures as small as these have no room
    "texture-map wrap",      // nothing lies beyond 0..1 before reach is set, too
    "ray-cast threads",      // who computes a row changes nothing
    "ray-trace structure",   // who is asked for a triangle, likewise
};

// In the first setting that a knob calls idle, for each of its reasons, another value of it changes no byte of the picture (in ./test --long
// in each setting, each value); and a knob that changes none in any of the settings below says so there, or is one of the above. The
// settings: each preset, and beside the first one each choice and switch.
TEST_P(Visits, idle_knobs) {
    if (sanitized) return;
    const bool small = hasPasses(findDemo(GetParam()));
    DemoRun run(GetParam(), small ? 36 : 160, small ? 24 : 120);
    const std::vector<Knob*>& knobs = run.demo().knobs();
    std::set<std::string> seen;
    std::set<std::pair<std::string, std::string>> saidIdle;
    int cases = 0;
    const auto drawn = [&]() -> std::optional<Picture> {
        if (!run.refusal().empty()) return {};
        stage().draw(1);
        return stage().picture();
    };
    const auto tryAll = [&](const std::string& context) {
        const auto before = drawn();
        if (!before) return;
        for (Knob* knob : knobs) {
            const std::string reason = knob->idleReason(), present = knob->text();
            if (!reason.empty() && !saidIdle.emplace(knob->name(), reason).second && !isLong()) continue;
            if (reason.empty() && seen.count(knob->name()) > 0) continue;
            for (const std::string& value : knob->sweep()) {
                if (value == present || affordable(knob->name(), value) != value) continue;
                knob->parse(value);
                const auto after = drawn();
                ++cases;
                if (!reason.empty()) {
                    EXPECT_EQ(after, before)
                        << context << ": --" << knob->name() << " " << value
                        << " changes the picture, or is refused, and is said to be idle: " << reason;
                    if (!isLong()) break;
                } else if (after && after != before) {
                    seen.insert(knob->name());
                    break;
                }
            }
            knob->parse(present);
        }
    };
    for (const Preset& preset : stage().info().presets) {
        applyPreset(run.demo(), preset);
        tryAll(preset.name);
        if (&preset != stage().info().presets.data()) continue;
        for (Knob* knob : knobs) {
            const std::string present = knob->text();
            const bool few = !knob->options().empty() || knob->range() == "on | off";
            for (const std::string& value : few ? knob->sweep() : std::vector<std::string>{}) {
                if (value == present || affordable(knob->name(), value) != value) continue;
                knob->parse(value);
                tryAll(preset.name + " --" + knob->name() + " " + value);
            }
            knob->parse(present);
        }
    }
    for (const Knob* knob : knobs) {
        const std::string name = GetParam() + " " + knob->name();
        EXPECT_EQ(seen.count(knob->name()), 1 - unseen.count(name))
            << name << (seen.count(knob->name()) ? " is listed as unseen, and is seen" : " changes no picture");
    }
    std::printf("%s: %d cases, %zu reasons of knobs to be idle\n", GetParam().c_str(), cases, saidIdle.size());
}

// The knobs of the open demo, each with the values that are tried: every option of a choice, both of a toggle, and of a
// number its ends and its initial value. What takes seconds a picture is drawn once, in `ends`, and not here.
class Settings {
  public:
    explicit Settings(Demo& demo) : demo_(demo) {
        for (const Knob* knob : demo.knobs()) {
            std::vector<std::string> values;
            const auto add = [&](const std::string& value) {
                if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
            };
            const std::vector<std::string> ends = knob->sweep();
            const bool number = knob->options().empty() && ends.size() > 2;
            const auto tried = [&](const std::string& value) { return affordable(knob->name(), value); };
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
    const CoveringRow& usual() const { return usual_; }

    void strike(const CoveringRow& row) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            demo_.knobs()[i]->parse(values_[i][static_cast<std::size_t>(row[i])]);
        }
    }
    bool allowed(const CoveringRow& row) {
        strike(row);
        try {
            demo_.check();
            return true;
        } catch (const Error&) {
            return false;
        }
    }
    CoveringRow usualWith(const ValuePair& pair) const {
        CoveringRow row = usual_;
        row[static_cast<std::size_t>(pair.factorA)] = pair.valueA;
        row[static_cast<std::size_t>(pair.factorB)] = pair.valueB;
        return row;
    }

  private:
    Demo& demo_;
    std::vector<std::vector<std::string>> values_;
    std::vector<int> levels_;
    CoveringRow usual_;
};

// The settings of one row after the other, with their readouts, and then in reverse, without: each has the same bytes both times,
// whatever was drawn or measured before it. What a demo keeps from frame to frame and should not have kept shows where
// neighbours differ by one knob.
void visitBothWays(Settings& settings, const std::vector<CoveringRow>& rows) {
    std::vector<std::optional<Picture>> pictures;
    for (const CoveringRow& row : rows) {
        settings.strike(row);
        pictures.push_back(drawnOnce(1, true));
    }
    for (std::size_t i = rows.size(); i-- > 0;) {
        if (!pictures[i]) continue;
        settings.strike(rows[i]);
        EXPECT_EQ(drawnOnce(1, false), pictures[i]) << "another picture the second time, in row " << i;
    }
}

// Pairs of ends of two knobs, in rows, each with as many as can be of the pairs that no row before it has: the first eight rows; in
// ./test --long all, in which each pair is drawn, or refused by itself; and there each by itself, too, while all other knobs are as they open.
TEST_P(Visits, pairs_of_ends) {
    if (sanitized) return;
    DemoRun run(GetParam(), 64, 48);
    Settings settings(run.demo());
    const CoveringArray array = coveringArray(settings.levels(), settings.usual(),
                                              [&](const CoveringRow& row) { return settings.allowed(row); });
    std::vector<CoveringRow> rows = array.rows;
    if (!isLong() && rows.size() > 8) rows.resize(8);
    visitBothWays(settings, rows);
    for (const ValuePair& pair : array.refused) {
        settings.strike(settings.usualWith(pair));
        visitRefused(run);
    }
    std::printf("%s: %zu knobs, %zu settings, %zu pairs refused\n", GetParam().c_str(), settings.levels().size(),
                rows.size(), array.refused.size());
    if (!isLong()) return;
    std::set<CoveringRow> each;  // without those that come again: a pair of initial values is all of them
    int refused = 0;
    forEachPair(settings.levels(), [&](const ValuePair& pair) {
        const CoveringRow row = settings.usualWith(pair);
        if (settings.allowed(row)) {
            each.insert(row);
        } else {
            visitRefused(run);
            ++refused;
        }
    });
    visitBothWays(settings, {each.begin(), each.end()});
    std::printf("%s: %zu settings, %d refused\n", GetParam().c_str(), each.size(), refused);
}

}  // namespace
}  // namespace mv::test
