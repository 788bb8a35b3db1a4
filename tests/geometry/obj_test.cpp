#include "mv/geometry/obj.h"

#include <string>

#include "math/support.h"
#include "mv/geometry/check.h"

using namespace mv;
using namespace mv::test;

namespace {

MeshData meshOf(const std::string& text) { return meshFromObj(text, "x.obj").mesh; }
std::string refused(const std::string& text) {
    return refusal([&] { (void)meshFromObj(text, "x.obj"); });
}

const std::string squareText = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}  // namespace

TEST(Obj, quads_become_triangles_with_their_faces_normal) {
    const MeshData mesh = meshOf(squareText + "f 1 2 3 4\n");
    EXPECT_EQ(mesh.positions, (std::vector<fvec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(mesh.normals, (std::vector<fvec3>(4, fvec3(0, 0, 1))));
    EXPECT_TRUE(mesh.texCoords.empty());
    validate(mesh);
}

TEST(Obj, a_vertex_for_each_that_some_corner_has_together) {
    const std::string text = squareText + "vt 0 0\nvt 1 0 0\nvn 0 0 2\nf 1/1/1 2/2/1 3/2/1\nf 3/2/1 1/1/1 2/1/1\n";
    const MeshData mesh = meshOf(text);
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 2, 0, 3}));
    EXPECT_EQ(mesh.positions.size(), 4U);
    EXPECT_EQ(mesh.positions[3], fvec3(1, 0, 0));  // the second one again, at another place of the picture
    EXPECT_EQ(mesh.texCoords[1], fvec2(1, 0));
    EXPECT_EQ(mesh.normals[0], fvec3(0, 0, 1));  // of unit length
    // v//vn, and v alone in a file with texture coordinates
    const MeshData mixed = meshOf(squareText + "vt 1 1\nvn 1 0 0\nf 1//1 2/1 3\n");
    EXPECT_EQ(mixed.normals, (std::vector<fvec3>{{1, 0, 0}, {0, 0, 1}, {0, 0, 1}}));
    EXPECT_EQ(mixed.texCoords, (std::vector<fvec2>{{0, 0}, {1, 1}, {0, 0}}));
}

TEST(Obj, negative_indices_count_from_where_they_stand) {
    const MeshData backwards = meshOf("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 0 5\nv 1 0 5\nv 1 1 5\nf -3 -2 -1\n");
    EXPECT_EQ(backwards, meshOf("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 5\nv 1 0 5\nv 1 1 5\nf 1 2 3\nf 4 5 6\n"));
    // A vertex that comes later in the file may be named by its number
    EXPECT_EQ(meshOf("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 1 1 0\n").indices.size(), 3U);
}

TEST(Obj, lines_as_files_have_them) {
    const MeshData plain = meshOf(squareText + "f 1 2 3 4\n");
    EXPECT_EQ(meshOf("v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3 4"), plain);            // CRLF, no end
    EXPECT_EQ(meshOf("v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r"), plain);                  // CR
    EXPECT_EQ(meshOf("\xEF\xBB\xBF# mark\n\n" + squareText + "f 1 2 \\\n 3 \\\r\n 4\n"), plain);  // continued
    EXPECT_EQ(meshOf("v\t0  0 0 # a comment \\\n v 1.0 0e5 -0\nv +1 1. 0 1\nv 0 1 0 0.5 0.5 0.5\n f  1 2\t3 4  \n"),
              plain);
    // Names in Windows-1252: fa\xE7" "ade, M\xFC" "ller
    const std::string names =
        "# M\xFCller\nmtllib fa\xE7\x80.mtl\no fa\xE7"
        "ade\ng a b\ns off\nusemtl \x93rot\x94\n";
    EXPECT_EQ(meshOf(names + squareText + "f 1 2 3 4\n"), plain);
    EXPECT_EQ(meshFromObj(squareText + "l 1 2 3\np 1 2\nf 1 2 3\n", "x.obj").leftOut, 3U);
    EXPECT_EQ(meshOf("v 1e-400 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").positions[0], fvec3(0));
    // More digits than a buffer has
    EXPECT_EQ(
        meshOf("v 0.33333333333333333333333333333333333333333333 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").positions[0].x,
        1 / 3.0F);
}

TEST(Obj, a_thousand_corners_and_none) {
    std::string text, face = "f";
    for (int i = 0; i < 1000; ++i) {
        text += "v " + numberText(std::cos(i * 2 * pi / 1000)) + " " + numberText(std::sin(i * 2 * pi / 1000)) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    const MeshData mesh = meshOf(text + face + "\n");
    EXPECT_EQ(mesh.indices.size(), 3U * 998);
    EXPECT_LT(glm::distance(vec3(mesh.normals[7]), vec3(0, 0, 1)), 1e-7);
    // Without area
    EXPECT_EQ(meshOf("v 1 1 1\nf 1 1 1\n").normals[0], fvec3(0, 1, 0));
}

TEST(Obj, the_rest_is_refused_with_its_line) {
    EXPECT_EQ(refused(""), "x.obj: the file must have faces");
    EXPECT_EQ(refused(squareText), "x.obj: the file must have faces");
    EXPECT_EQ(refused(squareText + "f 1 2\n"), "x.obj:5: a face must have 3 corners or more, 2");
    EXPECT_EQ(refused(squareText + "f 1 2 5\n"), "x.obj:5: an index must be one of the file's 4 positions (v), 5");
    EXPECT_EQ(refused(squareText + "f 1/1 2 3\n"),
              "x.obj:5: an index must be one of the file's 0 texture coordinates (vt), 1");
    EXPECT_EQ(refused(squareText + "f 1 2 3//9\n"), "x.obj:5: an index must be one of the file's 0 normals (vn), 9");
    const std::string before = "an index must be that of something before: from 1, or from -1 backwards, ";
    EXPECT_EQ(refused(squareText + "f 0 1 2\n"), "x.obj:5: " + before + "0");
    EXPECT_EQ(refused(squareText + "f 1 2 -5\n"), "x.obj:5: " + before + "-5");
    EXPECT_EQ(refused(squareText + "f -9223372036854775808 1 2\n"), "x.obj:5: " + before + "-9223372036854775808");
    EXPECT_EQ(refused(squareText + "f 99999999999999999999 1 2\n"),
              "x.obj:5: an index must be a whole number, 99999999999999999999");
    EXPECT_EQ(refused(squareText + "f 1 2 1.5\n"), "x.obj:5: an index must be a whole number, 1.5");
    const std::string corner = "x.obj:5: a corner must be v, v/vt, v//vn or v/vt/vn, ";
    EXPECT_EQ(refused(squareText + "f 1 2 1/1/1/1\n"), corner + "1/1/1/1");
    EXPECT_EQ(refused(squareText + "f 1 2 /3\n"), corner + "/3");
    const std::string number = "a number must be finite, with a point, and fit into floats, ";
    EXPECT_EQ(refused("v 0 0,5 0\n"), "x.obj:1: " + number + "0,5");
    EXPECT_EQ(refused("# one\nv 0 \\\n nan 0\n"), "x.obj:2: " + number + "nan");
    EXPECT_EQ(refused("v 0 1e400 0\n"), "x.obj:1: " + number + "1e400");
    EXPECT_EQ(refused("v 0 1e39 0\n"), "x.obj:1: " + number + "1e39");
    EXPECT_EQ(refused("v 0 0x1p3 0\n"), "x.obj:1: " + number + "0x1p3");
    EXPECT_EQ(refused("v 0 +-1 0\n"), "x.obj:1: " + number + "+-1");
    EXPECT_EQ(refused("v 0 1\n"), "x.obj:1: v and vn must have three numbers, 2 of them");
    EXPECT_EQ(refused("vt\n"), "x.obj:1: vt must have a number, 0 of them");
    EXPECT_EQ(refused("\ncstype bspline\n"),
              "x.obj:2: curves and surfaces are not read; export the mesh as polygons, cstype");
    EXPECT_EQ(refused("solid \x1B[31mred\n"),
              "x.obj:1: a line must begin with v, vt, vn, f or another statement of OBJ files, solid");
    EXPECT_EQ(refused("\x1B[31m\n").find('\x1B'), std::string::npos);
    EXPECT_EQ(refused(std::string("v 0 0\0 0", 8)).find('\0'), std::string::npos);
}

// Whatever the bytes: a mesh that holds together, or a sentence.
TEST(ObjExtremes, no_bytes_break_it) {
    const std::string start = squareText + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1 4/1/1\nf -1 -2 -3\n";
    Random random(1);
    int whole = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text = start;
        const int changes = static_cast<int>(random.number(1, 5));
        for (int k = 0; k < changes; ++k) {
            const auto at = static_cast<std::size_t>(random.number(0, double(text.size())));
            if (random.sign() < 0) {
                text[at] = static_cast<char>(static_cast<int>(random.number(0, 256)));
            } else if (random.sign() < 0) {
                text.erase(at, static_cast<std::size_t>(random.number(1, 4)));
            } else {
                text.insert(at, std::string(1, "/-\\\n f0e1#"[static_cast<std::size_t>(random.number(0, 10))]));
            }
        }
        try {
            const MeshData mesh = meshFromObj(text, "x.obj").mesh;
            validate(mesh);
            ++whole;
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).rfind("x.obj", 0), 0U) << error.what();
        }
    }
    EXPECT_GT(whole, 500);
}
