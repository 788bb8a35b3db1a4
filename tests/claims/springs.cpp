#include <gtest/gtest.h>

#include "support/demo_run.h"
