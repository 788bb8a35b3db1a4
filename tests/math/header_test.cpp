// mv's headers show their user no GLM transform: neither as text nor to the compiler.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

#include "mv/geometry/check.h"
#include "mv/geometry/in_view.h"
#include "mv/geometry/mesh_data.h"
#include "mv/geometry/shapes.h"
#include "mv/math/clip.h"
#include "mv/math/color.h"
#include "mv/math/color_difference.h"
#include "mv/math/depth_range.h"
#include "mv/math/exact_sum.h"
#include "mv/math/projection.h"
#include "mv/math/reflect.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"
#include "mv/math/shadow.h"
#include "mv/math/shadow_caster.h"
#include "mv/math/shadow_textbook.h"
#include "mv/math/shear.h"
#include "mv/math/stereo.h"
#include "mv/math/transform.h"
#include "mv/math/types.h"
#include "mv/math/unproject.h"
#include "mv/motion/arc_length.h"
#include "mv/motion/curve.h"
#include "mv/motion/decomposition.h"
#include "mv/motion/ease.h"
#include "mv/motion/energy_momentum.h"
#include "mv/motion/gait.h"
#include "mv/motion/gauss.h"
#include "mv/motion/implicit_stage.h"
#include "mv/motion/inverse_kinematics.h"
#include "mv/motion/iteration_matrix.h"
#include "mv/motion/joint_tree.h"
#include "mv/motion/minimizing_frame.h"
#include "mv/motion/nodes.h"
#include "mv/motion/ode.h"
#include "mv/motion/ode_adaptive.h"
#include "mv/motion/ode_fixed.h"
#include "mv/motion/ode_method.h"
#include "mv/motion/ode_problems.h"
#include "mv/motion/ode_stability.h"
#include "mv/motion/orientation.h"
#include "mv/motion/path_frame.h"
#include "mv/motion/springs.h"
#include "mv/motion/two_link.h"

#ifndef MVGL_SOURCE_DIR
#error "define MVGL_SOURCE_DIR as the root of the source tree"
#endif

namespace {

// True only where some header has declared glm::lookAt or glm::rotate: there is no other here.
template <typename V>
concept FindsLookAt = requires(V v) {
    lookAt(v, v, v);
};
template <typename M, typename V>
concept FindsRotate = requires(M m, typename M::value_type angle, V v) {
    rotate(m, angle, v);
};

TEST(Headers, DeclareNoGlmTransform) {
    EXPECT_FALSE(FindsLookAt<glm::vec3> || FindsLookAt<glm::dvec3>);
    EXPECT_FALSE((FindsRotate<glm::mat4, glm::vec3> || FindsRotate<glm::dmat4, glm::dvec3>));
}

bool showsGlmTransform(const std::string& line) {
    static const std::regex forbidden(
        R"(^\s*#\s*include\s*[<"]glm/(gtc|gtx|ext(\.hpp|/matrix_(transform|clip_space|projection))))");
    return std::regex_search(line, forbidden);
}

TEST(Headers, IncludeNoGlmTransform) {
    int headers = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(MVGL_SOURCE_DIR "/common/mv")) {
        if (entry.path().extension() != ".h") continue;
        ++headers;
        std::ifstream file(entry.path());
        ASSERT_TRUE(file) << entry.path();
        std::string line;
        for (int number = 1; std::getline(file, line); ++number) {
            EXPECT_FALSE(showsGlmTransform(line)) << entry.path() << ":" << number << ": " << line;
        }
    }
    EXPECT_GE(headers, 9);  // those included above: an empty or wrong folder is no success
}

TEST(Headers, TheSearchFindsWhatItLooksFor) {
    EXPECT_TRUE(showsGlmTransform("#include <glm/gtc/matrix_transform.hpp>"));
    EXPECT_TRUE(showsGlmTransform(" # include \"glm/gtx/transform.hpp\""));
    EXPECT_TRUE(showsGlmTransform("#include <glm/ext.hpp>"));
    EXPECT_TRUE(showsGlmTransform("#include <glm/ext/matrix_clip_space.hpp>"));
    EXPECT_FALSE(showsGlmTransform("#include <glm/vec3.hpp>"));
    EXPECT_FALSE(showsGlmTransform("// With <glm/gtc/matrix_transform.hpp> visible"));
}

}  // namespace
