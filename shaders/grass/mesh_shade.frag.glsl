// Share of its light that a species leaves to the surface on which it grows, in the mean.
#include "lib/density.glsl"
#include "lib/dimmed.glsl"
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "lib/shadow.glsl"
#include "shared/bindings.h"
#include "shared/slices.h"

layout(std140, binding = UBO_SLICES) uniform SliceBlock { SliceGlobals slices; };

in vec3 position;
in vec3 normal;
in vec2 uv;

// Beer's law, as grass/appearance.h has it of level ground.
float lightLeft(float sine) {
    float y = max(sine, 0.15), across = slices.area.x * sqrt(max(1.0 - y * y, 0.0));
    return exp(-sqrt(across * across + slices.area.y * slices.area.y * y * y) / y);
}
const float kMeanSine = 0.6;  // of light from all around

void main() {
    vec3 n = normalize(normal);
    float sine = dot(n, frame.sunDirection), grown = GRASS_DENSITY ? texture(densityMap, uv).r : 1.0;
    // What the mesh was lit by: as much of each is left as comes through its way in the grass.
    vec3 direct = sunLight(n) * sunVisible(position, n), all = direct + ambientLight(n);
    vec3 left = (direct * lightLeft(sine) + ambientLight(n) * lightLeft(kMeanSine)) / max(all, vec3(1e-6));
    dimSurface(mix(vec3(1.0), left, grown), hazeLight(position));
}
