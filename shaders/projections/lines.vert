uniform mat4 clipFromWorld;
uniform vec3 side;  // of each axis, the end that is in front of the eye: 1 or -1
in vec3 position;
in vec2 texCoord;  // 1: position is a direction; 0, also for meshes without: it is a point

void main() {
    // A direction is a point at infinity. Its w is 0, and no translation moves it.
    gl_Position = clipFromWorld * vec4(mix(position, side * position, texCoord.x), 1.0 - texCoord.x);
}
