#include "verdict.h"

static const bool added = (verdicts()["one"] =
#include "../shaders/one.frag"
                               ) != "";
