// How much light a surface sends to the eye, by the models of the lecture. All vectors have unit length and point away from
// the surface: n its normal, l to the light, v to the eye. Each highlight is 0 where the light is behind the surface.

uniform vec3 color;
uniform vec3 lamp, eye;           // places, in the space of the points
uniform float diffusePart;        // of the light, by Lambert
uniform float highlightPart;
uniform float emitted;            // with no light at all
uniform float exponent;
uniform int lobe;                 // of the highlight: 0 Phong's, 1 Blinn's, 2 that of a brushed surface

// A power that is 0 of 0 and of less, where pow() may be anything.
float lobePower(float cosine) { return cosine > 0.0 ? pow(cosine, exponent) : 0.0; }

float phong(vec3 n, vec3 l, vec3 v) { return lobePower(dot(reflect(-l, n), v)); }

// Light and eye opposite each other have no half vector, and give no highlight.
float blinn(vec3 n, vec3 l, vec3 v) {
    vec3 both = l + v;
    return dot(both, both) > 0.0 ? lobePower(dot(n, normalize(both))) : 0.0;
}

// A bundle of threads along t, each lit all round: the brightest of the normals at right angles to t decides (Banks 1994).
// The brushing runs round the y axis; where that is the normal, it runs along x.
float brushed(vec3 n, vec3 l, vec3 v) {
    vec3 round = vec3(n.z, 0.0, -n.x);
    vec3 t = dot(round, round) > 0.0 ? normalize(round) : vec3(1.0, 0.0, 0.0);
    float alongL = dot(l, t), alongV = dot(v, t);
    float acrossL = sqrt(max(1.0 - alongL * alongL, 0.0)), acrossV = sqrt(max(1.0 - alongV * alongV, 0.0));
    return lobePower(acrossL * acrossV - alongL * alongV) * max(dot(n, l), 0.0);
}

float highlight(vec3 n, vec3 l, vec3 v) {
    if (dot(n, l) <= 0.0) return 0.0;
    return highlightPart * (lobe == 0 ? phong(n, l, v) : lobe == 1 ? blinn(n, l, v) : brushed(n, l, v));
}

// Light of the lamp that comes from a point, the highlight apart in w. A normal that interpolation has made 0 says nothing:
// such a point is unlit.
vec4 reflected(vec3 point, vec3 normal) {
    if (dot(normal, normal) == 0.0) return vec4(emitted * color, 0.0);
    vec3 n = normalize(normal), l = normalize(lamp - point), v = normalize(eye - point);
    float shine = highlightPart > 0.0 ? highlight(n, l, v) : 0.0;
    return vec4((emitted + diffusePart * max(dot(n, l), 0.0)) * color, shine);
}

// For a study: whether the line of sight through a point passes the middle of the body nearer than this, so that meshes
// of all finenesses cover it.
uniform float middleWithin;
bool isMiddle(vec3 point) { return length(cross(eye, normalize(point - eye))) < middleWithin; }
