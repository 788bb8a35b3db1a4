// Put before each demos/*/study.cpp: a page shows the study that is committed and measures none, so that only the probes of these
// files are built in; the references, and what is said of them, are used by nothing then.
#pragma once
#include "mv/demo/study.h"

#define addStudy(name, study) true
