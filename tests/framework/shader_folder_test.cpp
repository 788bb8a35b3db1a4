// Built programs read the shaders of the source tree, by a path that stands beside the library and not in it.
#include "mv/gl/shader_folder.h"

#include <gtest/gtest.h>

#include "mv/gl/shader_source.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;
namespace fs = std::filesystem;

TEST(ShaderFolder, is_the_source_trees_in_a_build_and_none_for_a_group_that_was_not_built) {
    const fs::path folder = shaderFolder("demo-cube-cull");
    EXPECT_TRUE(fs::equivalent(folder, MVGL_SOURCE_DIR "/shaders")) << folder;
    EXPECT_EQ(shaderFolder("demo-of-nobody"), fs::path());
    EXPECT_TRUE(fs::exists(libraryFolder() / "libmvgl.so")) << libraryFolder();
}

TEST(ShaderFolder, shaders_of_every_demo_are_read_from_it) {
    stage();  // a shader is put together for its context
    for (const std::string& name : demoNames()) {
        for (const std::string& file :
             {name + ".vert", name + ".frag", name + "/" + name + ".vert", name + "/" + name + ".frag"}) {
            if (!hasShaderFile(file)) continue;
            const ShaderSource source = assembleShader(file);
            EXPECT_EQ(source.readFrom.count(shaderFolder("demo-" + name) / file), 1U) << file;
        }
    }
}
