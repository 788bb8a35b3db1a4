uniform mat4 clipFromPlane;
in vec4 position;
out float growth;

// x and y are a number z of the complex plane; z is negative where a step by that number makes things smaller.
void main() {
    growth = position.z;
    gl_Position = clipFromPlane * vec4(position.xy, 0.0, 1.0);
}
