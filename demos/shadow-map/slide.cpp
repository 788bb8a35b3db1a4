// The light as a slide projector: the matrix that looks points up in the map looks them up in a picture.
#include "mv/gl/functions.h"
#include "shadow-map.h"

namespace mv::shadow_map {

// Pass 2, with a picture in the light's window. A point that the map says is in shadow gets no light of the slide.
void drawSlide(Gpu& gpu, const Settings& s, const Scene& scene, const LightView& light) {
    const Texture& slide = gpu.slide.of({}, [] { return Texture(slidePicture(), GL_NEAREST, "slide"); });
    const Program& program = *gpu.slideProgram;
    program.use();
    slide.bind(0);
    program.set("slide", 0);
    program.set("alsoBehind", s.slide == Slide::alsoBehind);
    setLookup(gpu, s, program);
    drawObjects(gpu, program, scene, light);
}

// Stripes of the six colours that have red, green or blue whole or not at all. The left one is red and the top one white: they show
// which way round the picture is.
Picture slidePicture() {
    constexpr int side = 64;
    Picture picture(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            constexpr Pixel stripes[] = {{255, 0, 0},   {255, 255, 0}, {0, 255, 0},
                                         {0, 255, 255}, {0, 0, 255},   {255, 0, 255}};
            picture.set(x, y, y < side / 4 ? Pixel{255, 255, 255} : stripes[6 * x / side]);
        }
    }
    return picture;
}

}  // namespace mv::shadow_map
