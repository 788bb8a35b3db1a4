#include "mv/demo/lesson.h"
#include "mv/gl/gl.h"

using namespace mv;

struct Settings {
    double extent = 0.8;
};
struct Gpu {
    Program program{"triangle"};
    Mesh triangle{MeshData{.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}}};
};
void draw(Gpu& gpu, const Settings& s, const Frame&) {
    glClear(GL_COLOR_BUFFER_BIT);
    gpu.program.use();
    gpu.program.set("extent", s.extent);
    gpu.triangle.draw();
}

constexpr Declaration about{.name = "triangle", .sentence = "One triangle.", .width = 64, .height = 64};
const bool added = addLesson(
    about,
    Lesson<Settings, Gpu>{.rows = {number("extent", &Settings::extent, {0.1, 1}, "of the triangle, of the picture")},
                          .draw = draw});
