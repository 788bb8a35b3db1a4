#include "verdict.h"

static const bool added = (verdicts()["two"] =
#include "../shaders/two.frag"
                               ) != "";
