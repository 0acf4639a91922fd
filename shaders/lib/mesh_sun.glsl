// The sun over an object on which grass grows, whose surface bends. Ways are in the axes of the surface, y its normal;
// bend: curvature (1/m) along x, mixed, along z (mesh/carrier.h).

// Curvature along a way; of a unit of length, up to `most` (1/m).
float bendTo(vec3 bend, vec3 way, float most) {
    return clamp(bend.x * way.x * way.x + 2.0 * bend.y * way.x * way.z + bend.z * way.z * way.z, -most, most);
}
// A sun that stands lower than the surface's horizon is hidden by the surface itself, unless one looks over its bend
// from high enough. rise: sine of the sun's elevation; bend: towards it, at least 0; above: the surface, metres.
float pastHorizon(float rise, float bend, float above) {
    return smoothstep(-0.05, 0.05, rise + sqrt(2.0 * bend * max(above, 0.0)));
}
// The sun over level ground that comes to the middle of the grass by as long a way through it: what bends away has less
// grass before a low sun. Unit.
vec3 sunOverLevel(vec3 sun, float bend, float height) {
    float rise = 0.5 * (sun.y + sqrt(sun.y * sun.y + bend * height));
    return vec3(sun.xz * sqrt(max(1.0 - rise * rise, 0.0) / max(dot(sun.xz, sun.xz), 1e-6)), rise).xzy;
}
