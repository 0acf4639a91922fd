// Lights beside the sun. Needs: const bool LAMPS.
#include "numerics/weights.h"
#include "shared/bindings.h"
#include "shared/light.h"

layout(std140, binding = UBO_LIGHTS) uniform LightsBlock { LightsGlobals lamps; };

int lampCount() { return LAMPS ? lamps.count : 0; }
int castingLamps() { return LAMPS ? lamps.casting : 0; }

// Lamp i as a point (relative to the eye) sees it: unit direction towards it, and irradiance on what faces it over pi.
struct LampHere {
    vec3 direction;
    vec3 light;
};
LampHere lampAt(int i, vec3 at) {
    LightGlobals l = lamps.lights[i];
    PointLight p = pointLight(l.place - at * l.isPoint, l.beta);
    LampHere here;
    here.direction = p.direction;
    here.light = l.color * p.attenuation;
    return here;
}
