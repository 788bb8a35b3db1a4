// A square over the picture, behind everything.
uniform mat4 worldFromClip;  // directions
in vec4 position;
out vec3 way;

void main() {
    vec4 far = worldFromClip * vec4(position.xy, 1.0, 1.0);
    way = far.xyz / far.w;
    gl_Position = vec4(position.xy, 1.0, 1.0);
}
