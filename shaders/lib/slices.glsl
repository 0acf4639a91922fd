// What vertical and horizontal slices share: their images, light from tabulated directions, gains by view.
// Needs: frame.glsl; numerics opacity, lod; cover.glsl, light.glsl; const int STORAGE; const bool CONSERVING.
layout(std140, binding = UBO_SLICES) uniform SliceBlock { SliceGlobals slices; };
layout(binding = TEX_SLICE_REFLECTANCE) uniform sampler2DArray sliceReflectance;
layout(binding = TEX_SLICE_THRESHOLD) uniform sampler2DArray sliceThreshold;
layout(binding = TEX_SLICE_LIGHT) uniform sampler2DArray sliceLight;
const int FULL_STORAGE = 2;

// The four tabulated views around one towards the eye, and their weights.
struct LookTap {
    ivec4 view;
    vec4 weight;
};
LookTap lookTap(vec3 toEye) {
    float turn = fract(atan(toEye.z, toEye.x) / 6.28318530718) * float(LOOK_AZIMUTHS);
    if (!(abs(toEye.x) + abs(toEye.z) > 1e-6)) turn = 0.0;
    float high = sqrt(clamp(toEye.y, 0.0, 1.0)) * float(LOOK_ELEVATIONS - 1);
    int a = min(int(turn), LOOK_AZIMUTHS - 1), b = (a + 1) % LOOK_AZIMUTHS, low = min(int(high), LOOK_ELEVATIONS - 2);
    float fa = turn - float(a), fh = high - float(low);
    LookTap t;
    t.view = ivec4(a, b, a, b) + LOOK_AZIMUTHS * ivec4(low, low, low + 1, low + 1);
    t.weight = vec4((1.0 - fa) * (1.0 - fh), fa * (1.0 - fh), (1.0 - fa) * fh, fa * fh);
    return t;
}

// Factor that gives slices the mean radiance of the blades they stand for; `lean`: painted direction and strength.
vec3 sliceGain(vec3 toEye, vec2 lean, bool far) {
    LookTap t = lookTap(toEye);
    vec4 across = slices.gains[t.view.x] * t.weight.x + slices.gains[t.view.y] * t.weight.y + slices.gains[t.view.z] * t.weight.z + slices.gains[t.view.w] * t.weight.w;
    vec4 above = slices.farGains[t.view.x] * t.weight.x + slices.farGains[t.view.y] * t.weight.y + slices.farGains[t.view.z] * t.weight.z + slices.farGains[t.view.w] * t.weight.w;
    float leant = max(1.0 + dot(lean, vec2(across.w, above.w)), 0.1);
    return (far ? above.rgb : across.rgb) * leant;
}

// Opacity of a texel: thresholds are compared with the density, and filtered ones by the exact prefilter of that (B-14).
float texelOpacity(vec2 stored, float density, float level) {
    float threshold = stored.x / max(stored.y, 1.0 / 512.0);
    float sharp = opacityConserving(density, threshold, slices.counts.x);
    return stored.y * mix(sharp, density, clamp(level / 3.0, 0.0, 1.0));
}

// Filtered density of the species at a point of the terrain.
float fieldDensity(vec2 uv) {
    if (!GRASS_DENSITY) return 1.0;
    return texture(densityMap[0], uv).r;
}

vec3 paintedOver(vec3 reflectance, vec2 uv, float open) {
    if (!GRASS_VEGETATION) return reflectance;
    vec4 paint = texture(vegetationMap, uv * cover.tiling.y);
    return mix(reflectance, paint.rgb * open, paint.a);
}

// Lambert's cosine towards the sun from what a texel stores: `plus` and `minus` are the parts of normals along each axis and
// against it, `sun` its direction. One blade: the difference of what faces the sun and what turns away, if positive. Several
// blades, mixed by filtering: the mean of that over exponential shares.
float cosineOf(vec3 plus, vec3 minus, vec3 sun, float level) {
    vec3 s = max(sun, 0.0), t = max(-sun, 0.0);
    float toward = dot(plus, s) + dot(minus, t), away = dot(plus, t) + dot(minus, s);
    return mix(max(toward - away, 0.0), toward * toward / max(toward + away, 1e-4), clamp(0.5 + 0.5 * level, 0.0, 1.0));
}
