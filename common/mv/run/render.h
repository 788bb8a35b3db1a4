// Pictures without a window.
#pragma once
#include "mv/run/command_line.h"

namespace mv {

// Draws what the command asks for: one picture, several, a comparison, a report on standard output.
void render(const Command& command);

// A picture of every demo, and index.html to look through them.
void writeGallery(const std::string& folder);

// A stage on the host asked for; a line on standard error names each host passed over.
struct HeadlessStage {
    explicit HeadlessStage(HostKind host = HostKind::automatic);
    std::unique_ptr<Context> context;
    Stage stage;
};

}  // namespace mv
