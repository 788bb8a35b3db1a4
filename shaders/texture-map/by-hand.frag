// u/w and v/w, divided by 1/w at the end, or not.
#include "along-picture.glsl"
#include "texture-map.glsl"
uniform bool divided;
AlongPicture in vec3 overW;

void main() {
    showTexel(divided ? overW.xy / overW.z : overW.xy);
}
