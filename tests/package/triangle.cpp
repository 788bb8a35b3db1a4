#include "mv/demo/demo.h"
#include "mv/gl/gl.h"

using namespace mv;

struct Triangle final : Demo {
    Real extent{this, "extent", 0.8, {0.1, 1}, "of the triangle, of the picture"};
    Program program;
    Mesh triangle;
    void init() override {
        program = Program("triangle");
        triangle = Mesh(MeshData{.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}});
    }
    void draw(const Frame&) override {
        glClear(GL_COLOR_BUFFER_BIT);
        program.use();
        program.set("extent", extent);
        triangle.draw();
    }
};
constexpr Declaration declaration{.name = "triangle", .sentence = "One triangle.", .width = 64, .height = 64};
const bool added = addDemo<Triangle, declaration>();
