#include "mv/paper/docs.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>

#include "mv/demo/chapters.h"
#include "mv/image/file.h"
#include "mv/image/png.h"
#include "mv/paper/audit.h"
#include "mv/paper/page_numbers.h"
#include "mv/paper/tables.h"
#include "mv/run/render.h"
#include "mv/study/study.h"

namespace mv {
namespace {

std::string controlCell(const Binding& binding) {
    std::string effect = "`" + binding.knob->name() + "` " + binding.knob->stepText(binding.amount, "");
    switch (binding.gesture) {
        case Gesture::key:
            if (!binding.text.empty()) effect = "`" + binding.knob->name() + "` = " + binding.text;
            return "key " + keyName(binding.key) + ": " + effect;
        case Gesture::dragAcross:
            return "drag to the right: " + effect + " a pixel";
        case Gesture::dragDown:
            return "drag down: " + effect + " a pixel";
        case Gesture::wheel:
            return "wheel away from you: " + effect;
    }
    return effect;
}

std::string controlCell(const Handle& handle) {
    std::string knobs;
    for (const Knob* knob : handle.knobs) knobs += (knobs.empty() ? "`" : ", `") + knob->name() + "`";
    return "drag the " + handle.name + " in the picture: " + knobs +
           (handle.add ? " (Ins and Del: one more, one less)" : "");
}

std::string tables(const DemoInfo& info) {
    const auto demo = info.make();
    std::string text = "| knob | range | initially | what it does |\n|---|---|---|---|\n";
    for (const Knob* knob : demo->knobs()) {
        std::string help = knob->help();
        for (const Option& option : knob->options()) {
            if (!option.meaning.empty()) help += "<br>`" + option.word + "`: " + option.meaning;
        }
        text += "| `--" + knob->name() + "` | " + tableCell(knob->rangeInFull()) + " | " + knob->initialText() + " | " +
                tableCell(help) + " |\n";
    }
    if (info.presets.size() > 0) {
        text += "\n| preset | what to look for | settings |\n|---|---|---|\n";
        for (const Preset& preset : info.presets) {
            const std::string settings = settingsText(preset);
            text += "| `--preset " + preset.name + "` | " + tableCell(preset.lookFor) + " | " +
                    (settings.empty() ? "as it opens" : "`" + settings + "`") + " |\n";
        }
    }
    if (!demo->readouts().empty()) {
        text += "\n| readout | unit | what it says |\n|---|---|---|\n";
        for (const Readout* readout : demo->readouts()) {
            text += "| `" + readout->name() + "` | " + readout->unit() + " | " + tableCell(readout->help()) + " |\n";
        }
    }
    std::string controls;
    const auto add = [&](const std::string& control) { controls += (controls.empty() ? "" : " · ") + control; };
    for (const Binding& binding : demo->bindings()) add(controlCell(binding));
    for (const Handle& handle : demo->handles()) add(controlCell(handle));
    if (!controls.empty()) text += "\nControls: " + controls + ".\n";
    return text;
}

std::string needsText(const Needs& needs) {
    std::string text = "color buffer";
    if (needs.depth) text += ", depth buffer";
    if (needs.stencil) text += ", stencil buffer";
    if (needs.samples) text += ", " + std::to_string(needs.samples) + " samples";
    text += "; OpenGL " + std::to_string(needs.gl / 10) + "." + std::to_string(needs.gl % 10);
    if (needs.beyondEs.size() == 0) return text + " or ES 3.0";
    text += "; ES 3.0 lacks";
    for (const BeyondEs& lacking : needs.beyondEs) {
        text += (&lacking == needs.beyondEs.begin() ? " " : ", ") + lacking.feature + " (" + lacking.otherwise + ")";
    }
    return text;
}

// The page with `text` between its lines <!-- name --> and <!-- /name -->. Error: it lacks one of them.
std::string withGenerated(const std::string& page, const std::string& file, const std::string& name,
                          const std::string& text) {
    const std::string begin = "<!-- " + name + " -->\n", end = "<!-- /" + name + " -->";
    const auto from = page.find(begin), to = page.find(end);
    if (from == std::string::npos || to == std::string::npos || to < from) {
        throw Error(file, "must have the lines <!-- " + name + " --> and <!-- /" + name + " -->");
    }
    return page.substr(0, from + begin.size()) + "\n" + text + "\n" + page.substr(to);
}

// A page, or a study's numbers.
std::string fileText(const std::string& path) { return readTextFile(path, std::size_t{1} << 24U); }

}  // namespace

std::string cataloguePage() {
    std::string text =
        "# The demos\n\nGenerated from the declarations in `demos/*.cpp` by `./run --docs`; do not edit.\n"
        "Every demo also understands `--shot`, `--frame`, `--size`, `--compare`, `--report` and the rest of the\n"
        "[command line](../README.md#the-command-line).\n";
    for (const Chapter& chapter : catalogueByChapter()) {
        text += "\n## " + chapter.name + "\n";
        for (const DemoInfo* info : chapter.demos) {
            text += "\n### [" + info->name + "](../" + info->page + ")\n\n" + info->sentence +
                    "\n\nLook for: " + info->lookFor + "\n\nNeeds: " + needsText(info->needs) +
                    ". Picture: " + std::to_string(info->width) + "x" + std::to_string(info->height) + ", " +
                    (info->animated ? "60 frames a second" : "drawn when something changes") + ".\n\n" + tables(*info);
        }
    }
    return text;
}

std::string lessonPage(const std::string& page, const DemoInfo& info) {
    return withGenerated(page, info.page, "knobs", tables(info));
}

std::string readmePage(const std::string& page) {
    std::string text = "| demo | shows |\n|---|---|\n";
    for (const Chapter& chapter : catalogueByChapter()) {
        text += "| **" + chapter.name + "** | |\n";
        for (const DemoInfo* info : chapter.demos) {
            text += "| [" + info->name + "](" + info->page + ") | " + tableCell(info->sentence) + " |\n";
        }
    }
    return withGenerated(page, "README.md", "demos", text);
}

Picture pictureStrip() {
    HeadlessStage headless;
    constexpr int width = 150, height = 100, gap = 6, across = 9;
    const int count = static_cast<int>(catalogue().size());
    // As few rows as there may be, and all about as long
    const int rows = (count + across - 1) / across, columns = (count + rows - 1) / rows;
    Picture strip(columns * width + (columns - 1) * gap, rows * height + (rows - 1) * gap);
    std::fill(strip.rgba.begin(), strip.rgba.end(), std::uint8_t{200});  // grey between the pictures: some are white
    for (std::size_t i = 3; i < strip.rgba.size(); i += 4) strip.rgba[i] = 255;
    int index = 0;
    for (const DemoInfo& info : catalogue()) {
        headless.stage.open(info, info.width, info.height);
        headless.stage.draw(1);
        const int left = index % columns * (width + gap), top = index / columns * (height + gap);
        ++index;
        const Picture small = shrink(headless.stage.picture(), width, height);
        for (int y = 0; y < small.height; ++y) {
            for (int x = 0; x < small.width; ++x) {
                strip.set(left + (width - small.width) / 2 + x, top + (height - small.height) / 2 + y, small.at(x, y));
            }
        }
    }
    headless.stage.close();
    return strip;
}

// docs/errors-and-times/DEMO.processor, without what follows.
static std::string studyStem(const std::string& root, const std::string& demo, Drawer drawer) {
    return root + "/docs/errors-and-times/" + demo + "." + nameOf(drawer);
}

std::vector<StudyRun> studiesInTree(const std::string& root, const std::string& demo) {
    std::vector<StudyRun> runs;
    for (const Drawer drawer : {Drawer::processor, Drawer::gpu}) {
        const std::string file = studyStem(root, demo, drawer) + ".csv";
        if (std::filesystem::exists(file)) runs.push_back(readStudy(fileText(file)));
    }
    return runs;
}

std::vector<std::string> pagesWithNumbers(const std::string& root) {
    std::vector<std::string> pages{"README.md"};
    for (const DemoInfo& info : catalogue()) pages.push_back(info.page);
    std::vector<std::string> docs;
    std::error_code none;  // a tree without docs has no pages there
    for (const auto& entry : std::filesystem::directory_iterator(root + "/docs", none)) {
        if (entry.path().extension() == ".md") docs.push_back("docs/" + entry.path().filename().string());
    }
    std::ranges::sort(docs);
    pages.insert(pages.end(), docs.begin(), docs.end());
    std::erase_if(pages, [&](const std::string& page) {
        const std::string file = root + "/" + page;
        return !std::filesystem::exists(file) || fileText(file).find("<!--=") == std::string::npos;
    });
    return pages;
}

// The pages and plots of the studies whose runs are committed.
static void writeStudyDocs(const std::string& root) {
    for (const DemoInfo& info : catalogue()) {
        const std::vector<StudyRun> runs = studiesInTree(root, info.name);
        if (runs.empty()) continue;
        const std::string page = root + "/docs/errors-and-times/" + info.name + ".md";
        writeFileAtomically(page, std::string_view(studyPage(runs, info)));
        for (const StudyRun& run : runs) {
            const std::string svg = studyStem(root, info.name, drawerOf(run.renderer)) + ".svg";
            writeFileAtomically(svg, std::string_view(studySvg(run)));
        }
        std::cout << page << " and its plots\n";
    }
}

// The pages that are partly generated, each with its new text.
static std::map<std::string, std::string> pagesAnew(const std::string& root) {
    const std::string folder = root + "/";
    std::map<std::string, std::string> pages;
    pages["README.md"] = readmePage(fileText(folder + "README.md"));
    for (const DemoInfo& info : catalogue()) {
        pages[info.page] = lessonPage(fileText(folder + info.page), info);
    }
    std::optional<HeadlessStage> headless;
    NumberSources sources([&](const std::string& demo) { return studiesInTree(root, demo); },
                          [&]() -> Stage& { return (headless ? *headless : headless.emplace()).stage; });
    for (const std::string& page : pagesWithNumbers(root)) {
        const auto [text, isNew] = pages.try_emplace(page);
        if (isNew) text->second = fileText(folder + page);
        text->second = withNumbers(text->second, page, sources);
    }
    return pages;
}

void writeDocs(const std::string& root) {
    std::string missing;
    for (const DemoInfo& info : catalogue()) {
        if (std::filesystem::exists(std::filesystem::path(root) / info.page)) continue;
        missing.append(missing.empty() ? "" : ", ").append(info.page);
    }
    if (!missing.empty()) throw Error("docs in " + root, "each demo must have its page", "missing: " + missing);
    const std::map<std::string, std::string> pages = pagesAnew(root);
    writeFileAtomically(root + "/docs/demos.md", std::string_view(cataloguePage()));
    std::cout << root << "/docs/demos.md\n";
    for (const auto& [page, text] : pages) {
        writeFileAtomically(std::filesystem::path(root) / page, std::string_view(text));
        std::cout << root << "/" << page << "\n";
    }
    writeStudyDocs(root);
    writeFileAtomically(root + "/docs/needs.md", std::string_view(needsPage()));
    std::cout << root << "/docs/needs.md\n";
    writePng(root + "/docs/strip.png", pictureStrip());
    std::cout << root << "/docs/strip.png\n";
}

}  // namespace mv
