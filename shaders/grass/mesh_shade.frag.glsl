// Share of its light that a species leaves to the surface on which it grows, in the mean (as lib/ground_light.glsl has
// it of the ground).
#include "lib/density.glsl"
#include "lib/dimmed.glsl"
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "lib/shadow.glsl"
#include "numerics/slope.h"
#include "shared/bindings.h"
#include "shared/slices.h"

layout(std140, binding = UBO_SLICES) uniform SliceBlock { SliceGlobals slices; };

in vec3 position;
in vec3 normal;
in vec2 uv;
in vec3 around;
in float crowded;

void main() {
    vec3 n = normalize(normal), sun = frame.sunDirection;
    SpeciesInField kind = field.species[slices.species];
    float sine = dot(n, sun), grown = (GRASS_DENSITY ? texture(densityMap, uv).r : 1.0) * crowded;
    vec3 over = vec3(sqrt(max(1.0 - sine * sine, 0.0)), sine, 0.0);
    vec3 direct = sunLight(n) * sunVisible(position, n), sky = ambientLightOn(n, around);
    // Of each as much is left as comes through its way in the grass (Beer's law); and the sun's from blade to blade.
    vec3 left = direct * exp(-grown * leafDepth(slices.area, over, max(sine, kLeastRise))) +
                sky * pow(max(kind.skyLeft, 1e-6), grown) + direct * (kind.scattered / max(sun.y, kLeastRise) * grown);
    dimSurface(clamp(left / max(direct + sky, vec3(1e-6)), vec3(0.0), vec3(1.0)), hazeLight(position));
}
