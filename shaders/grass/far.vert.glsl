// Corners of the horizontal slice: the terrain's nodes, lifted (Boulanger, Pattanaik and Bouatouch 2006, section 4.1).
// Where it stands for all of the grass, seen almost level, it rises to where such rays meet blades, so that a crest is
// as high as its grass: down to the ground where nothing grows, and at the terrain's edge.
#include "lib/density.glsl"
#include "lib/frame.glsl"
#include "lib/mirror.glsl"
#include "lib/node.glsl"
#include "shared/bindings.h"
#include "shared/slices.h"

layout(std140, binding = UBO_SLICES) uniform SliceBlock { SliceGlobals slices; };

out vec3 position;  // relative to the eye
out vec2 place;     // relative to the terrain's corner, metres

const float kRise = 0.05;  // metres a metre: less than what eyes over the grass look down by

// Share of the grass that stands around a corner.
float grownAround(NodeCorner c) {
    vec2 uv = mapPlace(c.place);
    if (any(lessThanEqual(c.place, vec2(0.0))) || any(greaterThanEqual(c.place, frame.terrainSize))) return 0.0;
    if (!GRASS_DENSITY) return bladeShare(uv);
    float level = levelOver(c.spacing, textureSize(densityMap, 0));
    return textureLod(densityMap, tiled(uv, field.species[slices.species].tiling), level).r * bladeShare(uv);
}

void main() {
    NodeCorner c = nodeCorner();
    place = c.place;
    float rise = min(kRise * max(length(c.position) - slices.riseFrom, 0.0), slices.farRise);
    position = c.position + vec3(0.0, slices.farHeight + (rise > 0.0 ? rise * grownAround(c) : 0.0), 0.0);
    cutAtWater(position.y);
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
