// Lamps that reach so far and no farther: 1/d^2, pressed down to 0 at the end of their reach.
uniform float reach;

// The light that a surface at this point, with this unit normal, gets from one of them. A lamp is 5 cm thick: nearer there is no more.
vec3 lightOf(vec3 place, vec3 power, vec3 point, vec3 normal) {
    vec3 toLamp = place - point;
    float d = max(length(toLamp), 0.05), window = max(1.0 - d * d / (reach * reach), 0.0);
    return power * (max(dot(normal, toLamp / d), 0.0) * window * window / (d * d));
}
