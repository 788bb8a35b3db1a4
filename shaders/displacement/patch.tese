// Displacement mapping: each point that the tessellator has made is moved below the smooth surface by the height map, and its
// normal follows from the heights around it.
//
// Two patches meet at an edge without a crack if they compute the same bits there: from the same corners, in sums that are the
// same from either end, without the compiler's liberties (`precise`), and with a height that depends on the point alone.
layout(quads, equal_spacing, ccw) in;
uniform mat4 clipFromBody;
uniform sampler2D painted;  // the height in alpha
uniform float depth, moved; // of the relief; by how much of it points are moved: all or nothing
uniform float texel;        // of the map, in units
uniform bool isRound;
in vec3 control[];
out vec3 point;
out vec3 facing;
out vec2 place;
out float level;

vec3 smoothAt(float u, float v) {
    precise vec3 low = control[0] * (1.0 - u) + control[1] * u;
    precise vec3 high = control[2] * (1.0 - u) + control[3] * u;
    precise vec3 at = low * (1.0 - v) + high * v;
    precise float size = sqrt(at.x * at.x + at.y * at.y + at.z * at.z);
    return isRound ? at / size : at;
}

vec2 placeOf(vec3 p) {
    if (!isRound) return vec2(0.5 * p.x, 0.5 * p.y + 0.5);
    float away = length(p.xz), z = p.z == 0.0 ? 0.0 : p.z;  // of two zeros one is taken: their angles are a turn apart
    return vec2(away > 1e-6 ? atan(z, -p.x) / 6.2831853 + 0.5 : 0.0, 0.5 + atan(p.y, away) / 3.1415927);
}
float heightAt(vec3 p) { return textureLod(painted, placeOf(p), 0.0).a; }

void main() {
    vec3 at = smoothAt(gl_TessCoord.x, gl_TessCoord.y);
    vec3 outward = isRound ? at : vec3(0.0, 0.0, 1.0);
    float below = 1.0 - heightAt(at);
    precise vec3 there = at - moved * below * outward;
    precise vec4 clip = clipFromBody * vec4(there, 1.0);
    gl_Position = clip;
    point = there;

    // The slope by differences along two ways across the normal, a texel to each side
    vec3 one = normalize(cross(abs(outward.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), outward));
    vec3 other = cross(outward, one);
    vec3 slope = ((heightAt(at + texel * one) - heightAt(at - texel * one)) * one +
                  (heightAt(at + texel * other) - heightAt(at - texel * other)) * other) /
                 (2.0 * texel);
    // Along the orange a unit of the smooth surface is shorter below it.
    facing = normalize(outward - depth / (isRound ? 1.0 - depth * below : 1.0) * slope);

    // Within a patch u goes on beyond the seam; at a pole, where it says nothing, it is that of the middle.
    place = placeOf(at);
    if (isRound) {
        float middle = placeOf(control[0] + control[1] + control[2] + control[3]).x;
        if (length(at.xz) <= 1e-6) place.x = middle;
        place.x -= round(place.x - middle);
    }
    level = gl_TessLevelInner[0];
}
