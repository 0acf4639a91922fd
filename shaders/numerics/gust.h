// Wind on a blade, from either model: waves (numerics/wind.h) or gusts, a periodic picture that the wind carries over
// the field. What it gives is a lean, as paint and clumps do (numerics/population.h poseBlade): roots stand, lengths
// stay, no wind is the rest pose to the last bit. Places are metres from the eye; what depends on eye and time is
// wrapped in double on the CPU, so that a month of wind at 90 km moves as the first second at the origin (J-1, T-3).

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#include "numerics/population.h"
#include "numerics/wind.h"
#endif

// Along the wind and across it, in repeats of the picture. begin: of the eye, wrapped; rate: repeats a metre.
FN vec2 gustPlace(vec2 at, vec2 way, vec2 begin, vec2 rate) {
    return vec2(begin.x + (at.x * way.x + at.y * way.y) * rate.x, begin.y + (at.y * way.x - at.x * way.y) * rate.y);
}

// How hard it blows, in [0, 1]: of gusts and of the finer ones that turbulence (in [0, 1]) mixes in.
FN real gustStrength(real coarse, real fine, real turbulence) { return mix(coarse, fine, real(0.4) * turbulence); }

// A blade's own quiver, in [-1, 1]: all at one frequency, none in unison. phase: of the time, turns; grain: the blade's
// number in [0, 1]; place: gustPlace of the fine gusts.
FN real quiver(real phase, real grain, vec2 place) {
    return sinTurns(turns(phase + grain) + turns(4.0f * (place.x + place.y)));
}

// Lean in metres a metre of blade. blows in [-1, 1]; quivers in [-1, 1], across the wind: an eighth of it at full
// turbulence, and none in a calm.
FN vec2 windLean(vec2 way, real strength, real blows, real turbulence, real quivers) {
    real across = 0.125f * turbulence * abs(blows) * quivers;
    return vec2(way.x * blows - way.y * across, way.y * blows + way.x * across) * strength;
}

// A force on a blade that leans: pushed aside by `push` (metres a metre, at most 1 long), pressed down by `press` in
// [0, 1] towards where it faces. 0 changes nothing, to the last bit. Source: Jahrmann and Wimmer 2013, section 5.2;
// J-8.
FN vec2 forcedLean(vec2 lean, vec2 push, real press, vec2 facing) {
    return lean * (1.0f - press) + push + facing * press;
}

// The force that something throws at a place: x, y push, z press. It is long and round: all within `radius` of a line.
// Pressed where it lies; around it, out to `reach` radii, pushed away from the line, ever less. `share` in [0, 1] of it
// is left (tracks recover). offset: from the line's begin to the place; line: from its begin to its end, which may be
// the same; metres.
FN vec3 longForce(vec2 offset, vec2 line, real radius, real reach, real share) {
    real along = clamp(dot(offset, line) / max(dot(line, line), kTiny), real(0.0), real(1.0));
    vec2 from = offset - line * along;
    real distance = sqrt(dot(from, from));
    if (!(distance < radius * reach) || !(radius > kTiny)) return vec3(real(0.0), real(0.0), real(0.0));
    real inside = clamp((radius - distance) / (real(0.2) * radius), real(0.0), real(1.0));
    real outside = distance < radius ? real(1.0) : (radius * reach - distance) / (radius * max(reach - 1.0f, kTiny));
    real push = share * outside * min(distance / (0.5f * radius), real(1.0));
    vec2 away = from / max(distance, kTiny);
    return vec3(away.x * push, away.y * push, share * inside);
}

// The force that an outline throws at a place: inside, blades lie, each its own way; around, they are pushed away from
// the edge out to radius * (reach - 1), ever less. distance: to the edge, below 0 inside; slope: how it changes over a
// metre towards x and z, which the push goes along. Across the edge the press gives way to the push within a fifth of a
// radius, outside: where both are whole, blades that face inwards would stand upright, through what presses them.
FN vec3 outlineForce(real distance, vec2 slope, real radius, real reach, real share) {
    real rim = radius * (reach - 1.0f);
    if (!(radius > kTiny) || !(distance < max(rim, real(0.2) * radius))) return vec3(real(0.0), real(0.0), real(0.0));
    real inside = clamp(1.0f - distance / (real(0.2) * radius), real(0.0), real(1.0));
    real push = share * (1.0f - inside) * max(rim - distance, real(0.0)) / max(rim, kTiny);
    real steep = max(sqrt(dot(slope, slope)), real(1.0));  // less where two edges are equally near: no way out
    return vec3(slope.x * (push / steep), slope.y * (push / steep), share * inside);
}

// The force that a texel of a painted map says: x, z about 1/2 the push, z the press, all times w. A push of half a
// step of eight bits is none.
FN vec3 paintedForce(vec4 texel) {
    vec2 push = paintOf(texel.x, texel.y);
    return vec3(push.x, push.y, texel.z) * texel.w;
}

// Several forces on a place: pushes add up to at most 1, the strongest press counts. What is not a number presses
// nothing.
FN vec3 forceOf(vec3 texel) {
    if (!(texel.x * texel.x + texel.y * texel.y <= real(1e6)) || !(texel.z * texel.z <= real(1e6)))
        return vec3(0.0f, 0.0f, 0.0f);
    real size = sqrt(texel.x * texel.x + texel.y * texel.y);
    real cut = size > 1.0f ? 1.0f / size : real(1.0);
    return vec3(texel.x * cut, texel.y * cut, clamp(texel.z, real(0.0), real(1.0)));
}
