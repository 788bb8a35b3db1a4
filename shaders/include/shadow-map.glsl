// Looking things up in a shadow map (mv::DepthMap).
//
// `onMap` is LightView::mapFromWorld() * position, not yet divided by w: x and y become texture coordinates, z the depth
// 0..1 at which the light sees the point. The map holds the depths of what the light sees first. A point that is farther,
// by more than `bias` in units of that depth, is in shadow: 0; else the light reaches it: 1.
// The sampler compares by itself: with DepthLookup::compareNearest it looks at one texel, with compareLinear at four,
// and weights their four answers by distance. Points that the map does not hold are lit, and so are those behind the
// light.

bool isOnMap(vec4 onMap) {
    // 0 <= x/w <= 1 without dividing; it holds for no w below 0.
    return onMap.w > 0.0 && all(greaterThanEqual(onMap.xy, vec2(0.0))) && all(lessThanEqual(onMap.xy, onMap.ww));
}

// The depth to compare with. Points beyond the map's end are at its end, where the map has nothing: compared as it is,
// one driver finds it in shadow and another does not.
float comparedDepth(float depth, float bias) { return min(depth - bias, 1.0); }

// One look.
float litOneTap(sampler2DShadow map, vec4 onMap, float bias) {
    if (!isOnMap(onMap)) return 1.0;
    vec3 at = onMap.xyz / onMap.w;
    return textureLod(map, vec3(at.xy, comparedDepth(at.z, bias)), 0.0);
}

// Percentage-closer filtering: the mean answer of side x side looks, one texel apart and centred at the point.
// Answers are averaged, never depths: the mean of two depths is the depth of nothing.
float litPcf(sampler2DShadow map, vec4 onMap, float bias, int side) {
    if (!isOnMap(onMap)) return 1.0;
    vec3 at = onMap.xyz / onMap.w;
    vec2 texel = 1.0 / vec2(textureSize(map, 0));
    float first = -0.5 * float(side - 1);
    float sum = 0.0;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            vec2 offset = texel * (first + vec2(i, j));
            sum += textureLod(map, vec3(at.xy + offset, comparedDepth(at.z, bias)), 0.0);
        }
    }
    return sum / float(side * side);
}
