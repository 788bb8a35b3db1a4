uniform samplerCube cube;
in vec3 way;
out vec4 fragColor;

void main() { fragColor = vec4(texture(cube, way).rgb, 1.0); }
