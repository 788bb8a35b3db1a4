// Put before each demo's files: a page shows the study that is committed and measures none, so that only the probes of study.cpp
// are built in; the references, and what is said of them, are used by nothing then.
#pragma once
#include "mv/demo/study.h"

#pragma clang diagnostic ignored "-Wunused-function"
#pragma clang diagnostic ignored "-Wunused-const-variable"
#define addStudy(name, study) true
