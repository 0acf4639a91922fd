// How blades are lit that stand on an object (lib/blade_light.glsl): in the axes of its surface, past its own horizon.
#include "lib/blade_light.glsl"
#include "lib/light.glsl"
#include "lib/mesh_sun.glsl"
#include "lib/shadow.glsl"

struct OnMesh {
    mat3 toField;       // from the world's axes to the surface's
    vec3 normal;        // of the surface, unit
    vec3 around;        // light from all around on it; red below 0: as on open ground
    vec3 foot;          // of the blade, relative to the eye
    vec3 sun, sunOver;  // towards the sun, in the surface's axes; sunOverLevel of that
    float sunBend;      // curvature towards it, 1/m
    float uvLength;     // metres that one unit of texture coordinates is
};
OnMesh onMesh;

vec3 inAxes(vec3 way) { return onMesh.toField * way; }
vec3 sunWay() { return onMesh.sun; }
// Traced light knows none from below.
vec3 sunAbove() { return vec3(onMesh.sun.x, max(onMesh.sun.y, 0.02), onMesh.sun.z); }
vec3 sunOverGround() { return onMesh.sunOver; }
vec2 onMaps(vec2 metres) { return metres / onMesh.uvLength; }
vec2 densityAt(vec2 uv) { return uv; }
vec2 paintAt(vec2 uv) { return uv; }
float levelOnMaps(float metres, ivec2 size) {
    return log2(max(float(max(size.x, size.y)) * metres / onMesh.uvLength, 1.0));
}
vec3 objectBelow() { return onMesh.normal; }
float sunOnBlade(vec3 position, vec3 fromRoot) {
    return sunVisible(onMesh.foot, onMesh.normal) * pastHorizon(onMesh.sun.y, onMesh.sunBend, fromRoot.y);
}
// A surface that is turned sees less of the sky.
vec3 skyOnBlade(vec3 position) {
    vec3 level = max(ambientLight(vec3(0.0, 1.0, 0.0)), vec3(1e-6));
    return ambientLightOn(onMesh.normal, onMesh.around) / level * skyOnGrassPastTrees(position);
}

// on: of the blade.
BladeLight lightOnMesh(OnMesh on, Lit p, vec2 uv) {
    onMesh = on;
    return lightBlade(p, uv);
}
