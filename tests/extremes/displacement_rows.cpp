// X53 where it happens: patches of a displaced surface whose neighbours have other levels.
#include <string>

#include "extremes/row.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

double holes(const char* agree) {
    DemoRun run("displacement", 480, 300);
    (void)run.preset("cracks").set("agree", agree).picture();
    return run.readout("holes");
}

[[maybe_unused]] const bool x53orange = addRow([] {
    return Row{.id = "X53 orange",
               .input = "an orange of 96 patches, moved by a fifth of its radius, levels by the distance",
               .measured = "pixels of the background within it",
               .naive = "each patch has one level",
               .naiveError = holes("off"),
               .ours = "edgeLevel, and the same bits on both sides",
               .ourError = holes("on"),
               .tolerance = 0,
               .reason = "the orange is closed"};
});

}  // namespace
