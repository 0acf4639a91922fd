// How blades are lit that stand on the ground (lib/blade_light.glsl): in the world's axes.
#include "lib/blade_light.glsl"
#include "lib/density.glsl"
#include "lib/frame.glsl"
#include "lib/ground_around.glsl"
#include "lib/shadow.glsl"
#include "lib/species.glsl"

vec3 inAxes(vec3 way) { return way; }
vec3 sunWay() { return frame.sunDirection; }
vec3 sunAbove() { return frame.sunDirection; }
vec3 sunOverGround() { return frame.sunDirection; }
vec2 onMaps(vec2 metres) { return metres * frame.mapShare; }
vec2 densityAt(vec2 uv) { return tiled(uv, field.species[species.index].tiling); }
vec2 paintAt(vec2 uv) { return uv * field.vegetationTiling; }
float levelOnMaps(float metres, ivec2 size) { return levelOver(metres, size); }
vec3 objectBelow() { return vec3(0.0); }
float sunOnBlade(vec3 position, vec3 fromRoot) { return sunVisible(position, vec3(0.0)); }
vec3 skyOnBlade(vec3 position) { return groundAround(position) * skyOnGrassPastTrees(position); }

BladeLight lightOnGround(Lit p, vec2 uv) { return lightBlade(p, uv); }
