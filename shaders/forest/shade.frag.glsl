// What a forest leaves of the light on the ground below it, multiplied onto the picture: the shares of sun and sky that
// reach the lowest part of the air in its tiles. Near the eye trees are meshes, whose shadow maps take the sun's.
#include "lib/canopy.glsl"
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "lib/shadow.glsl"
#include "numerics/forest.h"
#include "shared/bindings.h"
#include "shared/forest.h"

layout(binding = TEX_FOREST_CANOPY) uniform sampler2D canopies;  // as TileInView::canopy, by vertices

in vec3 position;
in vec2 place;
in vec3 normal;
out vec4 color;

vec2 canopyAt(ivec2 vertex) { return texelFetch(canopies, vertex, 0).rg; }

void main() {
    vec2 uv = toLattice(place, forest.edge), within = fract(uv);
    ivec2 cell = ivec2(floor(uv)), at = cell - forest.firstCell;
    bool up = within.x + within.y <= 1.0;
    ivec2 size = textureSize(canopies, 0);
    if (at.x < 0 || at.y < 0 || at.x + 1 >= size.x || at.y + 1 >= size.y) discard;
    vec2 canopy = up ? (1.0 - within.x - within.y) * canopyAt(at) : (within.x + within.y - 1.0) * canopyAt(at + 1);
    vec2 aside = up ? within : 1.0 - within.yx;
    canopy += aside.x * canopyAt(at + ivec2(1, 0)) + aside.y * canopyAt(at + ivec2(0, 1));
    float distance = length(position);
    if (!(max(canopy.x, canopy.y) > 0.0)) discard;
    float volumes = smoothstep(forest.shadeFrom, forest.shadeTo, distance);
    vec2 stored = tileCell(edgeColors(cell.x, cell.y, up, forest.seed)) + within;
    vec3 stands = textureLod(lightImage, vec3(0.5 * stored, 0.0), 0.0).rgb;
    vec3 shares = pow(max(stands, vec3(LEAST_LIGHT)), canopy.xyy);
    vec3 n = normalize(normal), sky = ambientLight(n), sun = vec3(0.0);
    if (SUN) sun = sunLight(n) * sunVisible(position, vec3(0.0));
    vec3 left = (sky * shares.g + sun * mix(1.0, shares.r, volumes)) / max(sky + sun, vec3(1e-6));
    color = vec4(mix(left, vec3(1.0), hazeShare(distance)), 1.0);
}
