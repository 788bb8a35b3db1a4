// The surface that is seen in a pixel, as an earlier pass has stored it in several textures.
uniform sampler2D colors, normals, depths;
uniform mat4 worldFromClip;

struct Surface {
    vec3 color, normal, point;
    bool isThere;
};
Surface surfaceAt(ivec2 pixel) {
    float depth = texelFetch(depths, pixel, 0).r;
    vec2 across = (vec2(pixel) + 0.5) / vec2(textureSize(depths, 0));
    vec4 world = worldFromClip * vec4(2.0 * vec3(across, depth) - 1.0, 1.0);
    vec3 normal = 2.0 * texelFetch(normals, pixel, 0).rgb - 1.0;
    return Surface(texelFetch(colors, pixel, 0).rgb, normalize(normal), world.xyz / world.w, depth < 1.0);
}
