#include "mv/paper/audit.h"

#include <algorithm>
#include <charconv>
#include <iostream>
#include <iterator>
#include <set>

#include "mv/gl/beyond_es.h"
#include "mv/gl/undefined.h"
#include "mv/paper/report.h"
#include "mv/run/render.h"

namespace mv {
namespace {

// Findings that are told and fail nothing.
bool isSetAgain(std::string_view kind) { return kind == waste::stateAgain || kind == waste::uniformAgain; }

// Whether the finding is what was declared: word for word, but that # stands for a number.
bool isWordForWord(std::string_view found, std::string_view declared) {
    while (!declared.empty()) {
        if (declared.front() == '#') {
            const auto digits = std::min(found.find_first_not_of("0123456789"), found.size());
            if (digits == 0) return false;
            found.remove_prefix(digits);
        } else {
            if (!found.starts_with(declared.front())) return false;
            found.remove_prefix(1);
        }
        declared.remove_prefix(1);
    }
    return found.empty();
}

// And not more often than was declared: "draw of 'tree', up to 6 times".
bool isDeclared(const Finding& finding, std::string_view declared) {
    constexpr std::string_view upTo = ", up to ";
    const auto at = declared.rfind(upTo);
    if (at == std::string_view::npos) return isWordForWord(finding.what, declared);
    const std::string_view bound = declared.substr(at + upTo.size());
    int times = 0;
    std::from_chars(bound.data(), bound.data() + bound.size(), times);
    return finding.times <= times && isWordForWord(finding.what, declared.substr(0, at));
}

void sortFindings(AuditReport& report, const DemoInfo& info, std::vector<Finding> findings) {
    std::vector<bool> needed(info.waste.size(), false);
    for (Finding& finding : findings) {
        if (isSetAgain(finding.kind)) {
            report.again.push_back(std::move(finding));
            continue;
        }
        const auto excuse = std::find_if(info.waste.begin(), info.waste.end(), [&](const DeclaredWaste& waste) {
            return waste.kind == finding.kind && isDeclared(finding, std::string_view(waste.what));
        });
        if (excuse == info.waste.end()) {
            report.findings.push_back(std::move(finding));
        } else {
            needed[static_cast<std::size_t>(excuse - info.waste.begin())] = true;
            report.excused.emplace_back(std::move(finding), excuse->reason);
        }
    }
    for (std::size_t i = 0; i < needed.size(); ++i) {
        const DeclaredWaste& waste = info.waste.begin()[i];
        if (isSetAgain(waste.kind) || std::find(std::begin(waste::all), std::end(waste::all),
                                                std::string_view(waste.kind)) == std::end(waste::all)) {
            throw Error(info.name, "must declare waste of a kind that ends --audit with status 1",
                        "'" + waste.kind + "'");
        }
        if (!needed[i]) report.idleExcuses.push_back(waste.kind + ", " + waste.what);
    }
}

std::vector<std::string> undeclaredBeyondEs(const DemoInfo& info, const std::set<std::string>& used) {
    std::vector<std::string> undeclared;
    for (const std::string& feature : used) {
        const auto& declared = info.needs.beyondEs;
        if (std::none_of(declared.begin(), declared.end(), [&](const BeyondEs& d) { return d.feature == feature; })) {
            undeclared.push_back(feature);
        }
    }
    return undeclared;
}

std::string line(const std::string& name, const FrameWork& work) {
    const auto number = [](long value) { return std::to_string(value); };
    return name + number(work.draws) + " draws in " + number(work.passes) + " passes; triangles " +
           number(work.triangles.submitted) + " submitted, " + number(work.triangles.outside) + " outside, " +
           number(work.triangles.culled) + " culled, " + number(work.triangles.surviving) + " surviving; " +
           number(work.samplesPassed) + " samples passed; " + number(work.bytesUploaded) + " bytes uploaded; " +
           number(work.stateChanges) + " state changes\n";
}

// A demo's own words about its work, once with their number of times.
void noteNeedless(std::vector<Finding>& said, const std::string& what) {
    const auto known = std::find_if(said.begin(), said.end(), [&](const Finding& one) { return one.what == what; });
    if (known == said.end()) {
        said.push_back({.kind = waste::needlessWork, .what = what});
    } else {
        ++known->times;
    }
}

std::string findingText(const Finding& finding) {
    return finding.kind + ": " + finding.what +
           (finding.times > 1 ? ", " + std::to_string(finding.times) + " times" : "") +
           (finding.bytes > 0 ? ", " + std::to_string(finding.bytes) + " bytes" : "");
}

}  // namespace

AuditReport auditDemo(Stage& stage, const DemoInfo& info, const std::vector<KnobSetting>& knobs, int index) {
    AuditReport report;
    report.demo = info.name;
    std::vector<Finding> findings, said;
    startAudit();
    try {
        stage.open(info, info.width, info.height);
        applyKnobs(stage.demo(), knobs);
        for (const bool repeats : {false, true}) {
            // Inside of the frame the stage's own binding of its target is the first: it is the frame's beginning.
            stage.front().bind();
            beginAuditedFrame(repeats);
            stage.draw(index);
            (repeats ? report.steady : report.first) = endAuditedFrame();
            report.undone = stage.undone();
            for (const std::string& what : stage.notes().needless) noteNeedless(said, what);
        }
        findings = stopAudit();
        findings.insert(findings.end(), said.begin(), said.end());
        report.undeclaredBeyondEs = undeclaredBeyondEs(info, takeBeyondEs());
    } catch (...) {
        stopAudit();
        throw;
    }
    report.remarks = driverRemarks();
    stage.close();
    sortFindings(report, info, std::move(findings));
    return report;
}

std::string auditText(const AuditReport& report) {
    std::string text = line("first frame   ", report.first) + line("next, the same ", report.steady);
    for (std::size_t i = 0; i < report.undone.size(); ++i) {
        text += (i == 0 ? "undone after it: " : ", ") + report.undone[i];
    }
    if (!report.undone.empty()) text += "\n";
    for (const Finding& finding : report.findings) text += "needless  " + findingText(finding) + "\n";
    for (const Finding& finding : report.again) text += "again     " + findingText(finding) + "\n";
    for (const auto& [finding, reason] : report.excused) {
        text += "declared  " + findingText(finding) + " (" + reason + ")\n";
    }
    for (const std::string& feature : report.undeclaredBeyondEs) {
        text += "undeclared  " + feature + ": OpenGL ES 3.0 lacks it; declare it in .needs = {.beyondEs = ...}\n";
    }
    if (!report.remarks.empty()) text += "what the driver says:\n" + remarksText(report.remarks, "  ");
    if (report.clean())
        text += "nothing needless" + std::string(report.excused.empty() ? "" : " that is not declared") + "\n";
    return text;
}

void audit(const Command& command) {
    HeadlessStage headless(command.host);
    listenToDriver(true);
    watchUndefined(true);
    int dirty = 0;
    for (const DemoInfo& info : catalogue()) {
        if (!command.all && &info != command.demo) continue;
        const AuditReport report = auditDemo(headless.stage, info, command.knobs, command.firstFrame);
        if (!report.clean()) ++dirty;
        std::cout << info.name << "\n" << auditText(report) << std::flush;
    }
    if (!std::cout) throw Error("standard output", "could not be written");
    if (dirty > 0) throw Error("audit", "must find nothing needless; demos with findings:", std::to_string(dirty));
}

std::string needsPage() {
    std::string text =
        "# What each demo needs, and what its frame costs\n\nMade by `./run --docs .`; do not edit. Work of the first "
        "frame at the initial settings, and of the same frame\nonce more (after the arrow, where it differs): what was "
        "made once and kept is not made again. `./run DEMO --audit`\nshows it for any settings, and names what is "
        "needless.\n\n"
        "| demo | buffers | OpenGL | draws | passes | triangles | culled | outside | samples passed | bytes uploaded "
        "|\n"
        "|---|---|---|---:|---:|---:|---:|---:|---:|---:|\n";
    HeadlessStage headless;
    for (const DemoInfo& info : catalogue()) {
        const AuditReport report = auditDemo(headless.stage, info, {}, 1);
        const auto both = [&](const auto& number) {
            const long first = number(report.first), steady = number(report.steady);
            return std::to_string(first) + (first == steady ? "" : " → " + std::to_string(steady)) + " | ";
        };
        std::string buffers = "color";
        if (info.needs.depth) buffers += ", depth";
        if (info.needs.stencil) buffers += ", stencil";
        std::string versions =
            std::to_string(info.needs.gl / 10) + "." + std::to_string(info.needs.gl % 10) + ", ES 3.0";
        for (const BeyondEs& lacking : info.needs.beyondEs) {
            versions += (&lacking == info.needs.beyondEs.begin() ? " without " : ", ") + lacking.feature;
        }
        if (info.needs.samples) buffers += ", " + std::to_string(info.needs.samples) + " samples";
        text.append("| [").append(info.name).append("](../").append(info.page).append(") | ");
        text.append(buffers).append(" | ").append(versions).append(" | ");
        text += both([](const FrameWork& work) { return work.draws; });
        text += both([](const FrameWork& work) { return work.passes; });
        text += both([](const FrameWork& work) { return work.triangles.submitted; });
        text += both([](const FrameWork& work) { return work.triangles.culled; });
        text += both([](const FrameWork& work) { return work.triangles.outside; });
        text += both([](const FrameWork& work) { return work.samplesPassed; });
        std::string last = both([](const FrameWork& work) { return work.bytesUploaded; });
        while (last.ends_with(' ')) last.pop_back();
        text += last + "\n";
    }
    std::string declared;
    for (const DemoInfo& info : catalogue()) {
        for (const DeclaredWaste& waste : info.waste) {
            declared += "- " + info.name + ", " + waste.kind + " (" + waste.what + "): " + waste.reason + "\n";
        }
    }
    if (!declared.empty()) text += "\nNeedless work that a demo declares, and why:\n\n" + declared;
    std::string beyond;
    for (const DemoInfo& info : catalogue()) {
        for (const BeyondEs& lacking : info.needs.beyondEs) {
            beyond += "- " + info.name + ", " + lacking.feature + ": " + lacking.otherwise + "\n";
        }
    }
    if (!beyond.empty()) {
        text += "\nWhat OpenGL ES 3.0, and so WebGL 2, lacks for a demo, and what it does there instead:\n\n" + beyond;
    }
    return text;
}

}  // namespace mv
