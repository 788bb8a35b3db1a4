// The texture coordinates of a point of a triangle's plane, by a matrix: of the point itself, or of its way from a corner.
#include "texture-map.glsl"
uniform mat3 textureFromPoint;
uniform vec3 corner;
uniform vec2 atCorner;
in vec3 point;

void main() {
    showTexel((textureFromPoint * (point - corner)).xy + atCorner);
}
