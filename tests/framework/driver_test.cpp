// The messages of a driver by KHR_debug, judged by its type; and the version that is asked for.
#include <gtest/gtest.h>

#include <cstdlib>
#include <initializer_list>
#include <memory>
#include <utility>

#include "mv/error.h"
#include "mv/gl/functions.h"
#include "mv/gl/version.h"
#include "mv/host/context.h"
#include "mv/paper/audit.h"
#include "mv/paper/report.h"
#include "support/demo_of.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

// Puts a message in, as a driver would that says it itself.
void say(GLenum type, GLenum severity, const char* text) {
    const auto insert = reinterpret_cast<PFNGLDEBUGMESSAGEINSERTPROC>(driverFunction("glDebugMessageInsert"));
    ASSERT_NE(insert, nullptr) << "this context has no KHR_debug";
    insert(GL_DEBUG_SOURCE_APPLICATION, type, 1, severity, -1, text);
}

struct Nothing {};
struct Talking final : DemoOf<Nothing> {
    void draw(const Frame&) override { say(type, GL_DEBUG_SEVERITY_MEDIUM, "recompiled"); }
    static inline GLenum type = GL_DEBUG_TYPE_PERFORMANCE;
};

class Driver : public testing::Test {
  protected:
    void SetUp() override {
        stage();
        forgetRemarks();
    }
    void TearDown() override {
        unsetenv("MVGL_GL");
        listenToDriver(true);
        forgetRemarks();
        EXPECT_EQ(takeErrors(), std::vector<std::string>());
    }
};

}  // namespace

TEST_F(Driver, errors_and_undefined_behavior_are_faults_at_any_severity) {
    for (const GLenum severity :
         std::initializer_list<GLenum>{GL_DEBUG_SEVERITY_HIGH, GL_DEBUG_SEVERITY_MEDIUM, GL_DEBUG_SEVERITY_LOW}) {
        say(GL_DEBUG_TYPE_ERROR, severity, "an error");
        EXPECT_EQ(takeErrors(), std::vector<std::string>{"an error"});
        say(GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR, severity, "undefined");
        EXPECT_EQ(takeErrors(), std::vector<std::string>{"undefined"});
    }
    EXPECT_TRUE(driverRemarks().empty());
}

TEST_F(Driver, the_other_types_are_remarks_and_end_no_frame) {
    DemoRun run("cube-cull", 30, 30);
    const std::pair<GLenum, const char*> others[] = {{GL_DEBUG_TYPE_PERFORMANCE, "performance: words"},
                                                     {GL_DEBUG_TYPE_PORTABILITY, "portability: words"},
                                                     {GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR, "deprecated: words"},
                                                     {GL_DEBUG_TYPE_OTHER, "other: words"}};
    for (const auto& [type, words] : others) {
        forgetRemarks();
        say(type, GL_DEBUG_SEVERITY_HIGH, "words");
        say(type, GL_DEBUG_SEVERITY_MEDIUM, "words");
        EXPECT_NO_THROW(run.picture()) << words;
        EXPECT_EQ(driverRemarks(), (std::vector<DriverRemark>{{words, 2}}));
        EXPECT_NE(reportText(stage(), 1, {}).find(std::string("driver    ") + words + ", 2 times\n"),
                  std::string::npos);
        EXPECT_NE(reportJson(stage(), 1, {}).find(words), std::string::npos);
    }
    forgetRemarks();
    say(GL_DEBUG_TYPE_MARKER, GL_DEBUG_SEVERITY_HIGH, "a mark");
    say(GL_DEBUG_TYPE_PERFORMANCE, GL_DEBUG_SEVERITY_NOTIFICATION, "chatter");
    EXPECT_TRUE(driverRemarks().empty());
    EXPECT_EQ(takeErrors(), std::vector<std::string>());
}

// Said twice: an audit draws the frame twice.
TEST_F(Driver, an_audit_tells_remarks_and_is_ended_by_a_fault) {
    DemoInfo talking;
    talking.name = "talking";
    talking.width = talking.height = 30;
    talking.make = [] { return std::make_unique<Talking>(); };
    Talking::type = GL_DEBUG_TYPE_PERFORMANCE;
    const AuditReport report = auditDemo(stage(), talking, {}, 1);
    EXPECT_TRUE(report.clean());
    EXPECT_NE(auditText(report).find("what the driver says:\n  performance: recompiled, 2 times\n"), std::string::npos)
        << auditText(report);
    Talking::type = GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR;
    try {
        auditDemo(stage(), talking, {}, 1);
        ADD_FAILURE() << "undefined behaviour must end it";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("recompiled"), std::string::npos) << error.what();
    }
    stage().close();
}

// A frame of a window asks for no words. glGetError finds the mistake all the same.
TEST_F(Driver, who_does_not_listen_hears_no_words_and_still_finds_errors) {
    listenToDriver(false);
    say(GL_DEBUG_TYPE_PERFORMANCE, GL_DEBUG_SEVERITY_HIGH, "unheard");
    EXPECT_TRUE(driverRemarks().empty());
    GLint none = 0;
    glGetIntegerv(GL_TEXTURE_2D_ARRAY, &none);  // no number to be asked for
    EXPECT_EQ(takeErrors(), std::vector<std::string>{"GL_INVALID_ENUM"});
}

TEST_F(Driver, the_newest_version_is_asked_for_first_and_the_floor_last) {
    EXPECT_EQ(versionsToAskFor(33), (std::vector{46, 45, 44, 43, 42, 41, 40, 33}));
    EXPECT_EQ(versionsToAskFor(43), (std::vector{46, 45, 44, 43}));
    EXPECT_EQ(versionsToAskFor(99), std::vector{99});
    setenv("MVGL_GL", "4.1", 1);
    EXPECT_EQ(versionsToAskFor(33), (std::vector{41, 40, 33}));
    EXPECT_THROW(versionsToAskFor(43), Error);
    for (const char* wrong : {"", "3", "33", "3.2", "4.7", "4.6 ", "nan"}) {
        setenv("MVGL_GL", wrong, 1);
        EXPECT_THROW(newestVersion(), Error) << wrong;
    }
}
