// The main of every test program. Unlike GoogleTest's own, it fails where no test was selected and where one was
// skipped: neither proves anything.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "support/demo_run.h"

int main(int count, char** arguments) {
    testing::InitGoogleTest(&count, arguments);
    std::filesystem::current_path(mv::test::tree());  // where a lesson's commands are typed: assets/ is there
    const int result = RUN_ALL_TESTS();
    mv::test::leaveStage();
    const auto& tests = *testing::UnitTest::GetInstance();
    if (testing::GTEST_FLAG(list_tests)) return result;
    if (tests.test_to_run_count() == 0) {
        std::fprintf(stderr, "no test was selected\n");
        return 1;
    }
    if (tests.skipped_test_count() != 0) {
        std::fprintf(stderr, "%d tests were skipped, 0 expected\n", tests.skipped_test_count());
        return 1;
    }
    return result;
}
