#include <gtest/gtest.h>
#include "work_precision/page.h"
TEST(WorkPrecision, stub) {}
