// The six faces of a cube, cut open and seen from inside: -x, -z, +x, +z in the middle row, +y above -z and -y below it.
uniform samplerCube cube;
in vec2 place;
out vec4 fragColor;

void main() {
    ivec2 cell = ivec2(place);
    vec2 at = 2.0 * fract(place) - 1.0;
    if (cell.y != 1 && cell.x != 1) discard;
    vec3 way = cell.y == 2 ? vec3(at.x, 1.0, at.y)
             : cell.y == 0 ? vec3(at.x, -1.0, -at.y)
             : cell.x == 0 ? vec3(-1.0, at.y, -at.x)
             : cell.x == 1 ? vec3(at.x, at.y, -1.0)
             : cell.x == 2 ? vec3(1.0, at.y, at.x)
                           : vec3(-at.x, at.y, 1.0);
    fragColor = vec4(texture(cube, way).rgb, 1.0);
}
