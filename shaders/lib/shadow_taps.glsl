// Share of light by a layer of shadow maps: four taps of two by two texels. at: place in the map, and depth.
float shadowTaps(sampler2DArrayShadow maps, vec3 at, float layer, float texelShare) {
    vec2 d = vec2(0.75 * texelShare);
    return 0.25 * (texture(maps, vec4(at.xy + d, layer, at.z)) + texture(maps, vec4(at.xy - d, layer, at.z)) +
                   texture(maps, vec4(at.xy + vec2(d.x, -d.y), layer, at.z)) +
                   texture(maps, vec4(at.xy - vec2(d.x, -d.y), layer, at.z)));
}
// By how much a point is raised over its own surface, in texels: as much as the surface rises under the taps, and for
// facets under smooth normals.
float shadowRaise(float facing) { return 2.2 * sqrt(1.0 - facing * facing) + 0.8; }
