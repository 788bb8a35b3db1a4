// stereocube: a wire cube seen by two eyes, one picture in red and one in cyan for coloured glasses.
#include "stereocube.h"

#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv::stereocube {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Eye left = leftEye(s, frame.aspect()), right = rightEye(s, frame.aspect());
    frame.show("leftFromWorld", left.eyeFromWorld);
    frame.show("clipFromLeft", left.clipFromEye);
    frame.show("rightFromWorld", right.eyeFromWorld);
    frame.show("clipFromRight", right.clipFromEye);
    frame.show("worldFromModel", worldFromModelOf(s));

    // Clear the picture before there is a mask: glClear, too, writes only what it lets through
    const auto paper = float(s.background == Paper::white);
    glClearColor(paper, paper, paper, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);

    // Draw. The red filter is before the left eye and shows it the red channel: so the left picture is the one that
    // changes red
    gpu.program.use();
    const auto drawPictures = s.colors == Colors::lines ? drawLines : drawMasked;
    drawPictures(gpu, s, left, right);
}

// Draw the lines in two colours. On black the red lines change red; on white the cyan ones do, which take red away.
void drawLines(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right) {
    const bool isWhite = s.background == Paper::white;
    drawCube(gpu, s, isWhite ? right : left, vec4(1, 0, 0, 1));
    drawCube(gpu, s, isWhite ? left : right, vec4(0, 1, 1, 1));
}

// Draw each picture into channels of its own, in black on white or white on black.
void drawMasked(Gpu& gpu, const Settings& s, const Eye& left, const Eye& right) {
    const vec4 ink(vec3(s.background == Paper::black), 1);
    glColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE);
    drawCube(gpu, s, left, ink);
    glClear(GL_DEPTH_BUFFER_BIT);  // the eyes do not hide things from each other
    glColorMask(GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE);
    drawCube(gpu, s, right, ink);
}

// A closed eye has no picture.
void drawCube(Gpu& gpu, const Settings& s, const Eye& eye, const vec4& color) {
    if (s.eyes != Eyes::both && s.eyes != eye.which) return;
    gpu.program.set("clipFromModel", eye.clipFromEye * eye.eyeFromWorld * worldFromModelOf(s));
    gpu.program.set("color", color);
    gpu.cube.draw();
}

// The eyes look along +z with y upwards, so their right is -x: the left eye is the one at positive x.
Eye leftEye(const Settings& s, double aspect) { return eyeAt(s.eyeSep / 2, Eyes::left, s, aspect); }
Eye rightEye(const Settings& s, double aspect) { return eyeAt(-s.eyeSep / 2, Eyes::right, s, aspect); }

Eye eyeAt(double x, Eyes which, const Settings& s, double aspect) {
    const vec3 place(x, 0, s.zDist), ahead(0, 0, s.zDist + s.convergence);
    if (s.stereo == Stereo::toeIn)
        return {which, lookAt(place, ahead, vec3(0, 1, 0)), perspective(fovy, aspect, near, far)};

    // Look straight ahead, and shift the window so that both eyes' windows are one at the convergence distance
    FrustumBounds window = frustumBounds(fovy, aspect, near, far);
    const double shift = x * near / s.convergence;
    window.left += shift;
    window.right += shift;
    return {which, lookAt(place, ahead + vec3(x, 0, 0), vec3(0, 1, 0)), frustum(window)};
}

mat4 worldFromModelOf(const Settings& s) { return rotateX(s.spinX) * rotateY(s.spinY); }

}  // namespace mv::stereocube
