// How a leaf answers light from one direction. Needs: const bool TRANSLUCENCY, GLOSS; numerics/glsl.h, basics.h, leaf.h.

// Light sent to the eye by a leaf of reflectance c that faces n (the side towards the eye), lit by `light` (irradiance over
// pi) from `towards`. looks: translucency, gloss, roughness.
vec3 leafLight(vec3 c, vec3 looks, vec3 n, vec3 toEye, vec3 towards, vec3 light) {
    float facing = dot(n, towards);
    vec3 sent = c * max(facing, 0.0);
    if (TRANSLUCENCY) sent += leafThrough(c) * (looks.x * max(-facing, 0.0));
    if (GLOSS) sent += vec3(looks.y * waxyLobe(n, towards, toEye, looks.z));
    return sent * light;
}
