// On each host, by each version: the same bytes. OpenGL ES 3.0 is WebGL 2's.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>

#include "mv/gl/beyond_es.h"
#include "mv/gl/program.h"
#include "mv/gl/shader_source.h"
#include "mv/image/compare.h"
#include "visits/visit.h"

namespace mv::test {
namespace {

std::vector<std::string> filesEndingIn(const std::string& end) {
    std::vector<std::string> names;
    for (const std::string& name : shaderFileNames()) {
        if (name.ends_with(end)) names.push_back(name);
    }
    return names;
}

// Every program of a demo compiles and links as GLSL ES 3.00; what it samples is of high precision, as in OpenGL.
void expectProgramsCompile(const std::string& demo) {
    int compiled = 0;
    for (const std::string& file : filesEndingIn(".vert")) {
        const std::string stem = file.substr(0, file.size() - 5);
        if (stem.substr(0, stem.find_first_of("/.")) != demo) continue;
        bool needsMore = false;  // a stage that ES lacks: said, before anything is compiled
        for (const char* ending : {".geom", ".tesc", ".tese"}) needsMore |= !filesEndingIn(stem + ending).empty();
        if (needsMore) {
            EXPECT_THROW(Program{stem}, Error) << stem;
            continue;
        }
        EXPECT_NO_THROW(Program{stem}) << stem;
        ++compiled;
    }
    // One that draws lines and words alone has the library's programs.
    const bool hasPrograms = demoText(demo).find("Program") != std::string::npos;
    EXPECT_EQ(compiled > 0, hasPrograms) << "shaders/" << demo
                                         << ".vert and .frag must be there for a demo with programs";
    EXPECT_EQ(liveObjects(), 0);
    EXPECT_TRUE(takeErrors().empty());

    const std::string begins = assembleShaderText("any.frag", "").text;
    const std::regex sampler("\\b([iu]?sampler\\w+) ");
    for (const std::string& file : shaderFileNames()) {
        const std::string text = builtInShader(file);
        for (std::sregex_iterator i(text.begin(), text.end(), sampler), end; i != end; ++i) {
            const std::string type = (*i)[1];
            EXPECT_NE(begins.find("precision highp " + type + ";"), std::string::npos) << type << " in " << file;
        }
    }
}

// Whether the picture is said to have been drawn without a whole stage: then it is another one.
bool lacksAStage(const std::vector<std::string>& messages) {
    return std::any_of(messages.begin(), messages.end(), [](const std::string& message) {
        for (const char* stage : {beyond_es::geometryShaders, beyond_es::tessellation, beyond_es::computeShaders}) {
            if (message.find(std::string("has no ") + stage) != std::string::npos) return true;
        }
        return false;
    });
}

using Pictures = std::map<std::string, Picture>;

// The demo as it opens, and with each choice and switch of its knobs, or as it opens alone: by what was set. Without those that are said
// to lack a stage here. (Twice and with its readouts each was drawn in `ends`; here as it opens, and each in ES.)
Pictures scenes(const std::string& name, bool words) {
    const bool small = hasPasses(findDemo(name));
    DemoRun run(name, small ? 32 : 128, small ? 24 : 96);
    Pictures pictures;
    const auto add = [&](const std::string& setting) {
        SCOPED_TRACE(setting);
        const auto picture = isEs() || setting.empty() ? visit() : drawnOnce(1, false);
        if (picture && !lacksAStage(run.messages())) pictures[setting] = *picture;
    };
    add("");
    if (!words) return pictures;
    for (Knob* knob : run.demo().knobs()) {
        const std::string before = knob->text();
        for (const Option& option : knob->options()) {
            knob->parse(option.word);
            if (run.refusal().empty()) add("--" + knob->name() + " " + option.word);
        }
        knob->parse(before);
    }
    return pictures;
}

void expectSame(const Pictures& pictures, const Pictures& right) {
    for (const auto& [setting, picture] : pictures) {
        SCOPED_TRACE(setting);
        ASSERT_TRUE(right.contains(setting));
        EXPECT_EQ(compare(right.at(setting), picture).beyond, 0) << saveFailure("hosts", picture);
    }
}

// EGL draws the same as OSMesa, and so it does where nothing beyond the declared floor is asked for, and in ES: where it
// lacks something there, it says so.
TEST_P(Visits, on_each_host) {
    if (sanitized) return;
    const DemoInfo& info = findDemo(GetParam());
    struct Restored {
        ~Restored() {
            unsetenv("MVGL_GL");
            leaveStage();
        }
    } const afterwards;
    stageOn(HostKind::osmesa);
    const Pictures right = scenes(GetParam(), true);
    setenv("MVGL_GL", (std::to_string(info.needs.gl / 10) + "." + std::to_string(info.needs.gl % 10)).c_str(), 1);
    for (const HostKind host : {HostKind::osmesa, HostKind::egl}) {
        SCOPED_TRACE(host == HostKind::egl ? "EGL at the floor" : "OSMesa at the floor");
        stageOn(host);
        ASSERT_EQ(stage().driver().glVersion, info.needs.gl) << "MVGL_GL is not in force";
        expectSame(scenes(GetParam(), false), right);
    }
    unsetenv("MVGL_GL");
    stageOn(HostKind::egl, true);
    ASSERT_TRUE(isEs());
    expectProgramsCompile(GetParam());
    expectSame(scenes(GetParam(), true), right);
}

}  // namespace
}  // namespace mv::test
