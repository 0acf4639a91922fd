// A corner of a flower (numerics/flower.h): 0 to 3 its stem's, from the root up; 4 to 7 its head's. Placed, leant and
// lit here.
#include "lib/density.glsl"
#include "lib/force.glsl"
#include "lib/frame.glsl"
#include "lib/ground_around.glsl"
#include "lib/heights.glsl"
#include "lib/lamp_shadow.glsl"
#include "lib/lamps.glsl"
#include "lib/light.glsl"
#include "lib/shadow.glsl"
#include "lib/wind.glsl"
#include "numerics/basics.h"
#include "numerics/bilinear.h"
#include "numerics/flower.h"
#include "numerics/hash.h"
#include "numerics/lod.h"
#include "numerics/stand.h"
#include "shared/bindings.h"
#include "shared/flowers.h"

layout(std140, binding = UBO_FLOWERS) uniform FlowerBlock { FlowerGlobals flowers; };
layout(binding = TEX_FLOWERS) uniform sampler2D densityHere;
layout(location = 0) in ivec2 cell;
layout(location = 1) in vec2 cellCorner;  // relative to the eye

out vec2 uv;
out vec4 lit;    // light on what faces so, over pi; w: share of haze
out vec3 shown;  // normal
flat out vec3 petal;
flat out uint grain;
out vec3 moved;  // metres since the frame before

float densityAt(vec2 uv) {
    float tiling = flowers.tiling;
    if (!FLOWER_DENSITY || tiling < 0.0) return 1.0;
    ivec2 size = textureSize(densityHere, 0);
    BilinearTap t;
    if (tiling > 0.0)
        t = bilinearTapRepeat(uv.x * tiling, uv.y * tiling, size.x, size.y);
    else
        t = bilinearTap(uv.x, uv.y, size.x, size.y);
    return bilinearMix(texelFetch(densityHere, ivec2(t.x0, t.y0), 0).r, texelFetch(densityHere, ivec2(t.x1, t.y0), 0).r,
                       texelFetch(densityHere, ivec2(t.x0, t.y1), 0).r, texelFetch(densityHere, ivec2(t.x1, t.y1), 0).r,
                       t.fx, t.fy);
}

// blown: lean by the wind.
vec2 leanAt(Flower f, vec2 at, vec2 place, vec2 blown) {
    BladeStand s = emptyStand();
    s.wind = blown;
    if ((FORCES && GRASS) || FORCE_MAP) {
        vec3 force = forceHere(at, place);
        s.push = force.xy;
        s.press = force.z;
    }
    return leanOf(s, f.facing).lean;
}

vec3 lightOn(vec3 at, vec3 n, float open, vec2 place) {
    vec3 sum = ambientLight(n) * groundAround(at) * (open * skyShare(place) * skyOnGrassPastTrees(at));
    if (SUN)
        sum += frame.sunLight * (flowerSends(n, frame.sunDirection) * frame.sunIsUp * sunVisible(at, vec3(0.0)) * open);
    for (int i = 0; i < lampCount(); ++i) {
        LampHere l = lampReaching(i, at, vec3(0.0));
        sum += l.light * (flowerSends(n, l.direction) * open);
    }
    return sum;
}

void main() {
    uint number = uint(gl_VertexID) / 8u, corner = uint(gl_VertexID) % 8u;
    Flower f = flowerOf(cell.x, cell.y, number, flowers.expected, flowers.seed);
    vec2 ground = (vec2(cell) + f.place) * flowers.cellSize, share = ground * frame.terrainShare,
         place = mapPlace(ground);
    vec2 at = cellCorner + f.place * flowers.cellSize;
    vec3 root = vec3(at.x, groundHeight(ground), at.y);
    float distance = length(root), kept = 1.0 - lodRamp(distance, flowers.thinFrom, flowers.thinInv),
          standing = flowersStanding(flowers.headSize / max(flowers.leastSize * distance, 1e-6));
    float size =
        max(share.x, share.y) > 1.0 ? 0.0 : flowerSize(f.threshold, densityAt(place), standing, kept, flowers.widest);
    uv = vec2(0.0);
    lit = vec4(0.0);
    shown = petal = vec3(0.0);
    grain = 0u;
    moved = vec3(0.0);
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    if (!(size > 0.0)) return;
    float rises = min(size, 1.0);
    float tall = flowers.height * (1.0 + flowers.variation * f.taller), strength = winds[NOW].strength;
    vec3 stem = flowerStem(f, tall, leanAt(f, at, place, windLeanAt(at, f.grain, strength))) * rises;
    FlowerFrame b = flowerFrame(stem, f.facing, unitOr(-(root + stem), 1e-6, vec3(0.0, 1.0, 0.0)));
    float half_ = 0.5 * flowers.headSize * f.larger * size, across = float(corner & 1u) * 2.0 - 1.0,
          top = float((corner >> 1) & 1u);
    bool head = corner >= 4u;
    vec3 position = root + b.side * (across * half_) + (head ? stem + b.up * ((top * 2.0 - 1.0) * half_) : stem * top);
    shown = head ? b.face : stemNormal(unitOr(-root, 1e-6, vec3(0.0, 1.0, 0.0)));
    uv = vec2(across * 0.5 + 0.5, head ? (1.0 - top) * flowers.headShare : mix(1.0, flowers.headShare, top));
    petal = mix(flowers.petal, flowers.second, f.second);
    grain = hash3(uint(cell.x), uint(cell.y), number);
    lit = vec4(lightOn(position, shown, head ? 1.0 : flowerOpen(top), place), hazeShare(length(position)));
    if (TEMPORAL) {
        vec3 before = flowerStem(f, tall, leanAt(f, at, place, windLeanBefore(at, f.grain, strength))) * rises;
        moved = (stem - before) * (head ? 1.0 : top);
    }
    gl_Position = frame.viewProj * vec4(position, 1.0);
}
