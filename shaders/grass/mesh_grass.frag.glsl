// A ray through the slices over a mesh (lib/slice_rays.glsl), in the frame that the surface has where the ray comes in;
// from there on the surface is taken to bend as it does there, or so that it comes to where it was drawn. INSIDE: for
// an eye within the shell, in the frame that the surface has under the eye. Below the vertical slices lies the
// horizontal one. Maps lie on the mesh's texture coordinates. Needs: const bool INSIDE; const int REST; const bool
// WHOLE; const bool MULTISAMPLED.
#include "lib/density.glsl"
#include "lib/far_light.glsl"
#include "lib/field.glsl"
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "lib/mesh_sun.glsl"
#include "lib/motion.glsl"
#include "lib/scene_depth.glsl"
#include "lib/shadow.glsl"
#include "lib/slice_rays.glsl"
#include "lib/slices.glsl"
#include "lib/wind.glsl"
#include "numerics/clump.h"
#include "numerics/lod.h"
#include "numerics/opacity.h"
#include "numerics/stand.h"

layout(binding = TEX_FAR_REFLECTANCE) uniform sampler2DArray flatReflectance;
layout(binding = TEX_FAR_THRESHOLD) uniform sampler2DArray flatThreshold;
layout(binding = TEX_FAR_LIGHT) uniform sampler2DArray flatLight;
layout(binding = TEX_SUN_GAINS) uniform sampler3D sunGains;
// Of the nearest side of a shell that looks away from the eye: its depth; how steeply rays leave through it, and its
// part of the surfaces.
layout(binding = TEX_SHELL_ENDS) uniform sampler2D shellEnds;
layout(binding = TEX_SHELL_LEAVING) uniform sampler2D shellLeaving;
layout(location = 4) uniform float uvLength;  // metres that one unit of texture coordinates is
layout(location = 5) uniform float endsAt;    // metres over the surface at which those sides were drawn

in vec3 position;
in vec3 normal;
in vec2 uv;
in vec3 alongU;
in vec3 alongV;
in vec3 bend;
in float lift;
in vec3 around;
flat in vec4 chart;
flat in float part;  // below 0: it has an edge
layout(location = 0) out vec4 color;
layout(depth_less) out float gl_FragDepth;

const float kMostBent = 4.0;  // curvature of the surface that is followed at most, times the shell's height

float mapLevelOn(ivec2 size, float pixel) {
    vec2 texels = vec2(size) * (pixel / uvLength);
    return max(log2(max(max(texels.x, texels.y), 1e-6)), 0.0);
}
// Beyond the edge of the part of the texture coordinates in which the ray came in, others lie, of elsewhere.
vec2 uvOf(vec2 cells) { return clamp(cells * (slices.cellSize / uvLength), chart.xy, chart.zw); }
// Nothing grows where a surface that has an edge has ended.
bool isBeyond(vec2 cells) {
    vec2 at = cells * (slices.cellSize / uvLength);
    return part < 0.0 && (any(lessThan(at, chart.xy)) || any(greaterThan(at, chart.zw)));
}
float densityOn(vec2 cells, float pixel) {
    if (isBeyond(cells)) return 0.0;
    if (!GRASS_DENSITY) return 1.0;
    return textureLod(densityMap, uvOf(cells), mapLevelOn(textureSize(densityMap, 0), pixel)).r;
}
vec3 paintedOn(vec3 reflectance, vec2 cells, float pixel, vec3 toEye, bool far) {
    if (!GRASS_VEGETATION) return reflectance;
    vec4 paint = textureLod(vegetationMap, uvOf(cells), mapLevelOn(textureSize(vegetationMap, 0), pixel));
    return underPaint(reflectance, paint, paint.a, toEye, far);
}
// Share of the blades so far from the eye that are not drawn one by one.
float sharedAt(float distance) { return GRASS_MESH_GEOMETRY ? lodRamp(distance, slices.minGeom, slices.geomInv) : 1.0; }
float grownAt(Met m, Shell shell, float pixel) {
    return sliceDensity(densityOn(m.at, pixel), sharedAt(length(shell.start + shell.way * m.t)));
}

// Curvature of the surface along a direction in the field's axes, 1/m, of a unit of length.
float bendAlong(vec3 d) { return bendTo(bend, d, kMostBent / slices.top); }

float sunAt(Met m, Shell shell) { return shell.visible * pastHorizon(shell.sunRise, shell.sunBend, m.above); }
vec3 paintedAt(vec3 reflectance, Met m, Shell shell, float pixel) {
    return paintedOn(reflectance, m.at, pixel, -shell.seen, false);
}

// From the world's axes to the field's, square to each other: x along u, z along v, y the normal (H-6).
mat3 fieldAxes(vec3 n, vec3 u, vec3 v) {
    TangentFrame f = tangentFrame(n);
    vec3 t = unitOr(u, 1e-12, f.tangent), b = cross(t, n);
    if (dot(b, v) < 0.0) b = -b;
    return transpose(mat3(t, n, b));
}

// Lean by a wind, in the field's axes.
vec2 leantBy(vec2 blown, mat3 toField) { return (toField * vec3(blown.x, 0.0, blown.y)).xz; }

BladeStand standHere(vec3 foot, vec2 cells, mat3 toField) {
    BladeStand s = emptyStand();
    s.paint = GRASS_ORIENTATION ? paintOf(texture(orientationMap, uv).r, texture(orientationMap, uv).g) : vec2(0.0);
    s.leanAtFull = slices.leanAtFull;
    s.breeze = leantBy(windLeanAt(foot.xz, -1.0, field.species[slices.species].gusts), toField);
    vec2 whole = floor(cells);
    if (GRASS_CLUMPS && slices.clumpSize > 0.0)
        s.clump = clumpValues(int(whole.x), int(whole.y), (cells - whole) * slices.cellSize, slices.cellSize,
                              slices.clumpSize, slices.seed);
    s.clumpLean = slices.clumpLean;
    s.clumpHeight = slices.clumpHeight;
    s.clumpLightness = slices.clumpLightness;
    return s;
}

// The horizontal slice, where the ray comes down to it, below all vertical ones.
void addFlat(inout Sum sum, Shell shell, SliceRay ray, BladeLean p, vec3 sunGain, vec3 ambient) {
    float y = -shell.seen.y;
    ShellEnd e =
        shellEnd(ray.entry.z, ray.direction.z, shell.bend.x, shell.height * (1.0 - slices.farHeight / slices.top));
    if (!e.ground || !(e.t <= ray.end) || !(e.t < kRayNever) || !(y > 0.0)) return;
    float pixel = pixelAt(length(shell.start) + e.t), cells = pixel / slices.cellSize;
    vec2 c = ray.entry.xy + vec2(0.5 / float(slices.slices)) + ray.direction.xy * e.t;
    Repeated r = repeatedAt(c, vec2(cells, 0.0), vec2(0.0, cells / max(y, kTurned)));
    float vertical = sqrt(1.0 - min(dot(p.lean, p.lean), 0.9)) * verticalShare(y),
          density = sliceDensity(densityOn(c, pixel), sharedAt(length(shell.start) + e.t));
    if (!(density > 0.0)) return;
    vec4 stored;
    float alpha = farOpacity(flatThreshold, r, density, 1.0, y, vertical, 0.0, stored);
    if (!(alpha > 0.004)) return;
    vec4 leaf = textureGrad(flatReflectance, r.texel, r.dx, r.dy);
    leaf.rgb = paintedOn(leaf.rgb, c, pixel, -shell.seen, true);
    FarLit lit = FarLit(shell.sun, shell.toField, shell.start + shell.way * e.t, shell.raise, ambient,
                        shell.visible * pastHorizon(shell.sunRise, shell.sunBend, slices.farHeight), sunGain,
                        shell.brighter, vec3(1.0));
    vec3 light = clamp(farRadiance(flatLight, r, leaf, stored.zw, lit), vec3(0.0), vec3(kBrightest)) * farLevel(cells);
    add(sum, light, alpha, e.t);
}

// The curvature by which the surface comes to where the scene's depth has it: what triangles and dents make of the even
// bend `k`. Only of what lies about there: another thing beyond the outline says nothing of the surface.
float bendSeen(float k, float above, float sinks, float scene) {
    if (!(scene > 0.0)) return k;
    float off = abs(above + sinks * scene + 0.5 * k * scene * scene) / slices.top, most = kMostBent / slices.top;
    float seen = clamp(-2.0 * (above + sinks * scene) / (scene * scene), -most, most);
    return mix(seen, k, smoothstep(0.5, 1.5, off));
}

// The same by where the ray meets the surface, or else leaves the shell over the same part of it, `scene` and `leaves`
// metres on. Of a ray that leaves it is known how steeply: so the surface may bend more there than here.
vec2 bendHere(float k, float above, float sinks, float scene, float leaves) {
    vec2 leaving = texelFetch(shellLeaving, ivec2(gl_FragCoord.xy), 0).rg;
    if (!(leaves > 0.0 && leaves < scene && leaving.g == part)) return vec2(bendSeen(k, above, sinks, scene), 0.0);
    float higher = (endsAt - above) / leaves, rises = leaving.r;
    return vec2((6.0 * higher - 4.0 * sinks - 2.0 * rises) / leaves,
                (6.0 * (sinks + rises) - 12.0 * higher) / (leaves * leaves));
}

// Metres down to where the grass begins, `over` metres below a ray; less than 0: it never comes down to that.
float toGrass(float over, float sinks, float k) {
    if (!(over > 0.0)) return 0.0;
    float falls = sinks * sinks - 2.0 * k * over;
    return sinks < 0.0 && falls >= 0.0 ? 2.0 * over / (sqrt(falls) - sinks) : -1.0;
}

// At its outline a mesh's triangles lie inside the surface that bends around them: what is left of a ray that comes
// down on that so flatly is closed by the grass before it, or one would look through between both.
void closeOutline(inout Sum sum, SliceRay ray, float bend, float height) {
    float sine = abs(ray.direction.z + bend * ray.end), flat_ = 1.25 * sqrt(max(bend * height, 0.0)),
          open = sum.through;
    if (!ray.ground || !(open < 0.99) || !(sine < flat_)) return;
    sum.through *= smoothstep(0.5 * flat_, flat_, sine);
    sum.light *= (1.0 - sum.through) / (1.0 - open);
}

void main() {
    vec3 n = normalize(normal), way = position / max(length(position), 1e-4), start = INSIDE ? vec3(0.0) : position;
    gl_SampleMask[0] = -1;
    gl_FragDepth = gl_FragCoord.z;
    vec3 u = (alongU - n * dot(n, alongU)) * (uvLength / slices.cellSize),
         v = (alongV - n * dot(n, alongV)) * (uvLength / slices.cellSize);
    mat3 toField = fieldAxes(n, u, v);
    vec3 seen = toField * way, t = toField * u, b = toField * v;
    // Cells along u and v, a metre along the tangent and the bitangent.
    mat2 cellsAlong = mat2(vec2(t.x, b.x), vec2(t.z, b.z));
    vec2 cells = uv * (uvLength / slices.cellSize);
    float above = lift * slices.top;
    vec3 foot = start - n * above;
    BladeStand stands = standHere(foot, cells, toField);
    BladeLean p = leanOf(stands, vec2(0.0));
    float lean2 = min(dot(p.lean, p.lean), 0.9), upright = sqrt(1.0 - lean2);
    float height = max(slices.top * p.scale * upright, 1e-4), k = bendAlong(seen);
    k /= max(1.0 + k * above, 0.25);  // a lifted surface bends less
    float far = length(start), scene = distanceTo(sceneDepth(ivec2(gl_FragCoord.xy)), way) - far,
          side = texelFetch(shellEnds, ivec2(gl_FragCoord.xy), 0).r, leaves = distanceTo(side, way) - far;
    // Whoever comes into a surface without an edge leaves it: of this pixel the shell has no more than a corner.
    if (!INSIDE && part > 0.0 && !(side > 0.0)) discard;
    vec2 bends = bendHere(k, above, seen.y, max(scene, 0.0), leaves);
    k = bends.x;
    float ahead = toGrass(above - height, seen.y, k), sinks = seen.y + k * ahead, begins = min(above, height);
    if (!(ahead >= 0.0)) discard;
    vec2 shear = cellsAlong * (p.lean / upright), rate = cellsAlong * seen.xz;
    vec3 entry = vec3(cells + rate * ahead - shear * begins - vec2(0.5 / float(slices.slices)), begins - height);
    SliceRay ray = sliceRay(entry, vec3(rate - shear * sinks, sinks), slices.slices, slices.slices, height);
    ShellEnd end = shellEnd(entry.z, sinks, k, height);
    ray.end = bends.y != 0.0 ? leaves - ahead : end.t;
    ray.ground = end.ground && bends.y == 0.0;
    if (!(sharedAt(length(start) + ahead + min(ray.end, kRayNever) + height) > 0.0)) discard;

    vec3 toEye = -seen;
    float level = max(length(seen.xz), 1e-4);
    if (INSIDE) far = slices.cellSize;
    Shell shell;
    shell.way = way, shell.seen = seen;
    shell.start = start + way * ahead;
    shell.height = height;
    shell.bend = bends;
    shell.toField = toField;
    vec3 sun = toField * frame.sunDirection;
    shell.sunRise = sun.y, shell.sunBend = max(bendAlong(sun), 0.0);
    sun = sunOverLevel(sun, shell.sunBend, height);
    shell.sun = SunSeen(sun, lampWeights(sun));
    shell.turned = CONSERVING ? verticalShare(toEye.y) * abs(seen.xz) / level : vec2(1.0);
    vec3 open = ambientLightOn(n, around) / max(ambientLight(vec3(0.0, 1.0, 0.0)), vec3(1e-6));
    vec3 plain = vec3(p.lighter * darkened(far) * slices.reflectScale);
    vec3 shown = plain * (GRASS_MESH_GEOMETRY ? sharedGain(toEye, sharedAt(far + ahead)) : 1.0);
    vec4 sunGain = SUN ? textureLod(sunGains, directedPlace(toEye, sun), 0.0) : vec4(0.0);
    sunGain.rgb *= shown * (lampFade(sun) * directedSpot(toEye, sun));
    shell.gain = sunGain.rgb * frame.sunLight * frame.sunIsUp;
    shell.ambient = shown * sliceGain(toEye, p.free - p.clump, p.clump, 0.0, false) * slices.ambient * open;
    shell.brighter = plain;
    shell.raise = n;
    shell.visible = sunVisible(shell.start, n);

    uint grain = INSIDE ? grainAt(cells + rate * (ahead + far), seen.y, far) : grainAt(cells + rate * ahead, 0.0, far);
    Sum sum = traced(shell, ray, grain);
    vec3 flatAmbient = plain * sliceGain(toEye, p.free - p.clump, p.clump, 0.0, true) * slices.farAmbient * open;
    addFlat(sum, shell, ray, p, sunGain.rgb * sunGain.a, flatAmbient);
    closeOutline(sum, ray, k, height);
    color = shownOf(sum, shell, grain);
    if (!(color.a > 0.0)) discard;
    // No grass sinks into the surface on which it stands.
    if (scene > ahead) sum.depth = min(sum.depth, 0.98 * (scene - ahead));
    gl_FragDepth = depthOf(sum, shell, gl_FragCoord.z);
    if (TEMPORAL) {
        stands.breeze = leantBy(windLeanBefore(foot.xz, -1.0, field.species[slices.species].gusts), toField);
        tellMotion(transpose(toField) * movedSince(sum, shell, ray, p, leanOf(stands, vec2(0.0))));
    }
}
