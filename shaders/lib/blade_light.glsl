// How a point of a blade is coloured and lit: all that the fragment does not decide (lib/blade_pixel.glsl).
// Needs: const bool GRASS_VEGETATION, GRASS_HEIGHTS, SUN, FOG, ATMOSPHERE, BLADE_SHADOWS, CASTING_LIGHTS. hue,
// lightness: as numerics/population.h bladeTint takes them; uv: of the root (mapPlace). Directions are in the axes in
// which blades stand: the world's on the ground (lib/on_ground.glsl), the surface's on objects (lib/on_mesh.glsl).
#include "lib/blade.glsl"
#include "lib/field.glsl"
#include "lib/density.glsl"
#include "lib/frame.glsl"
#include "lib/lamp_shadow.glsl"
#include "lib/lamps.glsl"
#include "lib/leaf.glsl"
#include "lib/light.glsl"
#include "lib/mask.glsl"
#include "lib/others.glsl"
#include "lib/traced.glsl"
#include "numerics/basics.h"
#include "numerics/lying.h"
#include "numerics/population.h"
#include "numerics/slope.h"

// What lib/on_ground.glsl and lib/on_mesh.glsl each define:
vec3 inAxes(vec3 way);                        // a direction of the world, in the axes in which blades stand
vec3 sunWay();                                // towards the sun, in these
vec3 sunAbove();                              // as traced light takes it: never from below
vec3 sunOverGround();                         // as shadow masks take it: where the ground bends away, less grazing
vec2 onMaps(vec2 metres);                     // a step over the ground, as one on maps
vec2 densityAt(vec2 uv);                      // where the map of densities is read for a root there
vec2 paintAt(vec2 uv);                        // where the map of colours is
float levelOnMaps(float metres, ivec2 size);  // level of detail of a map whose texels are so long
vec3 objectBelow();                           // normal of the object on which a blade stands, unit; 0: it is the ground
float sunOnBlade(vec3 position, vec3 fromRoot);  // share of the sun's light left by objects, hills and trees
vec3 skyOnBlade(vec3 position);                  // the same of the sky's

// Reflectance; scattered: by how much it is brighter than that, where paint changes what goes from blade to blade.
struct BladeColor {
    vec3 reflectance, scattered;
};
// middleLacked: by the rows of the strip that it is a vertex of.
BladeColor bladeColor(float hue, float lightness, float v, float middleLacked, vec2 uv) {
    vec3 own = bladeTint(bladeGradientRow(species.rootColor, species.midColor, species.tipColor, v, middleLacked), hue,
                         lightness);
    if (!GRASS_VEGETATION) return BladeColor(own, vec3(1.0));
    vec4 paint = textureLod(vegetationMap, paintAt(uv), 0.0);
    vec3 painted = mix(own, paint.rgb, paint.a);
    return BladeColor(painted, paintScatters(own, painted, species.translucency, species.recollision));
}

// A vertex that is lit: its colour; the normal of the side that the eye sees; where it is; what of the light is left so
// near to the root, where no mask says it.
struct Lit {
    BladeColor color;
    vec3 normal, toEye, position, fromRoot;
    float neighbours;  // turns by which the mask of its neighbours is turned around its blade
    vec3 upright;      // of its pose
    vec2 slope;        // of the ground
    float open, density;
    float stands;  // share of what grows there that is not pressed down (lightBlade)
    float own;     // share of its shade and its facing that is its own: the rest is the mean of blades it stands for
};
// How far a blade's curve lies over the chords between its rows, in the mean; quads: of its strip.
vec3 overChords(BladePose pose, int quads) { return (2.0 * pose.control - pose.tip) / (6.0 * float(quads * quads)); }
// Where in the shadow mask it is, for a light.
vec3 maskFor(vec3 fromRoot, float neighbours, vec3 upright, vec2 slope, vec3 towards) {
    vec3 way = overLevel(stoodUp(towards, upright), slope);
    return maskPoint(stoodUp(fromRoot, upright), neighbours, unitOr(way, 1e-6, towards), species.maskRadius,
                     species.maskHeight);
}
// As leafLight takes them.
vec3 bladeGloss() { return vec3(species.translucency, species.gloss, species.roughness); }
// How high over the ground it would be if its blade stood upright: its neighbours lean as it does.
float highAmong(Lit p) { return max(stoodUp(p.fromRoot, p.upright).y, 0.0); }
// The species' density there, as a mean over so many metres.
float densityOver(vec2 uv, float metres) {
    return textureLod(densityMap, densityAt(uv), levelOnMaps(metres, textureSize(densityMap, 0))).r;
}
// How dense it grows at the root, by the share of its height that it has.
float grownAt(vec2 uv) { return (GRASS_DENSITY ? densityOver(uv, 0.0) : 1.0) * bladeShare(uv); }
// Share of what grows there that is not pressed down.
float standing(Lit p, vec2 uv) {
    if (!(FORCES || FORCE_MAP)) return 1.0;
    return clamp(p.density / max(grownAt(uv), 1e-3), 0.0, 1.0);
}
// Share of a direct light that those leave to it which lie. others: area of other species' leaves, towards a level
// view.
float lyingLeave(Lit p, vec2 uv, float others) {
    if (!(FORCES || FORCE_MAP) || p.stands >= 1.0) return 1.0;
    const float kAllSides = 1.5708;  // area of upright leaves that face anywhere, by that towards a level view
    return mix(lyingLit(kAllSides * (species.area.x * grownAt(uv) + others)), 1.0, p.stands);
}
// Towards the eye, over the ground as if it were level: unit.
vec3 overGround(Lit p) { return unitOr(overLevel(p.toEye, p.slope), 1e-6, p.toEye); }
// What other species leave of light from there, or of the sky's (0). Those are pressed down as it is, and what lies
// stands in no light.
float othersLeft(Lit p, vec2 uv, vec3 towards) {
    return mix(1.0, othersLight(uv, highAmong(p), towards, riseOver(towards, p.slope)).leave, p.stands);
}
// The density of what stands between a point of a blade and a light: over what reaches it, or half-way to where its
// ray comes out above.
float densityTowards(Lit p, vec2 uv, vec3 towards) {
    if (!GRASS_DENSITY) return p.density;
    float level = max(length(towards.xz), 1e-4), free = max(species.maskHeight - highAmong(p), 0.0),
          across = min(species.maskReach, 0.5 * free * level / max(riseOver(towards, p.slope), 1e-4));
    vec2 at = uv + onMaps(towards.xz * (across / level));
    return densityOver(at, across) * bladeShare(at) * p.stands;
}
// Where its height lies in the mask's.
float shareAmong(Lit p) { return highAmong(p) / max(species.maskHeight, 1e-4); }
// The sun's light among blades there: what comes from blade to blade of its own species, too, by their part of all
// leaves; what others and those that lie leave of it.
OthersLight sunAmong(Lit p, vec2 uv, float density) {
    vec3 sun = sunOverGround(), over = overLevel(sun, p.slope);
    OthersLight others = othersLight(uv, highAmong(p), sun, over.y);
    float lying = lyingLeave(p, uv, others.area);
    others.fill *= p.stands;
    others.area *= p.stands;
    others.leave = mix(1.0, others.leave, p.stands) * lying;
    float own = species.area.x * density, all = own + others.area, seen = (1.0 - exp(-all)) / max(all, 1e-3),
          past = exp(-density * depthAbove(species.area, shareAbove(species.maskHeight, highAmong(p)), sun, over.y));
    vec3 fill = directFill(over, shareAmong(p)) * (own / (1.0 - exp(-max(species.area.x, 1e-3)))) * others.leave;
    others.fill = seen * (fill + others.fill * (past * length(over)));
    return others;
}
// What a casting lamp's light sends from there, as shares of the lamp's: past the neighbours, and from blade to blade.
vec3 lampSends(Lit p, vec2 uv, LampHere l) {
    float density = densityTowards(p, uv, l.direction);
    vec3 over = overLevel(l.direction, p.slope);
    vec3 through = maskLight(maskFor(p.fromRoot, p.neighbours, p.upright, p.slope, l.direction), density) *
                   tracedDirect(overGround(p), over, density);
    vec3 sent = leafLight(p.color.reflectance, bladeGloss(), p.normal, p.toEye, l.direction, l.light) * through +
                p.color.reflectance * l.light * directFill(over, shareAmong(p)) * tracedShare(density, species.area.x);
    return sent * othersLeft(p, uv, l.direction) * lyingLeave(p, uv, 0.0);
}
// Lamps that cast shadows are shaded here, by the vertex: unlike the sun there may be many.
vec3 lampsOn(Lit p, vec2 uv) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lampCount(); ++i) {
        LampHere l = lampReaching(i, p.position, objectBelow());
        l.direction = inAxes(l.direction);
        if (BLADE_SHADOWS && i < castingLamps())
            sum += lampSends(p, uv, l);
        else
            sum += leafLight(p.color.reflectance, bladeGloss(), p.normal, p.toEye, l.direction, l.light) * p.open;
    }
    return sum * p.color.scattered;
}
// A point of a blade as it would be without the map of heights: its neighbours are lowered as it is. They stand as
// close as ever, so that they shade it as grass does that is thinner by as much (lightBlade).
vec3 inFullHeight(vec3 fromRoot, vec2 uv) { return GRASS_HEIGHTS ? fromRoot / max(bladeShare(uv), 0.02) : fromRoot; }
// Where blades shade blades the sun is told apart, because its shade is the fragment's.
struct BladeLight {
    vec4 lit;      // radiance, without the sun's where that is apart; w: share of it that is haze
    vec4 sunned;   // what a side that faces the sun sends of its light; w: density
    vec2 sunward;  // cosine of the seen side's normal with the sun; the highlight, as a share of the sun's light
    vec3 maskAt;   // where in the blades' shadow mask
};
// What blades like it, but turned any way, send of the sun's light, by how much of them is seen: the mean of four.
vec3 sentAround(Lit p, vec3 falls) {
    vec3 sum = vec3(0.0);
    float seen = 1e-4;
    for (int i = 0; i < 4; ++i) {
        p.normal = vec3(-p.normal.z, p.normal.y, p.normal.x);
        float eye = dot(p.normal, p.toEye), facing = dot(p.normal, sunWay());
        sum += abs(eye) * leafSent(falls, eye < 0.0 ? -facing : facing, TRANSLUCENCY ? species.translucency : 0.0);
        seen += abs(eye);
    }
    return sum / seen;
}
// The sun on a blade; share: of haze.
void sunBlade(Lit p, vec2 uv, float share, inout BladeLight o) {
    if (!SUN) return;
    vec3 left = p.color.scattered * sunOnBlade(p.position, p.fromRoot);
    if (!(BLADE_SHADOWS && CASTING_LIGHTS)) {
        o.lit.rgb +=
            leafLight(p.color.reflectance, bladeGloss(), p.normal, p.toEye, sunWay(), frame.sunLight) * left * p.open;
        return;
    }
    if (frame.sunCasts > 0.0) {
        p.density = densityTowards(p, uv, sunOverGround());
        OthersLight among = sunAmong(p, uv, p.density);
        o.lit.rgb += p.color.reflectance * frame.sunLight * left * among.fill;
        left *= among.leave;
        o.maskAt = maskFor(p.fromRoot, p.neighbours, p.upright, p.slope, sunOverGround());
        left *= tracedDirect(overGround(p), overLevel(sunAbove(), p.slope), p.density);
    } else {
        left *= p.open;
    }
    vec3 falls = p.color.reflectance * frame.sunLight * left;
    o.sunward.x = dot(p.normal, sunWay());
    if (GLOSS) o.sunward.y = species.gloss * waxyLobe(p.normal, sunWay(), p.toEye, species.roughness) * left.g;
    if (p.own < 1.0) {
        vec3 sent = sentAround(p, falls) + frame.sunLight * o.sunward.y;
        o.lit.rgb += sent * ((1.0 - p.own) * (frame.sunCasts > 0.0 ? maskMean(o.maskAt, p.density) : 1.0));
    }
    o.sunned = vec4(falls * (p.own * (1.0 - share)), p.density);
    o.sunward.y *= p.own * (1.0 - share);
}
BladeLight lightBlade(Lit p, vec2 uv) {
    BladeLight o = BladeLight(vec4(0.0), vec4(0.0), vec2(0.0), vec3(0.0));
    float distance = length(p.position), share = hazeShare(distance);
    p.color.reflectance *= darkened(distance);
    p.fromRoot = inFullHeight(p.fromRoot, uv);
    if (GRASS_HEIGHTS) p.density *= bladeShare(uv);
    p.stands = standing(p, uv);
    vec3 around = p.color.reflectance * p.color.scattered * tracedAmbient(p.normal, overGround(p));
    vec3 sky = skyShare(uv) * skyOnBlade(p.position) * p.open * (BLADE_SHADOWS ? othersLeft(p, uv, vec3(0.0)) : 1.0);
    o.lit = vec4(around * sky + lampsOn(p, uv), share);
    sunBlade(p, uv, share, o);
    if (FOG || ATMOSPHERE) o.lit.rgb = mix(o.lit.rgb, hazeColor(p.position), share);
    return o;
}
// The light at row v of a blade that is drawn straight (lib/straight.glsl), from that of species.lightRow and of the
// tip's row: what lies between its ends has the mean of that along the blade.
BladeLight straightLight(BladeLight low, BladeLight tip, float v) {
    float share = (v - species.lightRow) / (1.0 - species.lightRow);
    vec2 sunward = mix(low.sunward, tip.sunward, share);
    return BladeLight(max(mix(low.lit, tip.lit, share), vec4(0.0)), max(mix(low.sunned, tip.sunned, share), vec4(0.0)),
                      vec2(clamp(sunward.x, -1.0, 1.0), max(sunward.y, 0.0)), mix(low.maskAt, tip.maskAt, share));
}
