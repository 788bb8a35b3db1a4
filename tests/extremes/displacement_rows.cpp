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

[[maybe_unused]] const bool x53wall = addRow([] {
    return Row{.id = "X53 wall",
               .input = "the brick wall of `displacement --preset cracks`: 96 patches with levels by their distance",
               .measured = "pixels of the background that the wall encloses",
               .naive = "each patch has one level",
               .naiveError = holes("off"),
               .ours = "edgeLevel, and the same bits on both sides",
               .ourError = holes("on"),
               .tolerance = 0,
               .reason = "the wall has no holes"};
});

}  // namespace
