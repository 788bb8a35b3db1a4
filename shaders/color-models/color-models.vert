uniform mat4 clipFromModel;
uniform vec3 cuts;  // the heights at which the three solids are cut
uniform int model;  // 0 the cube, 1 the double cone, 2 the cone
in vec4 position;
in vec2 texCoord;  // x: 1 on the square that covers the cut
out vec3 place;
out float onCut;

void main() {
    place = position.xyz;
    onCut = texCoord.x;
    if (onCut > 0.5) place.y = cuts[model];
    gl_Position = clipFromModel * vec4(place, 1.0);
}
