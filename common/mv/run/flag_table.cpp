#include "mv/run/flag_table.h"

#include <algorithm>
#include <array>

namespace mv {
namespace {

// Stand for all flags of knobs, and for the demo's name.
constexpr std::string_view anyKnob = "--KNOB", demoName = "demo";

struct Use {
    std::string_view asks;  // the flag that asks for the action
    Action action;
    std::vector<std::string_view> reads;  // the flags that the action reads beside it
};

// All that says which settings of a demo are meant, and these.
std::vector<std::string_view> settingsAnd(const std::vector<std::string_view>& more) {
    std::vector<std::string_view> all{demoName, anyKnob, "--preset"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

// The first of these flags that is given says what is done; all else that is given must be read by it. Whoever adds a flag
// says here who reads it.
const std::vector<Use>& uses() {
    static const std::vector<Use> all{
        {"--list", Action::list, {demoName}},
        {"--version", Action::version, {demoName}},
        {"--gallery", Action::gallery, {}},
        {"--docs", Action::docs, {}},
        {"--study", Action::study, {demoName, anyKnob, "--preset", "--vary", "--frame", "--size", "--headless"}},
        {"--movie", Action::movie,
         settingsAnd({"--at", "--frame", "--frames", "--vary", "--size", "--density", "--multisample", "--headless"})},
        {"--versus", Action::versus, settingsAnd({"--frame", "--size", "--headless"})},
        {"--plot", Action::plot, {demoName}},
        {"--audit", Action::audit, settingsAnd({"--frame", "--headless", "--all"})},
        {"--knobs", Action::knobs, {demoName, anyKnob, "--preset"}},
        {"--copyable", Action::copyable,
         settingsAnd({"--at", "--frame", "--size", "--density", "--multisample", "--compare", "--strip", "--until"})},
        {"--window", Action::window,
         settingsAnd({"--at", "--frame", "--size", "--density", "--multisample", "--compare", "--report", "--until"})},
        {"--shot", Action::render,
         settingsAnd({"--at", "--frame", "--frames", "--size", "--density", "--multisample", "--compare", "--strip",
                      "--report", "--headless", "--until"})},
        {"--report", Action::render,
         settingsAnd({"--at", "--frame", "--size", "--density", "--multisample", "--headless", "--until"})},
        {"--headless", Action::render,
         settingsAnd({"--at", "--frame", "--size", "--density", "--multisample", "--until"})},
    };
    return all;
}

// Flags of one action that leave each other nothing to do.
constexpr std::array<std::array<std::string_view, 2>, 9> apart{{
    {"--frame", "--frames"},   // two ways to say which
    {"--vary", "--frames"},    // a movie is over values or over time
    {"--strip", "--compare"},  // each says which pictures there are
    {"--strip", "--report"},   // as of --compare
    {"--strip", "--until"},
    {"--multisample", "--until"},  // a stopped frame shows its buffers, pixel by pixel
    {"--until", "--frames"},       // a list is of one frame
    {"--until", "--compare"},      // and of one setting
    {"--report", "--compare"},     // a report is of one setting (a window with both reports what is shown)
}};

const Use& windowUse() {
    return *std::find_if(uses().begin(), uses().end(), [](const Use& use) { return use.action == Action::window; });
}

bool reads(const Use& use, std::string_view flag) {
    return flag == use.asks || std::find(use.reads.begin(), use.reads.end(), flag) != use.reads.end();
}

// "--study", "--shot, --copyable or --window": the flags that say what is done and read this one, the usual ones first.
std::string goesWith(std::string_view flag) {
    std::vector<std::string_view> asking;
    for (const Use& use : uses()) {
        if (use.asks != flag && reads(use, flag)) asking.insert(asking.begin(), use.asks);
    }
    std::string text;
    for (std::size_t i = 0; i < asking.size(); ++i) {
        text.append(i == 0 ? "" : i + 1 == asking.size() ? " or " : ", ").append(asking[i]);
    }
    return text;
}

// `kind` is the flag's name in the table.
void require(const Use& use, bool asked, std::string_view flag, std::string_view kind) {
    if (reads(use, kind)) return;
    const std::string beside = asked ? std::string("beside ").append(use.asks) : "in a window";
    const bool asks = std::any_of(uses().begin(), uses().end(), [&](const Use& each) { return each.asks == kind; });
    const std::string remedy = kind == demoName ? "" : goesWith(kind);
    if (asks && remedy.empty()) throw UsageError(flag, "must not stand " + beside + ": each asks for something else");
    throw UsageError(flag, (remedy.empty() ? "" : "needs " + remedy + ", and ") + "does nothing " + beside);
}

}  // namespace

bool GivenFlags::has(std::string_view flag) const { return std::find(flags.begin(), flags.end(), flag) != flags.end(); }

Action actionOf(const GivenFlags& given) {
    const auto found = std::find_if(uses().begin(), uses().end(), [&](const Use& use) { return given.has(use.asks); });
    const bool asked = found != uses().end();
    const Use& use = asked ? *found : windowUse();
    for (const std::string& flag : given.flags) require(use, asked, flag, flag);
    for (const std::string& knob : given.knobs) require(use, asked, knob, anyKnob);
    if (given.demo) require(use, asked, "demo", demoName);
    for (const auto& [one, other] : apart) {
        if (use.action == Action::window && one == "--report") continue;
        if (given.has(one) && given.has(other)) {
            throw UsageError(one, std::string("must not stand beside ").append(other));
        }
    }
    return use.action;
}

}  // namespace mv
