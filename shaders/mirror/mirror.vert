uniform mat4 clipFromObject;   // through the mirrors
uniform mat4 worldFromObject;  // where the object stands itself: there it is lit
uniform vec4 beforeMirror;     // half space in world space; what is not in it stands behind the mirror
uniform bool clips;
in vec4 position;
in vec3 normal;
out vec3 worldPoint;
out vec3 worldNormal;

void main() {
    vec4 world = worldFromObject * position;
    worldPoint = world.xyz;
    worldNormal = mat3(worldFromObject) * normal;  // objects are turned, and scaled alike in all directions
#ifndef GL_ES
    // Mesa's llvmpipe cuts by what is written here even where GL_CLIP_DISTANCE0 is disabled.
    gl_ClipDistance[0] = clips ? dot(beforeMirror, world) : 1.0;
#endif
    gl_Position = clipFromObject * position;
}
