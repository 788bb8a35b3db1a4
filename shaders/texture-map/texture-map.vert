// Texture coordinates that the driver interpolates along the surface. Also a texel that is drawn as a point.
uniform mat4 clipFromModel;
in vec4 position;
in vec2 texCoord;
out vec2 uv;

void main() {
    uv = texCoord;
    gl_Position = clipFromModel * position;
    gl_PointSize = 1.0;
}
