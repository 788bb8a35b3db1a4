// --audit: the work of a frame, and what of it was needless.
#pragma once
#include <string>
#include <vector>

#include "mv/gl/audit.h"
#include "mv/run/command_line.h"
#include "mv/show/stage.h"

namespace mv {

struct AuditReport {
    std::string demo;
    FrameWork first;                  // the first frame after the demo is opened
    FrameWork steady;                 // the same frame once more: what stays to be done while nothing changes
    std::vector<std::string> undone;  // Stage::undone() of that frame
    // Work that the scene does not need and the demo does not declare: passes, draws, buffers, uploads, objects.
    std::vector<Finding> findings;
    // State and uniforms that were set to what they were: worth a look, and no fault.
    std::vector<Finding> again;
    // Findings that the demo declares, with its reasons.
    std::vector<std::pair<Finding, std::string>> excused;
    // Declared exceptions that excuse nothing in these settings.
    std::vector<std::string> idleExcuses;
    // Features that ES 3.0 lacks, used in these frames and not declared in needs.beyondEs.
    std::vector<std::string> undeclaredBeyondEs;
    // The driver's remarks, which are no faults.
    std::vector<DriverRemark> remarks;
    bool clean() const { return findings.empty() && undeclaredBeyondEs.empty(); }
};

// Opens the demo on the stage under audit, draws the frame twice and closes it. Error: as Stage::open and draw; an
// exception declared for a kind of waste that there is not, or that nobody need declare.
AuditReport auditDemo(Stage& stage, const DemoInfo& info, const std::vector<KnobSetting>& knobs, int index);

std::string auditText(const AuditReport& report);

// Prints the report of one demo, or with --all a line a demo. Error: needless work that no demo declares.
void audit(const Command& command);

// docs/needs.md: what each demo needs, and what its frame costs.
std::string needsPage();

}  // namespace mv
