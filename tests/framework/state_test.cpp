// OpenGL's state, as the function table keeps it.
#include "mv/gl/state.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/demo_run.h"

#include "mv/gl/gl.h"
#include "mv/gl/object.h"
#include "mv/show/stage.h"

using namespace mv;
using namespace mv::test;

namespace {

GLint integer(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
}

class State : public testing::Test {
  protected:
    void SetUp() override {
        stage();
        restoreInitialState();
    }
    void TearDown() override {
        restoreInitialState();
        EXPECT_EQ(takeErrors(), std::vector<std::string>());
    }
};

}  // namespace

TEST_F(State, what_was_changed_is_put_back_and_nothing_else) {
    EXPECT_EQ(restoreInitialState(), 0);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_DITHER);
    glDepthFunc(GL_GREATER);
    glDepthFunc(GL_LESS);  // as it was
    glBlendFunc(GL_ONE, GL_ONE);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const std::vector<std::string> changed{"glBlendFunc", "glColorMask", "glEnable(GL_DEPTH_TEST)",
                                           "glDisable(GL_DITHER)", "glPixelStorei"};
    EXPECT_EQ(changedState(), changed);
    EXPECT_EQ(restoreInitialState(), 5);
    EXPECT_TRUE(changedState().empty());
    // Asked of the driver
    EXPECT_EQ(glIsEnabled(GL_DEPTH_TEST), GL_FALSE);
    EXPECT_EQ(glIsEnabled(GL_DITHER), GL_TRUE);
    EXPECT_EQ(integer(GL_BLEND_SRC_RGB), GL_ONE);
    EXPECT_EQ(integer(GL_BLEND_DST_ALPHA), GL_ZERO);
    EXPECT_EQ(integer(GL_UNPACK_ALIGNMENT), 4);
    GLint mask[4] = {0, 0, 0, 0};
    glGetIntegerv(GL_COLOR_WRITEMASK, mask);
    for (const GLint channel : mask) EXPECT_EQ(channel, GL_TRUE);
}

TEST_F(State, the_faces_stencils_are_kept_apart) {
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
    glStencilFuncSeparate(GL_FRONT, GL_EQUAL, 3, 0xF);
    EXPECT_EQ(restoreInitialState(), 2);
    EXPECT_EQ(integer(GL_STENCIL_BACK_PASS_DEPTH_FAIL), GL_KEEP);
    EXPECT_EQ(integer(GL_STENCIL_FUNC), GL_ALWAYS);
    EXPECT_EQ(integer(GL_STENCIL_REF), 0);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    EXPECT_EQ(restoreInitialState(), 2);
    EXPECT_EQ(integer(GL_STENCIL_PASS_DEPTH_PASS), GL_KEEP);
}

TEST_F(State, a_scope_puts_back_what_it_found) {
    const TextureObject texture = makeTexture(), other = makeTexture();
    glActiveTexture(GL_TEXTURE3);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    {
        const StateScope scope;
        glDisable(GL_BLEND);
        glEnable(GL_SCISSOR_TEST);
        glDepthMask(GL_TRUE);
        glBindTexture(GL_TEXTURE_2D, other.id());
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, other.id());
    }
    EXPECT_EQ(glIsEnabled(GL_BLEND), GL_TRUE);
    EXPECT_EQ(glIsEnabled(GL_SCISSOR_TEST), GL_FALSE);
    EXPECT_EQ(integer(GL_DEPTH_WRITEMASK), GL_FALSE);
    EXPECT_EQ(integer(GL_ACTIVE_TEXTURE), GL_TEXTURE3);
    EXPECT_EQ(integer(GL_TEXTURE_BINDING_2D), GLint(texture.id()));
    glActiveTexture(GL_TEXTURE0);
    EXPECT_EQ(integer(GL_TEXTURE_BINDING_2D), 0);
}

// Names are given again: what is deleted must not be bound again later.
TEST_F(State, what_is_deleted_is_bound_no_more) {
    {
        const TextureObject texture = makeTexture();
        glBindTexture(GL_TEXTURE_2D, texture.id());
        const Buffer buffer = makeBuffer();
        glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
        const VertexArray array = makeVertexArray();
        glBindVertexArray(array.id());
        const GLuint program = glCreateProgram();
        glDeleteProgram(program);
        EXPECT_FALSE(changedState().empty());
    }
    EXPECT_TRUE(changedState().empty());
    EXPECT_EQ(restoreInitialState(), 0);
}

// Words over a picture that was blended otherwise, by the smaller value say.
TEST_F(State, what_lies_over_a_picture_is_added_by_alpha) {
    glBlendEquation(GL_MIN);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
    {
        const StateScope scope;
        setOverlayState(Overlay::hiddenByWhatIsNearer);
        EXPECT_EQ(integer(GL_BLEND_EQUATION_RGB), GL_FUNC_ADD);
        EXPECT_EQ(integer(GL_BLEND_SRC_RGB), GL_SRC_ALPHA);
        EXPECT_EQ(integer(GL_DEPTH_FUNC), GL_LEQUAL);
    }
    EXPECT_EQ(integer(GL_BLEND_EQUATION_RGB), GL_MIN);
}

TEST_F(State, a_switch_is_set_by_a_value_where_it_differs) {
    setEnabled(GL_CULL_FACE, false);
    setEnabled(GL_DITHER, true);
    EXPECT_TRUE(changedState().empty());
    setEnabled(GL_CULL_FACE, true);
    setEnabled(GL_DITHER, false);
    EXPECT_EQ(glIsEnabled(GL_CULL_FACE), GL_TRUE);
    EXPECT_EQ(glIsEnabled(GL_DITHER), GL_FALSE);
    EXPECT_EQ(changedState().size(), 2U);
    setEnabled(GL_CULL_FACE, false);
    EXPECT_EQ(glIsEnabled(GL_CULL_FACE), GL_FALSE);
}

TEST_F(State, switching_off_sets_only_what_is_on) {
    switchOff(GL_BLEND);
    EXPECT_TRUE(changedState().empty());
    switchOff(GL_DITHER);
    EXPECT_EQ(glIsEnabled(GL_DITHER), GL_FALSE);
    glEnable(GL_BLEND);
    switchOff(GL_BLEND);
    EXPECT_EQ(glIsEnabled(GL_BLEND), GL_FALSE);
}
