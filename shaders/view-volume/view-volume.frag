uniform bool cutOpen;
in vec4 clip;
in vec3 vertexColor;
out vec4 fragColor;

void main() {
    // Before the division, as GL clips: w is negative behind the camera.
    bool inside = all(lessThanEqual(abs(clip.xyz), vec3(clip.w)));
    if (cutOpen && !inside) discard;
    fragColor = vec4(inside ? vertexColor : mix(vertexColor, vec3(1.0, 0.6, 0.2), 0.8), 1.0);
}
