// Shadow of the horizontal slice on the ground, by one light: what is left of its light there.
// The slice is followed down the light's ray (Boulanger, Pattanaik and Bouatouch 2006, section 3.5). It takes over from
// the blades' own shadows, and gives way to the mean.
#include "lib/density.glsl"
#include "lib/dimmed.glsl"
#include "lib/far.glsl"
#include "lib/force.glsl"
#include "lib/frame.glsl"
#include "lib/ground_light.glsl"
#include "lib/lamps.glsl"
#include "lib/slices.glsl"
#include "numerics/lod.h"
#include "numerics/opacity.h"

layout(location = 0) uniform int light;         // 0: the sun; i: lamp i - 1
layout(location = 1) uniform vec2 bladesUntil;  // distance from which blades' own shadows fade (m), and its lodInverse

const int kMostLooks = 12;
const float kFiner = 0.5;  // of a pixel's width: a look is blurred by a texel and more, which samples do anyway

in vec3 position;
in vec2 place;
in vec3 normal;

// Share of a light that the grass keeps off a place. In the mean it is farOpacity's. Where a pixel is narrower than
// what the light's ray crosses of the grass, blades throw shadows of their own: the ray looks at as many places as the
// slice's optical depth lies on it, which hide the light from each other by chance, as blades do. Looks get as coarse
// as the mean where a pixel gets as wide, so that no line is seen there.
// r: where the ray meets the slice. high: the light's sine.
float shadeOf(Repeated r, vec3 towards, float high, float density, float tall, float laid) {
    vec4 stored;
    float mean = farOpacity(sliceThreshold, r, density, tall, high, 0.0, laid, stored);
    float slant = sqrt(1.0 - high * high) / high, crossed = slices.meanHeight * max(slant, laid),
          pixel = max(length(r.dx), length(r.dy)) / slices.sharpness;
    if (!CONSERVING || !(pixel < crossed) || !(mean > 0.0)) return mean;
    float depth = depthFactor(high, 0.0, laid) * tall, left = 1.0 - min(mean, 0.9999);
    int looks = int(clamp(ceil(depth), 1.0, float(kMostLooks)));
    float each = (1.0 - pow(left, 1.0 / float(looks))) / max(1.0 - pow(left, 1.0 / max(depth, 1e-3)), 1e-4),
          finer = mix(frame.lookShare * kFiner, 1.0, (pixel / crossed) * (pixel / crossed)),
          level = clamp(log2(finer * pixel * slices.farTexels), 0.0, 16.0);
    vec2 apart = towards.xz / max(length(towards.xz), 1e-4) * r.mirror * (crossed / float(looks));
    float through = 1.0;
    for (int i = 0; i < looks; ++i) {
        vec3 texel = vec3(r.texel.xy + apart * (0.5 * float(looks - 1) - float(i)), r.texel.z);
        vec4 here = textureLod(sliceThreshold, texel, level);
        through *= 1.0 - min(each * storedOpacity(here, density, level, chanceOf(r.cell)), 1.0);
    }
    return 1.0 - through;
}

void main() {
    float d = length(position);
    vec3 towards = light == 0 ? frame.sunDirection : lampAt(light - 1, position).direction;
    float here = lodRamp(d, bladesUntil.x, bladesUntil.y), near = 1.0 - lodRamp(d, field.shadeFrom, field.shadeInv);
    vec2 uv = mapPlace(place);
    float grown = fieldDensity(uv), tall = bladeShareSeen(uv);
    if (!(towards.y > 0.0)) discard;
    float high = max(towards.y, 0.2);  // lower light throws no longer shadows
    // What stands before a light is what grows half-way to where it comes in.
    float before = fieldDensity(uv + towards.xz * (0.5 * slices.meanHeight * slices.cellSize / high) * frame.mapShare),
          density = sliceDensity(before, here);
    if (!(density * near > 0.0)) discard;
    Repeated r = repeated(position.xz + towards.xz * (slices.farHeight / high));
    float opacity = shadeOf(r, towards, high, density, tall, laidBy(forceHere(position.xz, uv)));
    SpeciesInField kind = field.species[slices.species];
    vec3 n = normalize(normal);
    SoilShares soil = soilShares(
        soilLeft(slices.area, vec2(kind.skyLeft, kind.scattered), slopeOf(n), grown, before, tall), near, skyShare(uv));
    vec3 takes = shadowShare(light, position, n, soil);
    dimSurface(clamp(vec3(1.0) - takes * (opacity * near), vec3(0.0), vec3(1.0)), hazeLight(position));
}
