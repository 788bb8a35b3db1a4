// The GL layer: programs and their errors, uniforms, reloading, triangle counts, words in the picture.
#include "mv/gl/gl.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "mv/geometry/shapes.h"
#include "mv/gl/audit.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/depth_map.h"
#include "mv/gl/editing.h"
#include "mv/gl/shader_source.h"
#include "mv/gl/state.h"
#include "mv/gl/texture.h"
#include "mv/image/file.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "support/demo_run.h"
#include "support/process.h"

using namespace mv;
using namespace mv::test;

namespace {

const std::string plainVertex = "uniform mat4 m;\nin vec4 position;\nvoid main() { gl_Position = m * position; }\n";
const std::string plainFragment = "uniform vec4 c;\nout vec4 fragColor;\nvoid main() { fragColor = c; }\n";

template <class Function>
std::string errorOf(Function function) {
    try {
        function();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class Gl : public testing::Test {
  protected:
    void SetUp() override { stage(); }
    void TearDown() override { EXPECT_EQ(takeErrors(), std::vector<std::string>()); }
};

}  // namespace

TEST_F(Gl, a_framebuffer_without_buffers_is_refused_by_its_name) {
    {
        const Framebuffer empty = makeFramebuffer();
        glBindFramebuffer(GL_FRAMEBUFFER, empty.id());
        const std::string error = errorOf([] { requireComplete("framebuffer 'empty'"); });
        EXPECT_TRUE(error.starts_with("framebuffer 'empty': must be complete")) << error;
    }
    const Target target(4, 4, {});
    EXPECT_NO_THROW(requireComplete("target"));
}

TEST_F(Gl, shader_mistakes_name_file_and_line) {
    const std::string error = errorOf([] {
        Program::fromText("wrong", plainVertex, "out vec4 fragColor;\nvoid main() {\n    fragColor = colour;\n}\n");
    });
    EXPECT_TRUE(has(error, "wrong.frag:3: ")) << error;
    EXPECT_TRUE(has(error, "colour")) << error;
    addShaderFile("include/shade.glsl", "vec4 shade() { return vec4(1); }\nvec4 broken() { return nothing; }\n", "");
    const std::string included = errorOf([] {
        Program::fromText("wrong", plainVertex,
                          "out vec4 fragColor;\n#include \"shade.glsl\"\nvoid main() { fragColor = shade(); }\n");
    });
    EXPECT_TRUE(has(included, "shaders/include/shade.glsl:2: ")) << included;
    addShaderFile("include/shade.glsl", "vec4 shade() { return vec4(1); }\n", "");
    const std::string after = errorOf([] {
        Program::fromText("wrong", plainVertex,
                          "#include \"shade.glsl\"\nout vec4 fragColor;\nvoid main() { fragColor = shad(); }\n");
    });
    EXPECT_TRUE(has(after, "wrong.frag:3: ")) << "lines after an include keep their numbers: " << after;
    addShaderFile("include/self.glsl", "#include \"self.glsl\"\n", "");
    EXPECT_TRUE(
        has(errorOf([] { assembleShaderText("a.frag", "#include \"self.glsl\"\n"); }), "must not include itself"));
    EXPECT_TRUE(
        has(errorOf([] { assembleShaderText("a.frag", "\n#include \"none.glsl\"\n"); }), "a.frag:2: includes a file"));
    EXPECT_TRUE(has(errorOf([] { Program("no-such-demo"); }), "shaders/no-such-demo.vert"));
    const std::string link = errorOf([] {
        Program::fromText(
            "apart",
            "in vec4 position;\nout vec2 passed;\nvoid main() { passed = position.xy; gl_Position = position; }\n",
            "in vec3 passed;\nout vec4 fragColor;\nvoid main() { fragColor = vec4(passed, 1); }\n");
    });
    EXPECT_TRUE(has(link, "program apart: must link")) << link;
}

TEST_F(Gl, logs_of_other_drivers_are_read_too) {
    ShaderSource source;
    source.files = {"shaders/a.frag", "shaders/include/b.glsl"};
    source.lines = {{0, 0}, {0, 1}, {1, 1}, {1, 2}, {0, 2}};
    EXPECT_EQ(readableLog("0:5(3): error: x\n", source), "shaders/a.frag:2: error: x");
    EXPECT_EQ(readableLog("0(4) : error C1008: x", source), "shaders/include/b.glsl:2: error C1008: x");
    EXPECT_EQ(readableLog("ERROR: 0:2: 'y' : undeclared", source), "shaders/a.frag:1: 'y' : undeclared");
    EXPECT_EQ(readableLog("0:6(1): error: end", source), "shaders/a.frag:2: error: end");
    for (const char* other : {"something else", "0:1(1): error: of the version line", "1:2(1): error", "0:0(0): error"})
        EXPECT_EQ(readableLog(other, source), other);
}

// Each line of what is compiled is known by its file and line there, whatever is included and however deep.
TEST_F(Gl, every_line_of_a_shader_knows_its_file_and_line) {
    addShaderFile("include/deep.glsl", "// 1 deep\n// 2 deep\n", "");
    addShaderFile("include/middle.glsl", "// 1 middle\n#include \"deep.glsl\"\n// 3 middle", "");
    const ShaderSource source = assembleShaderText(
        "a.frag",
        "\xEF\xBB\xBF// 1 a\n#include \"middle.glsl\"\n#line 50\n// 4 a\n  #  include \"deep.glsl\" // too\n");
    std::istringstream lines(source.text);
    std::string line;
    std::size_t known = 0, i = 0;
    for (; std::getline(lines, line); ++i) {
        const ShaderSource::Place place = source.lines.at(i);
        if (!line.starts_with("// ")) continue;
        const std::string& file = source.files.at(place.file);
        const std::string stem = file.substr(file.rfind('/') + 1, file.rfind('.') - file.rfind('/') - 1);
        EXPECT_EQ(line, "// " + std::to_string(place.line) + " " + stem);
        ++known;
    }
    EXPECT_EQ(known, 8U);
    EXPECT_EQ(i, source.lines.size());
    EXPECT_FALSE(has(source.text, "#line"));
    EXPECT_FALSE(has(source.text, "#include"));
}

// Mesa drops the file of #line in what it says of more than one token: a call, a sum, an assignment.
TEST_F(Gl, mistakes_in_an_included_file_are_told_there) {
    for (const char* mistake :
         {"float broken(float x) { return maks(x, 0.0); }", "float broken(float x) { return x + vec3(x).xy; }",
          "float broken(float x) { float y = vec2(x); return y; }", "float broken(float x) { return y; }",
          "float broken(float x) { x = 1.0 }", "float broken(vec2 x) { return x.z; }", "#error here",
          "float broken(float x) { return float(x, x)[2]; }"}) {
        addShaderFile("include/wrong-inside.glsl", "// one\n// two\n" + std::string(mistake) + "\n// four\n", "");
        const std::string told = errorOf([] {
            Program::fromText("outside", plainVertex,
                              "// one\n#include \"wrong-inside.glsl\"\nout vec4 fragColor;\nvoid main() { fragColor = "
                              "vec4(1); }\n");
        });
        EXPECT_TRUE(has(told, "shaders/include/wrong-inside.glsl:3: ")) << mistake << "\n" << told;
        EXPECT_FALSE(has(told, "\noutside.frag:")) << mistake << "\n" << told;
    }
}

TEST_F(Gl, a_byte_order_mark_is_skipped) {
    addShaderFile("include/marked.glsl", "\xEF\xBB\xBFvec4 marked() { return vec4(1.0); }\n", "");
    EXPECT_EQ(errorOf([] {
                  Program::fromText(
                      "marked", std::string("\xEF\xBB\xBF") + plainVertex,
                      "\xEF\xBB\xBF#include \"marked.glsl\"\nout vec4 fragColor;\nvoid main() { fragColor = "
                      "marked(); }\n");
              }),
              "no error");
}

// Lines that the compiler skips are not followed; where it may skip a line, a file that is not there is its mistake to tell.
TEST_F(Gl, includes_that_are_no_code_are_not_followed) {
    addShaderFile("include/once-seen.glsl", "// seen\n", "");
    const std::string seen = "#include \"once-seen.glsl\"\n", none = "#include \"none.glsl\"\n";
    const auto countOf = [](const std::string& text) {
        int count = 0;
        for (std::size_t at = 0; (at = text.find("// seen", at)) != std::string::npos; ++at) ++count;
        return count;
    };
    // How often the file stands in what is compiled
    const std::vector<std::pair<std::string, int>> cases = {
        {"/*\n" + seen + none + "*/\n" + seen, 1},
        {"/* one */ " + seen, 1},
        {"/* // */ " + seen, 1},
        {"// /*\n" + seen + "// */\n", 1},
        {"// goes on \\\n" + none + seen, 1},
        {"#define A \\\n" + none + seen, 1},
        {"#if 0\n" + none + seen + "#endif\n" + seen, 1},
        {"#if 0 // off\n" + none + "#else\n" + seen + "#endif\n", 1},
        {"#if 1\n" + seen + "#elif A\n" + none + "#else\n" + none + "#endif\n", 1},
        {"#if 0\n#if 1\n" + none + "#else\n" + none + "#endif\n" + none + "#endif\n" + seen, 1},
        {"#  if 0\n" + none + "#  elif 1\n" + seen + "#  else\n" + none + "#  endif\n", 1},
        {"#ifdef A\n" + seen + "#else\n" + seen + "#endif\n", 2},
        {"#if 0\n" + none + "#elif A\n" + seen + "#else\n" + seen + "#endif\n", 2},
        {"#endif\n#else\n" + seen, 1},
    };
    for (const auto& [text, count] : cases) EXPECT_EQ(countOf(assembleShaderText("a.frag", text).text), count) << text;
    for (const std::string& text : {none, "#if 1\n" + none + "#endif\n", "#if 0\n#endif\n" + none, "/* */" + none})
        EXPECT_TRUE(has(errorOf([&] { assembleShaderText("a.frag", text); }), "includes a file that is not in"))
            << text;

    const auto toldOf = [](const std::string& before) {
        return errorOf([&] {
            Program::fromText("may", plainVertex,
                              before + "out vec4 fragColor;\nvoid main() { fragColor = vec4(1); }\n");
        });
    };
    EXPECT_EQ(toldOf("#ifdef NOT_DEFINED\n" + none + "#endif\n"), "no error");
    const std::string told = toldOf("#ifndef NOT_DEFINED\n" + none + "#endif\n");
    EXPECT_TRUE(has(told, "may.frag:2: ") && has(told, "includes a file that is not in shaders/include, or came there"))
        << told;
    // A file with a guard may include itself.
    addShaderFile("include/guarded.glsl", "#ifndef GUARD\n#define GUARD\n#include \"guarded.glsl\"\n#endif\n", "");
    EXPECT_EQ(toldOf("#include \"guarded.glsl\"\n#include \"guarded.glsl\"\n"), "no error");
}

// As GLSL has them, whoever wrote the file, and in the files that are included, too.
TEST_F(Gl, lines_end_as_the_file_ends_them) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        const auto ended = [&](std::string text) {
            for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size())
                text.replace(at, 1, end);
            return text;
        };
        addShaderFile("include/ended.glsl", ended("// a comment\nvec4 ended() { return vec4(1); }\n"), "");
        const std::string before = ended(
            "// a comment\n#define LONG 1.0 + \\\n 1.0\n#if 0\n#include \"none.glsl\"\n#else\n#include \"ended.glsl\"\n"
            "#endif\nout vec4 fragColor;\n");
        const auto told = [&](const std::string& color) {
            return errorOf([&] {
                Program::fromText("ended", plainVertex,
                                  before + ended("void main() {\n    fragColor = " + color + ";\n}\n"));
            });
        };
        EXPECT_EQ(told("ended() * (LONG)"), "no error") << printable(end);
        const std::string wrong = told("endet()");
        EXPECT_TRUE(has(wrong, "ended.frag:11: ")) << printable(end) << wrong;
    }
}

TEST_F(Gl, what_a_shader_includes_has_a_limit) {
    addShaderFile("include/large.glsl", std::string(std::size_t{900} << 10U, ' '), "");
    addShaderFile("include/larger.glsl", "#include \"large.glsl\"\n#include \"large.glsl\"\n#include \"large.glsl\"\n",
                  "");
    EXPECT_EQ(errorOf([] { assembleShaderText("a.frag", "#include \"larger.glsl\"\n#include \"larger.glsl\"\n"); }),
              "a.frag: must have less than 4 MiB with all that it includes");
}

TEST_F(Gl, uniforms_are_known_typed_finite_and_in_use) {
    const Program program = Program::fromText("plain", plainVertex, plainFragment);
    EXPECT_TRUE(has(errorOf([&] { program.set("c", vec4(1)); }), "call use() first"));
    program.use();
    EXPECT_EQ(errorOf([&] { program.set("c", vec4(1)); }), "no error");
    EXPECT_TRUE(has(errorOf([&] { program.set("color", vec4(1)); }), "it has c, m"));
    EXPECT_TRUE(has(errorOf([&] { program.set("c", vec3(1)); }), "with the type the shader declares"));
    EXPECT_TRUE(has(errorOf([&] { program.set("c", vec4(0.0 / 0.0)); }), "must be finite as a float, nan"));
    EXPECT_TRUE(has(errorOf([&] { program.set("c", vec4(1e39)); }), "must be finite as a float, 1e+39"));
    EXPECT_TRUE(has(errorOf([&] { program.set("m", mat4(1.0 / 0.0)); }), "must be finite"));
    EXPECT_TRUE(has(errorOf([] { Program().use(); }), "must be made from shaders"));
    EXPECT_TRUE(has(errorOf([] { Mesh().draw(); }), "must be made from a shape"));
}

TEST_F(Gl, an_edited_shader_is_compiled_anew_and_a_mistake_keeps_the_last_good) {
    TemporaryFolder folder;
    const auto write = [&](const std::string& name, const std::string& text) {
        std::ofstream(folder.file(name)) << text;
        // A file system may count whole seconds: the time of the last edit is moved on by hand.
        static int edits = 0;
        std::filesystem::last_write_time(folder.file(name),
                                         std::filesystem::file_time_type::clock::now() + std::chrono::seconds(++edits));
    };
    write("edit.vert", plainVertex);
    write("edit.frag", plainFragment);
    addShaderFile("edit.vert", "", folder.file("edit.vert"));
    addShaderFile("edit.frag", "", folder.file("edit.frag"));
    const Program program("edit");
    const GLuint first = program.id();
    EXPECT_EQ(reloadChangedPrograms().programs, 0);
    write("edit.frag", "out vec4 fragColor;\nvoid main() { fragColor = vec4(red); }\n");
    const Reloaded failed = reloadChangedPrograms();
    ASSERT_EQ(failed.errors.size(), 1U);
    EXPECT_TRUE(has(failed.errors.front(), "shaders/edit.frag:2: ")) << failed.errors.front();
    EXPECT_EQ(program.id(), first) << "the last good version stays";
    EXPECT_TRUE(reloadChangedPrograms().errors.empty()) << "said once for each edit";
    write("edit.frag", "out vec4 fragColor;\nvoid main() { fragColor = vec4(1, 0, 0, 1); }\n");
    EXPECT_EQ(reloadChangedPrograms().programs, 1);
    EXPECT_NE(program.id(), first);
}

// While it is away, what was built in stands for it, whether it was there at first or not.
TEST_F(Gl, a_shader_that_was_moved_away_is_followed_when_it_is_back) {
    const TemporaryFolder folder;
    const std::string red = "out vec4 fragColor;\nvoid main() { fragColor = vec4(1, 0, 0, 1); }\n";
    addShaderFile("back.vert", plainVertex, folder.file("back.vert"));
    addShaderFile("back.frag", plainFragment, folder.file("back.frag"));
    const auto uniformError = [](const Program& program) {
        program.use();
        return errorOf([&] { program.set("c", vec4(1)); });
    };
    writeFileAtomically(folder / "back.vert", plainVertex);
    writeFileAtomically(folder / "back.frag", red);
    const Program program("back");
    using Unused = std::vector<std::string>;
    EXPECT_EQ(uniformError(program), "no error") << "who edits may leave it out";
    EXPECT_EQ(takeUnusedUniforms(), Unused{"c of back"}) << "the file's program has no uniform c";

    std::filesystem::rename(folder / "back.frag", folder / "elsewhere");
    EXPECT_EQ(reloadChangedPrograms().programs, 0)
        << "an editor may be replacing it: nothing is made of what is not there";
    std::filesystem::last_write_time(folder / "back.vert",
                                     std::filesystem::file_time_type::clock::now() + std::chrono::seconds(5));
    EXPECT_EQ(reloadChangedPrograms().programs, 1) << "the other file was edited";
    EXPECT_EQ(uniformError(program), "no error");
    EXPECT_EQ(takeUnusedUniforms(), Unused{}) << "with what was built in";
    std::filesystem::rename(folder / "elsewhere", folder / "back.frag");  // as old as it was
    EXPECT_EQ(reloadChangedPrograms().programs, 1);
    EXPECT_EQ(uniformError(program), "no error");
    EXPECT_EQ(takeUnusedUniforms(), Unused{"c of back"});
    EXPECT_EQ(reloadChangedPrograms().programs, 0);

    std::filesystem::remove(folder / "back.frag");
    const Program later("back");
    EXPECT_EQ(uniformError(later), "no error");
    EXPECT_EQ(takeUnusedUniforms(), Unused{});
    writeFileAtomically(folder / "back.frag", red);
    EXPECT_EQ(reloadChangedPrograms().programs, 2) << "both programs of these files";
    EXPECT_EQ(uniformError(later), "no error");
    EXPECT_EQ(takeUnusedUniforms(), Unused{"c of back"});
}

// An edit that brings a new #include with a mistake in that file: mending the file is enough.
TEST_F(Gl, a_file_that_was_included_in_vain_is_followed) {
    const TemporaryFolder folder;
    addShaderFile("include/new.glsl", "", folder.file("new.glsl"));
    addShaderFile("includes.vert", plainVertex, "");
    addShaderFile("includes.frag", plainFragment, folder.file("includes.frag"));
    const Program program("includes");
    writeFileAtomically(folder / "new.glsl", std::string_view("vec4 shade() { return nothing; }\n"));
    writeFileAtomically(
        folder / "includes.frag",
        std::string_view("#include \"new.glsl\"\nout vec4 fragColor;\nvoid main() { fragColor = shade(); }\n"));
    const Reloaded failed = reloadChangedPrograms();
    ASSERT_EQ(failed.errors.size(), 1U);
    EXPECT_TRUE(has(failed.errors.front(), "shaders/include/new.glsl:1: ")) << failed.errors.front();
    writeFileAtomically(folder / "new.glsl", std::string_view("vec4 shade() { return vec4(1); }\n"));
    std::filesystem::last_write_time(folder / "new.glsl",
                                     std::filesystem::file_time_type::clock::now() + std::chrono::seconds(5));
    const Reloaded mended = reloadChangedPrograms();
    EXPECT_EQ(mended.programs, 1);
    EXPECT_TRUE(mended.standing.empty());
}

// A few small files can ask for more than there is memory.
TEST_F(Gl, includes_of_includes_have_a_sum) {
    const TemporaryFolder folder;
    addShaderFile("include/much.glsl", "", folder.file("much.glsl"));
    addShaderFile("include/more.glsl", "", folder.file("more.glsl"));
    addShaderFile("sums.vert", plainVertex, "");
    addShaderFile("sums.frag", plainFragment, folder.file("sums.frag"));
    writeFileAtomically(folder / "much.glsl", std::string(1'000'000, ' '));
    const auto including = [](const std::string& file, int times) {
        std::string text;
        for (int i = 0; i < times; ++i) text += "#include \"" + file + "\"\n";
        return text;
    };
    writeFileAtomically(folder / "more.glsl", including("much.glsl", 30));
    writeFileAtomically(folder / "sums.frag", including("much.glsl", 4) + plainFragment);
    EXPECT_EQ(errorOf([] { Program("sums"); }), "no error");
    writeFileAtomically(folder / "sums.frag", including("more.glsl", 30) + plainFragment);
    EXPECT_EQ(errorOf([] { Program("sums"); }),
              "shaders/sums.frag: must have less than 4 MiB with all that it includes");
}

// Whatever is in a shader's file, or in its place: an Error that names it, and never another program than the file's.
TEST_F(Gl, hostile_shader_files_are_named) {
    const TemporaryFolder folder;
    addShaderFile("hostile.vert", plainVertex, "");
    addShaderFile("hostile.frag", plainFragment, folder.file("hostile.frag"));
    const auto errorWith = [&](const std::string& text) {
        writeFileAtomically(folder / "hostile.frag", text);
        return errorOf([] { Program("hostile"); });
    };
    EXPECT_EQ(errorWith(plainFragment), "no error");
    for (const std::string& text :
         {std::string("nonsense"), std::string("void main() {"), std::string("\xFF\xFE\x01\0\x7F", 5),
          std::string("#version 330\nvoid main() {}\n"), std::string(plainFragment).substr(0, 30),
          std::string(plainFragment) + std::string(plainFragment), std::string("#error \"") + std::string(70000, '%'),
          std::string("#include \"../../../etc/passwd\"\n")}) {
        EXPECT_TRUE(has(errorWith(text), "shaders/hostile.frag")) << text.substr(0, 60);
    }
    EXPECT_EQ(errorWith(""), "shaders/hostile.frag: must define main()");
    EXPECT_TRUE(has(errorWith(std::string(2'000'000, ' ')), "hostile.frag: must hold at most 1048576 bytes"));
    // Without the file the program is the one that was built in; with something in its place that is no file, none.
    std::filesystem::remove(folder / "hostile.frag");
    EXPECT_EQ(errorOf([] { Program("hostile"); }), "no error");
    std::filesystem::create_directory(folder / "hostile.frag");
    EXPECT_TRUE(has(errorOf([] { Program("hostile"); }), "hostile.frag: must be a file that exists and may be read"));
}

TEST_F(Gl, vertices_are_read_back_in_their_order) {
    const Program program = Program::fromText("plain", plainVertex, plainFragment);
    program.use();
    program.set("c", vec4(1));
    program.set("m", translate(1, 2, 3) * scale(2));  // exact in binary
    MeshData corners;
    corners.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5F, 0.25F, -4}};
    const auto went = [&](std::size_t i) { return fvec4(fvec3(1, 2, 3) + 2.0F * corners.positions[i], 1); };
    const std::vector<fvec4> inOrder{went(0), went(1), went(2), went(3)};
    const Counters before = counters();
    corners.primitive = Primitive::points;
    EXPECT_EQ(transformedPositions(Mesh(corners, "points")), inOrder);
    corners.primitive = Primitive::lines;
    EXPECT_EQ(transformedPositions(Mesh(corners, "lines")), inOrder);
    corners.primitive = Primitive::triangleStrip;
    EXPECT_EQ(transformedPositions(Mesh(corners, "strip")).size(), 6U);
    corners.primitive = Primitive::triangles;
    corners.indices = {3, 0, 1};
    EXPECT_EQ(transformedPositions(Mesh(corners, "indexed")), (std::vector<fvec4>{went(3), went(0), went(1)}));
    EXPECT_EQ(counters().draws, before.draws);
}

TEST_F(Gl, triangles_are_counted_where_they_went) {
    const Program program = Program::fromText("plain", plainVertex, plainFragment);
    const Mesh ball(sphere(1, 24, 12), "ball");
    const Mesh strip(ringStrip(0.5, 1, 10), "ring");
    program.use();
    program.set("c", vec4(1));
    program.set("m", mat4(1));
    glFrontFace(GL_CCW);
    glDisable(GL_CULL_FACE);
    const TriangleCount all = countTriangles(ball);
    EXPECT_EQ(all.submitted, ball.count() / 3);
    EXPECT_EQ(all.surviving, all.submitted) << "nothing is culled and nothing is outside";
    EXPECT_EQ(countTriangles(strip).submitted, 20) << "a strip of 22 vertices";
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    const TriangleCount back = countTriangles(ball);
    glCullFace(GL_FRONT);
    const TriangleCount front = countTriangles(ball);
    EXPECT_EQ(back.culled + front.culled, all.submitted) << "each triangle faces one way or the other";
    EXPECT_EQ(back.culled, front.culled) << "a sphere symmetric in z";
    program.set("m", translate(5, 0, 0));
    EXPECT_EQ(countTriangles(ball).outside, all.submitted);
    // Half behind the eye: w changes sign within triangles, and every one is still counted once.
    program.set("m", perspective(60, 1, 0.1, 10));
    const TriangleCount through = countTriangles(ball);
    EXPECT_EQ(through.culled + through.outside + through.surviving, all.submitted);
    glDisable(GL_CULL_FACE);
}

TEST_F(Gl, words_stand_in_the_picture) {
    const Target target(200, 40, {}, "words");
    const FrameInfo frame(1, 200, 40);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    const Picture empty = target.read();
    drawText(frame, 3, 2, "Horfðu á 45°");
    const Picture words = target.read();
    EXPECT_GT(differentPixels(empty, words), 200);
    EXPECT_LT(differentPixels(empty, words), 3000);
    // The words end where textWidth says: nothing is drawn to the right of it.
    const int end = 3 + textWidth("Horfðu á 45°");
    for (int y = 0; y < 40; ++y) {
        for (int x = end; x < 200; ++x) ASSERT_EQ(words.at(x, y), empty.at(x, y)) << x << ", " << y;
    }
    for (int i = 0; i < 200 * 40; ++i) ASSERT_EQ(words.at(i % 200, i / 200).alpha, 255) << "opaque, as it was";
    drawText(frame, 3, 2, "\xff\xc3");  // no UTF-8: shown as such, never read beyond its end
    EXPECT_THROW(drawText(frame, 0, 0, "x", {.height = 2}), Error);
    forgetText();
}

TEST_F(Gl, lines_of_words_together_are_the_lines_one_by_one) {
    const Target target(120, 60, {}, "words");
    const FrameInfo frame(1, 120, 60);
    const std::array lines{TextLine{3, 2, "above"},
                           TextLine{8, 30, "below", {.height = 20, .color = vec4(1, 0, 0, 1)}}};
    glClearColor(0, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (const TextLine& line : lines) drawText(frame, line.x, line.y, line.text, line.style);
    const Picture one = target.read();
    glClear(GL_COLOR_BUFFER_BIT);
    const long before = counters().draws;
    drawText(frame, lines);
    EXPECT_EQ(counters().draws, before + 1);
    EXPECT_EQ(target.read(), one);
    EXPECT_GT(countColors(one), 5);
    EXPECT_EQ(one.at(4, 3), (Pixel{204, 255, 255, 255})) << "the box: 0.8 white over the blue";
    EXPECT_GT(countPixels(one, {255, 0, 0, 255}), 10) << "the middle of a stroke has the words' own colour";
    // One that cannot be: none is drawn
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_THROW(drawText(frame, std::array{lines[0], TextLine{0, 0, "x", {.height = 2}}}), Error);
    EXPECT_EQ(countColors(target.read()), 1);
    forgetText();
}

// The same lines again cost no upload, the same words elsewhere one of their places; what is kept is bounded.
TEST_F(Gl, words_that_stay_are_kept) {
    const Target target(120, 60, {}, "words");
    const FrameInfo frame(1, 120, 60);
    const auto bytesFor = [&](int x, const std::string& text) {
        startAudit();
        beginAuditedFrame(false);
        drawText(frame, x, 2, text);
        const long bytes = endAuditedFrame().bytesUploaded;
        stopAudit();
        return bytes;
    };
    glClear(GL_COLOR_BUFFER_BIT);
    const long objects = liveObjects();
    constexpr long uniform = 4,
                   places = 12 * (12 + 16 + 8);  // of twelve corners: position, colour, place in the texture
    EXPECT_GT(bytesFor(3, "stays"), places + 400) << "with the texture";
    const Picture once = target.read();
    const long kept = liveObjects();
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(bytesFor(3, "stays"), uniform);
    EXPECT_EQ(target.read(), once);
    EXPECT_EQ(liveObjects(), kept);
    EXPECT_EQ(bytesFor(4, "stays"), places + uniform);
    for (int i = 0; i < 100; ++i) drawText(frame, 3, 2, "line " + std::to_string(i));
    EXPECT_EQ(liveObjects() - kept, 15 * 3) << "sixteen calls in all: a vertex array, its buffer and a texture each";
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_GT(bytesFor(3, "stays"), places) << "long forgotten";
    EXPECT_EQ(target.read(), once);
    forgetText();
    EXPECT_EQ(liveObjects(), objects);
}

// More words than stand beside each other in their texture, and one line that is wider than all of it.
TEST_F(Gl, many_and_long_lines_are_those_lines) {
    const Target target(900, 400, {}, "words");
    const FrameInfo frame(1, 900, 400);
    std::vector<TextLine> lines{{5, 5, std::string(100, 'W'), {.height = 12}}};
    for (int i = 0; i < 60; ++i)
        lines.push_back({10 + i % 4 * 200, 30 + i / 4 * 24, "line " + std::to_string(i), {.height = 9 + i % 7}});
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (const TextLine& line : lines) drawText(frame, line.x, line.y, line.text, line.style);
    const Picture one = target.read();
    glClear(GL_COLOR_BUFFER_BIT);
    drawText(frame, lines);
    EXPECT_EQ(target.read(), one);
    forgetText();
}

TEST_F(Gl, an_image_is_shown_pixel_by_pixel) {
    Picture image(3, 2);
    image.set(0, 0, {255, 0, 0, 255});
    image.set(2, 0, {0, 255, 0, 255});
    image.set(0, 1, {0, 0, 255, 255});
    image.set(2, 1, {255, 255, 255, 255});
    const Target target(8, 5, {}, "image");
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    showImage(FrameInfo(1, 8, 5), 4, 1, image);
    const Picture shown = target.read();
    EXPECT_EQ(shown.at(4, 1), (Pixel{255, 0, 0, 255})) << "the upper left pixel stays the upper left one";
    EXPECT_EQ(shown.at(6, 1), (Pixel{0, 255, 0, 255}));
    EXPECT_EQ(shown.at(4, 2), (Pixel{0, 0, 255, 255}));
    EXPECT_EQ(shown.at(6, 2), (Pixel{255, 255, 255, 255}));
    EXPECT_EQ(shown.at(3, 1), (Pixel{0, 0, 0, 255}));
    forgetText();
}

TEST_F(Gl, a_target_of_floats_is_added_to_and_read_by_a_later_draw) {
    const Target sum(3, 2, {.color = GL_R32F, .texture = true}, "sum");
    glClearColor(0.5F, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    const Program add = Program::fromText("add", plainVertex, plainFragment);
    add.use();
    add.set("m", mat4(1));
    add.set("c", vec4(1.0 / 1024));
    MeshData wholePicture;
    wholePicture.positions = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
    const Mesh cover(wholePicture, "cover");
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (int i = 0; i < 3; ++i) cover.draw();
    glDisable(GL_BLEND);
    EXPECT_EQ(sum.readRed(), std::vector<float>(6, 0.5F + 3.0F / 1024));  // exact in float; in 8 bits nothing is added

    const Target picture(3, 2, {}, "picture");
    const Program show = Program::fromText(
        "show", plainVertex,
        "uniform sampler2D sum;\nout vec4 fragColor;\n"
        "void main() { fragColor = vec4(texelFetch(sum, ivec2(gl_FragCoord.xy), 0).r, 0.0, 0.0, 1.0); }\n");
    sum.bindColor(0);
    show.use();
    show.set("m", mat4(1));
    show.set("sum", 0);
    cover.draw();
    const Picture read = picture.read();
    EXPECT_EQ(countPixels(read, {128, 0, 0}), 6);  // 0.503 * 255 = 128.2

    EXPECT_EQ(errorOf([&] { picture.bindColor(0); }),
              "target: must be made with Buffers::texture to be read by a draw");
    EXPECT_EQ(errorOf([] { Target(3, 2, {.samples = 4, .texture = true}, "both"); }),
              "both: must be a texture or have samples, not both, 4");
}

TEST_F(Gl, a_depth_buffer_has_the_format_asked_for_and_is_read_by_a_later_draw) {
    const Program show = Program::fromText(
        "show", plainVertex,
        "uniform sampler2D depths;\nout vec4 fragColor;\n"
        "void main() { fragColor = vec4(texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r, 0.0, 0.0, 1.0); }\n");
    MeshData wholePicture;
    wholePicture.positions = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
    const Mesh cover(wholePicture, "cover");
    const float cleared = 2.0F / 11;  // in steps of 16 and 24 bits 11915.45 and 3050402.7
    for (const auto& [format, steps] :
         {std::pair{GL_DEPTH_COMPONENT16, 65535.0}, {GL_DEPTH_COMPONENT24, 16777215.0}, {GL_DEPTH_COMPONENT32F, 0.0}}) {
        const Target scene(3, 2, {.depth = true, .depthFormat = GLenum(format), .depthTexture = true}, "scene");
        glClearBufferfv(GL_DEPTH, 0, &cleared);
        const Target depths(3, 2, {.color = GL_R32F}, "depths");
        scene.bindDepth(0);
        glDisable(GL_DEPTH_TEST);
        show.use();
        show.set("m", mat4(1));
        show.set("depths", 0);
        cover.draw();
        // Rounded to the nearest step, which is then a float again; a driver may be a step off (GL's rule).
        const float read = depths.readRed()[0];
        if (steps > 0) {
            EXPECT_NEAR(read * steps, std::round(cleared * steps), steps * 6e-8 + 1);
            EXPECT_EQ(std::abs(read - cleared) > 1e-6, steps < 1e6);
        } else {
            EXPECT_EQ(read, cleared);
        }
    }
    const Target plain(3, 2, {.depth = true}, "plain");
    EXPECT_EQ(errorOf([&] { plain.bindDepth(0); }),
              "target: must be made with Buffers::depthTexture to be read by a draw");
    EXPECT_EQ(errorOf([] { Target(3, 2, {.depthTexture = true}, "no depth"); }),
              "no depth: must have a depth buffer without samples to have it as a texture");
    EXPECT_EQ(errorOf([] { Target(3, 2, {.stencil = true, .depthFormat = GL_DEPTH_COMPONENT16}, "both"); }),
              "both: must have 24 bits of depth, not in a texture, where it has a stencil buffer");
}

TEST_F(Gl, a_target_is_made_anew_only_where_it_would_be_another) {
    const Target::Buffers buffers{.color = GL_R32F};
    Target target;
    EXPECT_TRUE(target.fit(3, 2, buffers));
    glClearColor(0.25F, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_FALSE(target.fit(3, 2, buffers));
    EXPECT_EQ(target.readRed(), std::vector<float>(6, 0.25F));  // what was drawn is still there
    EXPECT_TRUE(target.fit(4, 2, buffers));
    EXPECT_EQ(target.width(), 4);
    const long objects = liveObjects();
    EXPECT_TRUE(target.fit(4, 2, {.depth = true, .color = GL_R32F}));
    EXPECT_EQ(liveObjects(), objects + 1);  // the depth buffer; of the old one nothing is left
}

TEST_F(Gl, a_target_and_a_map_begin_by_being_bound) {
    Target target;
    DepthMap map;
    GLint bound = 0;
    const auto boundAfter = [&](const auto& begin) {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        begin();
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
        return bound;
    };
    std::array<GLint, 4> viewport{};
    const GLint made = boundAfter([&] { target.begin(3, 2, {.color = GL_R32F}); });
    EXPECT_NE(made, 0);
    EXPECT_EQ(boundAfter([&] { target.begin(3, 2, {.color = GL_R32F}); }), made) << "the same one again";
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    EXPECT_EQ(viewport, (std::array<GLint, 4>{0, 0, 3, 2}));
    const GLint mapMade = boundAfter([&] { map.begin(8); });
    EXPECT_NE(mapMade, 0);
    const long objects = liveObjects();
    EXPECT_EQ(boundAfter([&] { map.begin(8); }), mapMade) << "the same one again";
    EXPECT_NE(boundAfter([&] { map.begin(16); }), 0);
    EXPECT_EQ(map.size(), 16);
    EXPECT_EQ(liveObjects(), objects) << "nothing is left of the small one";
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

// Beyond the map's end is the map's end, where nothing is: lit. A float depth is compared as it is where nobody says so.
TEST_F(Gl, what_is_beyond_a_shadow_maps_end_is_lit) {
    const Target map(2, 2, {.depth = true, .depthFormat = GL_DEPTH_COMPONENT32F, .depthTexture = true}, "map");
    const float farthest = 1;
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    const Target lit(1, 1, {.color = GL_R32F}, "lit");
    MeshData wholePicture;
    wholePicture.positions = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
    const Mesh cover(wholePicture, "cover");
    for (const std::string look : {"litOneTap(map, at, 0.1)", "litPcf(map, at, 0.1, 3)"}) {
        const Program program = Program::fromText("beyond", plainVertex,
                                                  "#include \"shadow-map.glsl\"\nuniform sampler2DShadow map;\n"
                                                  "uniform vec4 at;\nout vec4 fragColor;\n"
                                                  "void main() { fragColor = vec4(" +
                                                      look + "); }\n");
        program.use();
        program.set("m", mat4(1));
        program.set("map", 0);
        map.bindDepth(0);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
        lit.bind();
        for (const double depth : {0.5, 1.0, 1.5}) {
            program.set("at", vec4(0.5, 0.5, depth, 1));
            cover.draw();
            EXPECT_EQ(lit.readRed(), std::vector<float>{1}) << look << " at depth " << depth;
        }
    }
}

// Each thing that ES 3.0 lacks is known by the call or the format that needs it; what is initially so is none.
TEST_F(Gl, what_es_lacks_is_noted) {
    const Program program = Program::fromText("plain", plainVertex, plainFragment);
    program.use();
    program.set("c", vec4(1));
    program.set("m", mat4(1));
    MeshData corners;
    corners.positions = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
    const Mesh plain(corners, "plain");
    corners.indices = {0, 1, 2};
    const Mesh indexed(corners, "indexed");
    const Target picture(2, 2, {.depth = true, .stencil = true}, "picture"), floats(2, 2, {.color = GL_R32F}, "floats");
    for (const Target* target : {&picture, &floats}) {
        target->bind();
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    allow(Newer::clipControl);
    const auto usedBy = [](const std::function<void()>& calls) {
        watchBeyondEs();
        calls();
        const std::set<std::string> used = stopWatchingBeyondEs();
        std::string text;
        for (const std::string& one : used) text += (text.empty() ? "" : ", ") + one;
        return text;
    };
    std::vector<float> numbers(16);
    std::vector<unsigned char> bytes(64);
    picture.bind();
    EXPECT_EQ(usedBy([&] {
                  restoreInitialState();
                  for (const GLenum what :
                       std::initializer_list<GLenum>{GL_DEPTH_TEST, GL_BLEND, GL_STENCIL_TEST, GL_PROGRAM_POINT_SIZE}) {
                      glEnable(what);
                      glDisable(what);
                  }
                  program.use();
                  plain.draw();
                  transformedPositions(plain);
                  picture.read();
              }),
              "");
    EXPECT_EQ(usedBy([] { glEnable(GL_CLIP_DISTANCE0 + 1); }), beyond_es::clipDistances);
    glDisable(GL_CLIP_DISTANCE0 + 1);
    EXPECT_EQ(usedBy([] { glEnable(GL_DEPTH_CLAMP); }), "GL_DEPTH_CLAMP");
    EXPECT_EQ(usedBy([] { glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); }), beyond_es::clipControl);
    EXPECT_EQ(usedBy([] { glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); }), beyond_es::polygonMode);
    restoreInitialState();
    program.use();
    EXPECT_EQ(usedBy([&] { glReadPixels(0, 0, 2, 2, GL_DEPTH_COMPONENT, GL_FLOAT, numbers.data()); }),
              beyond_es::depthReadBack);
    EXPECT_EQ(usedBy([&] { glReadPixels(0, 0, 2, 2, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes.data()); }),
              beyond_es::stencilReadBack);
    EXPECT_EQ(usedBy([&] { transformedPositions(indexed); }), beyond_es::indexedFeedback);
    corners.indices.clear();
    corners.primitive = Primitive::triangleFan;
    EXPECT_EQ(usedBy([&] { transformedPositions(Mesh(corners, "fan")); }), beyond_es::expandedFeedback);
    EXPECT_EQ(usedBy([] {
                  GLuint query = 0;
                  glGenQueries(1, &query);
                  glBeginQuery(GL_SAMPLES_PASSED, query);
                  glEndQuery(GL_SAMPLES_PASSED);
                  glDeleteQueries(1, &query);
              }),
              beyond_es::countingQueries);
    floats.bind();
    EXPECT_EQ(usedBy([&] { plain.draw(); }), beyond_es::floatTargets);
    glEnable(GL_BLEND);
    EXPECT_EQ(usedBy([&] { plain.draw(); }), beyond_es::floatBlending + std::string(", ") + beyond_es::floatTargets);
    glDisable(GL_BLEND);
    EXPECT_EQ(usedBy([] {
                  const TextureObject texture = makeTexture();
                  glBindTexture(GL_TEXTURE_2D, texture.id());
                  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
              }),
              beyond_es::borderClamp);
    const std::vector<FloatPicture> level{FloatPicture(2, 2, 4)};
    EXPECT_EQ(usedBy([&] { Texture(level, {.texels = Texels::floats}).filterBy({.minify = GL_LINEAR}); }),
              beyond_es::floatFiltering);
    EXPECT_EQ(usedBy([&] {
                  Texture(level, {.texels = Texels::halfFloats}).filterBy({.minify = GL_LINEAR});
                  Texture(level, {.texels = Texels::floats}).filterBy({.minify = GL_NEAREST, .magnify = GL_NEAREST});
              }),
              "");
    if (largestAnisotropy() > 1) {
        EXPECT_EQ(usedBy([&] { Texture(level, {}).filterBy({.anisotropy = 2}); }), beyond_es::anisotropicFiltering);
    }
    allowVersion(33);
}

TEST_F(Gl, textures_refuse_what_is_no_chain_of_levels) {
    const auto made = [](const std::vector<FloatPicture>& levels, const TextureOptions& options = {}) {
        return errorOf([&] { Texture texture(levels, options); });
    };
    EXPECT_EQ(made({FloatPicture(5, 2, 4), FloatPicture(2, 1, 4), FloatPicture(1, 1, 4)}), "no error");
    EXPECT_TRUE(has(made({}), "must have a level"));
    EXPECT_TRUE(has(made({FloatPicture(4, 4, 3)}), "must have 4 channels"));
    EXPECT_TRUE(has(made({FloatPicture(5, 2, 4), FloatPicture(3, 1, 4)}), "half the sides"));
    EXPECT_TRUE(has(made({FloatPicture(2, 2, 4), FloatPicture(1, 1, 4)}, {.driverMipmaps = true}), "single level"));
    const std::vector<FloatPicture> one{FloatPicture(13, 4, 4)};
    Texture byDriver(one, {.driverMipmaps = true});
    EXPECT_EQ(byDriver.levels(), 4);  // 13, 6, 3, 1
    const std::string tooMany = errorOf([&] { byDriver.filterBy({.anisotropy = largestAnisotropy() + 1}); });
    EXPECT_TRUE(has(tooMany, "must be 1 .. " + std::to_string(largestAnisotropy())));
    EXPECT_EQ(takeErrors(), std::vector<std::string>());
}

// A demo of 3.3 may ask for glClipControl; the next one starts without it.
TEST_F(Gl, clip_control_is_called_only_where_it_was_asked_for) {
    allowVersion(33);
    EXPECT_FALSE(isAllowed(Newer::clipControl));
    EXPECT_TRUE(has(errorOf([] { glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); }), "needs OpenGL 4.5"));
    EXPECT_TRUE(has(errorOf([] { mv::has(beyond_es::clipControl); }), "what is declared"));
    ASSERT_TRUE(allow(Newer::clipControl)) << "llvmpipe has it";
    EXPECT_TRUE(isAllowed(Newer::clipControl));
    takeMissing();
    EXPECT_TRUE(mv::has(beyond_es::clipControl));
    EXPECT_TRUE(mv::has(beyond_es::floatBlending));
    EXPECT_TRUE(takeMissing().empty());
    withhold({beyond_es::clipControl});
    EXPECT_FALSE(mv::has(beyond_es::clipControl));
    EXPECT_TRUE(mv::has(beyond_es::floatBlending));
    EXPECT_EQ(takeMissing(), std::set<std::string>{beyond_es::clipControl});
    EXPECT_TRUE(takeMissing().empty()) << "taken once";
    EXPECT_EQ(filteredFloats(), Texels::floats);
    withhold({beyond_es::floatFiltering});
    EXPECT_EQ(filteredFloats(), Texels::halfFloats);
    EXPECT_EQ(takeMissing(), std::set<std::string>{beyond_es::floatFiltering});
    withhold({});
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    restoreInitialState();
    GLint depth = 0;
    glGetIntegerv(GL_CLIP_DEPTH_MODE, &depth);
    EXPECT_EQ(depth, GL_NEGATIVE_ONE_TO_ONE);
    allowVersion(33);
    EXPECT_TRUE(has(errorOf([] { glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); }), "needs OpenGL 4.5"));
}

TEST_F(Gl, objects_are_moved_and_deleted) {
    const long before = liveObjects();
    {
        Mesh a(square(), "a");
        EXPECT_EQ(liveObjects(), before + 2);
        Mesh b = std::move(a);
        a = Mesh(square(), "again");
        b = std::move(a);
        EXPECT_THROW(Mesh(MeshData{}, "empty"), Error);
    }
    EXPECT_EQ(liveObjects(), before);
}

// Drivers give a name once, so the label of what is gone would never be asked for again, and stay for ever.
TEST_F(Gl, labels_end_with_their_objects) {
    const std::size_t before = labelledObjects();
    {
        const Target target(4, 4, {.depth = true, .texture = true}, "target");
        const Mesh mesh(square(), "mesh");
        const Texture texture(Picture(2, 2), GL_NEAREST, "texture");
        const DepthMap map(4, "map");
        const Program program = Program::fromText("plain", plainVertex, plainFragment);
        EXPECT_GE(labelledObjects(), before + 8);
        EXPECT_EQ(labelOf(GL_PROGRAM, program.id()), "'plain'");
    }
    EXPECT_EQ(labelledObjects(), before);
}
