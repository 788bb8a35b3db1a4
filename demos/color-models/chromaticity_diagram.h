// The figure of the chromaticity diagrams: the places of colours, the outlines and the words.
#pragma once
#include <optional>

#include "mv/demo/frame.h"
#include "mv/geometry/plot.h"
#include "mv/gl/drawing.h"

namespace mv {

enum class Diagram { xy, uv };  // of 1931, and u', v' of 1976

struct ChromaticityDiagram {
    Diagram which;

    // The place in this diagram of the coordinates x and y of 1931.
    vec2 place(const vec2& xy) const;
    // place() as a matrix for homogeneous points (x, y, z, 1): the divisor of u' and v' is w.
    mat4 placeFromXy() const;
    // The place of an sRGB colour. Black has none.
    std::optional<vec2> placeOf(const vec3& srgb) const;

    // Percentages of the area between the spectrum and the line that closes it: the part that sRGB's triangle holds, and the
    // part beyond the line through two of its primaries, seen from the third.
    double heldBySrgb() const;
    double beyondSide(const vec2& from, const vec2& to) const;

    // The plot that fills the picture, with units of one length along both axes.
    Plot plotIn(const FrameInfo& frame) const;
    // plotIn() as a matrix, from values of the plot's axes to the picture's clip space.
    static mat4 clipFromPlace(const Plot& plot, const FrameInfo& frame);
    // The axes, spectrum and triangle, white, the wavelengths in nm, and the part that sRGB holds.
    void draw(Drawing& drawing, const FrameInfo& frame) const;
};

}  // namespace mv
