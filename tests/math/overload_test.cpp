// The errors that overload_trap.cpp shows to the compiler, asked here of the compiler as questions: which calls are
// there?
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"

namespace asMvUserWrites {

using namespace mv;

// A requires expression is false for a call that is deleted or ambiguous: for one that stops the compiler.
template <typename V>
concept LooksAt = requires(V v) {
    lookAt(v, v, v);
};
template <typename V>
concept LooksAtAnyRoll = requires(V v) {
    lookAtAnyRoll(v, v);
};
template <typename V>
concept Translates = requires(V v) {
    translate(v);
};
template <typename V>
concept Scales = requires(V v) {
    scale(v);
};
template <typename T, typename V>
concept Rotates = requires(T angle, V v) {
    rotate(angle, v);
};
template <typename M, typename V>
concept TranslatesOnto = requires(M m, V v) {
    translate(m, v);
};
template <typename M, typename V>
concept ScalesOnto = requires(M m, V v) {
    scale(m, v);
};
template <typename M, typename V>
concept RotatesOnto = requires(M m, typename M::value_type angle, V v) {
    rotate(m, angle, v);
};
template <typename M>
concept HasNormalMatrix = requires(M m) {
    normalMatrix(m);
};
template <typename M>
concept HasPlanes = requires(M m) {
    planesFromClip(m);
};
template <typename M>
concept HasCorners = requires(M m) {
    viewVolumeCorners(m);
};
template <typename V>
concept HasNdc = requires(V v) {
    ndcFromClip(v);
};
template <typename V>
concept HasPixel = requires(V v) {
    pixelFromNdc(v, 4, 4);
};
template <typename V>
concept HasShadow = requires(V v) {
    shadowProjection(v, v);
};
template <typename V, typename W>
concept HasLocalShadow = requires(V v, W w) {
    shadowProjection(v, v, w);
};
template <typename V>
concept HasBounds = requires(V v) {
    shadowCasterBounds(v, v);
};
template <typename V>
concept Reflects = requires(V v) {
    reflection(v);
};
template <typename T>
concept HasPerspective = requires(T t) {
    perspective(t, t, t, t);
};
template <typename T>
concept HasInfinitePerspective = requires(T t) {
    infinitePerspective(t, t, t);
};
template <typename T>
concept HasOrtho = requires(T t) {
    ortho(t, t, t, t, t, t);
};
template <typename T>
concept HasFrustum = requires(T t) {
    frustum(t, t, t, t, t, t);
};

TEST(Overloads, DoubleCallsAreMvs) {
    EXPECT_TRUE(LooksAt<vec3> && LooksAtAnyRoll<vec3> && Translates<vec3> && Scales<vec3>);
    EXPECT_TRUE((Rotates<double, vec3> && Rotates<int, vec3>));
    EXPECT_TRUE(HasNormalMatrix<mat4> && HasPlanes<mat4> && HasCorners<mat4> && HasNdc<vec4> && HasPixel<vec2> &&
                HasPixel<vec3>);
    EXPECT_TRUE((HasShadow<vec4> && HasLocalShadow<vec4, vec3> && HasBounds<vec4> && Reflects<vec4>));
    EXPECT_TRUE(HasPerspective<double> && HasPerspective<int> && HasOrtho<int> && HasFrustum<int>);
    EXPECT_TRUE(HasInfinitePerspective<double> && HasInfinitePerspective<int>);
    // By the checks: GLM's lookAt refuses nothing.
    EXPECT_ANY_THROW(lookAt(vec3(0), vec3(0), vec3(0, 1, 0)));
}

TEST(Overloads, FloatCallsAreErrors) {
    EXPECT_FALSE(LooksAt<fvec3>);
    EXPECT_FALSE(LooksAtAnyRoll<fvec3>);
    EXPECT_FALSE(Translates<fvec3>);
    EXPECT_FALSE(Scales<fvec3>);
    EXPECT_FALSE((Rotates<float, fvec3>));
    EXPECT_FALSE((Rotates<double, fvec3>));
    EXPECT_FALSE((Rotates<int, fvec3>));
    EXPECT_FALSE(HasNormalMatrix<fmat4>);
    EXPECT_FALSE(HasPlanes<fmat4>);
    EXPECT_FALSE(HasCorners<fmat4>);
    EXPECT_FALSE(HasNdc<fvec4>);
    EXPECT_FALSE(HasPixel<fvec2>);
    EXPECT_FALSE(HasPixel<fvec3>);
    EXPECT_FALSE(HasShadow<fvec4>);
    EXPECT_FALSE((HasLocalShadow<fvec4, fvec3>));
    EXPECT_FALSE(HasBounds<fvec4>);
    EXPECT_FALSE(Reflects<fvec4>);
    EXPECT_FALSE(HasPerspective<float>);
    EXPECT_FALSE(HasInfinitePerspective<float>);
    EXPECT_FALSE(HasOrtho<float>);
    EXPECT_FALSE(HasFrustum<float>);
}

TEST(Overloads, CallsOntoAMatrixAreErrors) {
    EXPECT_FALSE((TranslatesOnto<mat4, vec3> || TranslatesOnto<fmat4, fvec3>));
    EXPECT_FALSE((ScalesOnto<mat4, vec3> || ScalesOnto<fmat4, fvec3>));
    EXPECT_FALSE((RotatesOnto<mat4, vec3> || RotatesOnto<fmat4, fvec3>));
}

}  // namespace asMvUserWrites

namespace asGlmUserWrites {

template <typename V>
concept LooksAt = requires(V v) {
    lookAt(v, v, v);
};
template <typename M, typename V>
concept RotatesOnto = requires(M m, typename M::value_type angle, V v) {
    rotate(m, angle, v);
};

// The negative control: without mv's names, argument-dependent lookup does find GLM's, so the trap is real.
TEST(Overloads, WithoutTheGuardTheyWouldBeGlms) {
    EXPECT_TRUE(LooksAt<glm::vec3>);
    EXPECT_TRUE((RotatesOnto<glm::mat4, glm::vec3>));
}

}  // namespace asGlmUserWrites
