// Compute shader: rays of light fall straight onto the water, 4 x 4 for each pixel. Each computes where it lands on the ground,
// and adds 1 there. A fragment shader cannot: it writes its own pixel and no other.
#include "ripples.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r32ui) uniform uimage2D counts;

void main() {
    ivec2 ray = ivec2(gl_GlobalInvocationID.xy), size = imageSize(counts);
    if (any(greaterThanEqual(ray, 4 * size))) return;
    vec2 at = (vec2(ray) + 0.5) / float(4 * size.y);
    // Refraction turns a steep ray by a part of the slope that it meets, and the ground is far below
    ivec2 pixel = ivec2(floor((at - 0.0006 * slopeOf(at)) * float(size.y)));
    if (all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, size))) imageAtomicAdd(counts, pixel, 1u);
}
