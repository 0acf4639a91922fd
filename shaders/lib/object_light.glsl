// Light from all around at the vertices of objects, divided by pi, as rays have found it (frame/object_light.h). No
// fragment shaders. Needs: const bool OBJECT_LIGHT.
#include "shared/bindings.h"
#include "shared/objects.h"

layout(std430, binding = SSBO_OBJECT_LIGHT) readonly buffer ObjectLightBlock { uvec2 objectLight[]; };

// At a vertex of the mesh whose first vertex has that number. Red below 0: none was found.
vec3 objectLightAt(uint first, uint vertex) {
    if (!OBJECT_LIGHT || first == NO_OBJECT_LIGHT) return vec3(-1.0);
    uvec2 light = objectLight[first + vertex];
    return vec3(unpackHalf2x16(light.x), unpackHalf2x16(light.y).x);
}
