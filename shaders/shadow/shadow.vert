uniform mat4 clipFromView;
uniform mat4 viewFromModel;
uniform mat4 worldFromModel;
uniform vec4 abovePlane;
uniform vec4 belowLight;
in vec4 position;
out float heightAbovePlane;
out float depthBelowLight;

void main() {
    // Of the point that casts the shadow, not of the shadow.
    vec4 caster = worldFromModel * position;
    heightAbovePlane = dot(abovePlane, caster);
    depthBelowLight = dot(belowLight, caster);
    gl_Position = clipFromView * viewFromModel * position;
}
