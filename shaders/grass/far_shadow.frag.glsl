// Shadow of the horizontal slice on the ground, by one light: what is left of its light, multiplied onto the picture.
// The slice is followed down the light's ray (Boulanger, Pattanaik and Bouatouch 2006, section 3.5). It takes over from
// the blades' own shadows, and gives way to the mean.
#include "lib/density.glsl"
#include "lib/far.glsl"
#include "lib/force.glsl"
#include "lib/frame.glsl"
#include "lib/ground_light.glsl"
#include "lib/lamps.glsl"
#include "lib/slices.glsl"
#include "numerics/lod.h"
#include "numerics/opacity.h"

layout(location = 0) uniform int light;  // 0: the sun; i: lamp i - 1

in vec3 position;
in vec2 place;
in vec3 normal;
out vec4 color;

void main() {
    float d = length(position);
    vec3 towards = light == 0 ? frame.sunDirection : lampAt(light - 1, position).direction;
    float here = lodRamp(d, slices.minGeom, slices.geomInv), near = 1.0 - lodRamp(d, field.shadeFrom, field.shadeInv);
    vec2 uv = mapPlace(place);
    float grown = fieldDensity(uv), tall = bladeShareSeen(uv), density = sliceDensity(grown, here);
    if (!(density * near > 0.0) || !(towards.y > 0.0)) discard;
    float high = max(towards.y, 0.2);  // lower light throws no longer shadows
    vec4 stored;
    float opacity = farOpacity(sliceThreshold, repeated(position.xz + towards.xz * (slices.farHeight / high)), density,
                               tall, high, 0.0, laidBy(forceHere(position.xz, uv)), stored);
    SpeciesInField kind = field.species[slices.species];
    vec3 n = normalize(normal);
    SoilShares soil = soilShares(
        soilLeft(slices.area, vec2(kind.skyLeft, kind.scattered), slopeOf(n), grown, grown, tall), near, skyShare(uv));
    vec3 takes = shadowShare(light, position, n, soil);
    color = vec4(clamp(vec3(1.0) - takes * (opacity * near), vec3(0.0), vec3(1.0)), 1.0);
}
