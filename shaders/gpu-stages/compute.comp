// Compute shader: no primitive and no rasterizer. The shader is started so many times, 8 x 8 to a group, and stores
// where it likes.
#include "ripples.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba8) uniform writeonly image2D image;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(image);
    if (pixel.x < size.x && pixel.y < size.y) imageStore(image, pixel, vec4(ripples(pixel, size), 1.0));
}
