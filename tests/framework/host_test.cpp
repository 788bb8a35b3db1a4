#include "mv/host/context.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "mv/error.h"

using namespace mv;

// Contexts are made in processes of their own by tests/programs.cpp; here are the refusals that need none.
TEST(Hosts, osmesa_has_no_es) {
    std::vector<std::string> notes;
    EXPECT_THROW(openHeadless(HostKind::osmesa, {.version = 30, .es = true}, notes), Error);
}

TEST(Hosts, a_version_that_no_driver_has_is_refused_by_each) {
    std::vector<std::string> notes;
    EXPECT_THROW(openHeadless(HostKind::osmesa, {.version = 99}, notes), Error);
    EXPECT_THROW(openHeadless(HostKind::egl, {.version = 99}, notes), Error);
    EXPECT_THROW(openHeadless(HostKind::eglDevice, {.version = 99}, notes), Error);
    try {
        openHeadless(HostKind::automatic, {.version = 99}, notes);
        ADD_FAILURE() << "OpenGL 9.9 must be refused";
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("libosmesa6"), std::string::npos) << "the remedy names the packages: " << text;
        EXPECT_NE(text.find("OSMesa"), std::string::npos);
        EXPECT_NE(text.find("EGL surfaceless"), std::string::npos) << "and the reason of each host: " << text;
    }
}

TEST(Hosts, a_ceiling_that_is_no_version_is_said_once_and_not_of_a_host) {
    for (const char* wrong : {"x", "", "3.2", "9.9"}) {
        setenv("MVGL_GL", wrong, 1);
        std::vector<std::string> notes;
        try {
            openHeadless(HostKind::automatic, {}, notes);
            ADD_FAILURE() << wrong << " must be refused";
        } catch (const Error& error) {
            EXPECT_EQ(error.what(), "MVGL_GL: must be a core version of OpenGL: 3.3, or from 4.0 to 4.6" +
                                        (*wrong ? ", " + std::string(wrong) : ""));
        }
    }
    unsetenv("MVGL_GL");
}
