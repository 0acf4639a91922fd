#include "grass/slice_gains.h"

#include "core/hash.h"
#include "grass/field.h"
#include "grass/grass_fields.h"
#include "world/lights.h"
#include "world/wind.h"

namespace sward {
namespace {

bool lampsCast(const Project& project) {
    const Light* sun = sunLight(project);
    bool casts = false;
    for (const auto& [name, entity] : project.entities)
        if (const Light* light = project.registry.get<Light>(entity)) casts |= light != sun && light->castShadows;
    return casts;
}

// The other species of the field, where blades shade each other.
std::vector<Among> amongOf(const DrawContext& ctx, const GrownField& f, size_t index) {
    std::vector<Among> out;
    if (!has(f.features, Feature::BladeShadows) || f.among.means.empty()) return out;
    for (size_t k = 0; k < f.species.size(); ++k) {
        const Look& look = f.species[k]->look;
        const TracedLight* traced = has(f.features, Feature::GrassTraced) ? tracedOf(ctx, f.name, k) : nullptr;
        const float skyLeft = traced ? traced->soilSky : lightLeft(look, ctx.globals.sunDirection.y);
        if (k != index) out.push_back({look.height, {look.across, look.above}, skyLeft, f.among.of(k, index)});
    }
    return out;
}

FieldLight fieldLight(const DrawContext& ctx, const GrownField& f, size_t index) {
    const Species& s = f.grows().species[index];
    const FeatureSet& features = f.features;
    const FrameGlobals& g = ctx.globals;
    FieldLight l;
    l.sky = g.skyLight, l.ground = g.groundLight;
    if (has(features, Feature::Sun) && g.sunIsUp > 0) l.suns.push_back({g.sunDirection, g.sunLight});
    l.weighting = weightingOf(f.of->settings<GrassSlices>());
    l.translucency = s.translucency, l.gloss = s.gloss, l.roughness = s.roughness;
    if (g.sunCasts > 0 && f.species[index]->shade.texture) l.shade = &f.species[index]->shade;
    l.traced = has(features, Feature::GrassTraced) ? tracedOf(ctx, f.name, index) : nullptr;
    l.among = amongOf(ctx, f, index);
    l.lean = has(features, Feature::GrassOrientation) ? leanAtFull(s) : 0.0f;
    if (s.clumpSize > 0) l.lean = std::max(l.lean, clumpStrengths(s).x);
    if (has(features, Feature::Wind))
        l.lean = std::max(l.lean, std::clamp(windStrength(*firstOf<Wind>(ctx.project), s), 0.25f, 0.6f));
    l.painted = has(features, Feature::GrassDensity);
    l.tinted = has(features, Feature::GrassVegetation);
    l.pressed = has(features, Feature::Forces) || has(features, Feature::ForceMap);
    l.lampsCast = has(features, Feature::Lamps) && f.species[index]->shade.texture && lampsCast(ctx.project);
    return l;
}

// What a light's key reads of how blades shade and light each other.
void addShading(std::vector<float>& read, const FieldLight& l) {
    if (l.shade) read.insert(read.end(), l.shade->rows.begin(), l.shade->rows.end());
    for (const Among& a : l.among) read.insert(read.end(), {a.height, a.area.x, a.area.y, a.skyLeft, a.density});
    if (!l.traced) return;
    const auto add = [&](const auto& numbers) {
        for (const glm::vec3& n : numbers) read.insert(read.end(), {n.x, n.y, n.z});
    };
    const auto& [blades, shows] = std::tie(l.traced->blades, l.traced->shows);
    add(blades.direct), add(blades.sky), add(blades.ground);
    add(shows.direct), add(shows.sky), add(shows.ground);
    if (l.tinted) add(l.traced->grey.direct), add(l.traced->grey.sky);
    for (size_t k = 0; k < kTracedLeans; ++k) add(l.traced->leaning.direct[k]), add(l.traced->leaning.sky[k]);
}
uint64_t keyOf(const GrownSpecies& s, std::vector<float> read, const FieldLight& l) {
    addShading(read, l);
    return hashBytes(read.data(), read.size() * sizeof(float)) ^ s.lookKey ^ s.slices.means.key;
}

void keepGains(const GrownSpecies& s, const FieldLight& l, Gains& gains, uint64_t& madeFrom) {
    std::vector<float> read{l.sky.x,
                            l.sky.y,
                            l.sky.z,
                            l.ground.x,
                            l.ground.y,
                            l.ground.z,
                            static_cast<float>(l.weighting),
                            l.lean,
                            l.translucency,
                            l.gloss,
                            l.roughness,
                            l.pressed ? 1.0f : 0.0f,
                            l.painted ? 1.0f : 0.0f,
                            l.tinted ? 1.0f : 0.0f,
                            l.lampsCast ? 1.0f : 0.0f};
    for (const auto& [d, c] : l.suns) read.insert(read.end(), {d.x, d.y, d.z, c.x, c.y, c.z});
    const uint64_t key = keyOf(s, std::move(read), l);
    if (madeFrom == key) return;
    madeFrom = key;
    gains = gainsOf(s.look, l, s.slices.means);
}

// Gains of light from any direction, kept as a texture. of: makes its kDirectedGains texels; a sketch has 1.
template <typename Texel, typename Of>
void keepDirected(const DrawContext& ctx, const char* owner, Texture& texture, uint64_t& madeFrom, uint64_t key,
                  GLenum format, Of of) {
    if (texture.id() && madeFrom == key) return;
    if (ctx.sketching() && texture.id()) return;
    madeFrom = ctx.sketching() ? 0 : key;
    std::array<Texel, kDirectedGains> gains;
    gains.fill(Texel(1));
    if (!ctx.sketching()) gains = of();
    if (!texture.id()) texture = makeTexture3D(ctx.gpu, owner, format, LAMP_AZIMUTHS, LAMP_ELEVATIONS, LAMP_ELEVATIONS);
    glTextureSubImage3D(texture.id(), 0, 0, 0, 0, LAMP_AZIMUTHS, LAMP_ELEVATIONS, LAMP_ELEVATIONS,
                        format == GL_RG16F ? GL_RG : GL_RGBA, GL_FLOAT, gains.data());
}

// Gains of lamps' light, where there are lamps.
void updateLampGains(const DrawContext& ctx, const GrownField& f, GrownSpecies& s, FieldLight l) {
    if (!has(f.features, Feature::Lamps)) {
        s.lampGains = {}, s.lampGainKey = 0;
        return;
    }
    l.shade = l.lampsCast ? &s.shade : nullptr;
    keepDirected<glm::vec2>(ctx, "grass/far", s.lampGains, s.lampGainKey,
                            keyOf(s, {l.translucency, l.gloss, l.roughness}, l), GL_RG16F,
                            [&] { return lampGainsOf(s.look, l, s.slices.means); });
}

// Gains on objects, whose surfaces have the sun in directions of their own: of the sky's light, and of the sun's by
// where it stands.
void updateMeshGains(const DrawContext& ctx, const GrownField& f, GrownSpecies& s, FieldLight l) {
    const bool grows = f.draws(Feature::GrassOnMeshes);
    if (!grows || !has(f.features, Feature::Sun)) s.sunGains = {}, s.sunGainKey = 0;
    if (!grows) return;
    const bool conserving = f.of->settings<GrassSlices>().sliceCover == SliceCover::Conserving;
    l.lampsCast = l.shade != nullptr;
    if (!l.suns.empty())
        keepDirected<glm::vec4>(
            ctx, "grass/mesh-grass", s.sunGains, s.sunGainKey,
            keyOf(s, {l.translucency, l.gloss, l.roughness, float(l.weighting), float(conserving)}, l), GL_RGBA16F,
            [&] {
                SunGains ones;
                ones.fill(glm::vec4(1));
                return conserving ? sunGainsOf(s.look, l, s.slices.means) : ones;
            });
    l.suns.clear();
    keepGains(s, l, s.skyGains, s.skyGainKey);
    // Levels of detail are as bright as each other in all of the light.
    s.skyGains.farLevels = s.gains.farLevels, s.skyGains.sliceLevels = s.gains.sliceLevels;
}

// The greatest size of a colour of any.
float greatest(const std::array<glm::vec3, LOOK_VIEWS>& factors) {
    float most = 1e-6f;
    for (const glm::vec3& f : factors) most = std::max({most, std::abs(f.x), std::abs(f.y), std::abs(f.z)});
    return most;
}

}  // namespace

uint32_t packedGain(const glm::vec3& factor, float scale) {
    const glm::uvec3 share(glm::round(glm::clamp(factor / scale, 0.0f, 1.0f) * 1023.0f));
    return share.x | share.y << 10 | share.z << 20;
}

void setGains(SliceGlobals& g, bool conserving, Gains gains) {
    if (!conserving)
        for (auto* factors :
             {&gains.slices, &gains.far, &gains.thin, &gains.laid, &gains.paintAcross, &gains.paintAbove})
            factors->fill(glm::vec3(1));
    if (!conserving) gains.leans = {}, gains.shine = {};
    if (!conserving) gains.farLevels.fill(1), gains.sliceLevels = evenLevels(), gains.thinner.fill(1);
    for (int i = 0; i < FAR_LEVELS; ++i) g.farLevels[i / 4][i % 4] = gains.farLevels[static_cast<size_t>(i)];
    for (size_t i = 0; i < LOOK_ELEVATIONS * SLICE_LEVELS; ++i)
        g.sliceLevels[i / 4][static_cast<int>(i % 4)] = gains.sliceLevels[i / SLICE_LEVELS][i % SLICE_LEVELS];
    for (int i = 0; i < LOOK_ELEVATIONS; ++i) g.thinner[i / 4][i % 4] = gains.thinner[static_cast<size_t>(i)];
    g.hotSpot = conserving ? gains.hotSpot : glm::vec3(0);
    g.lampHotSpot = conserving ? gains.lampHotSpot : glm::vec3(0);
    g.gainScale = {greatest(gains.slices), greatest(gains.far), greatest(gains.laid), greatest(gains.thin)};
    g.recollision = conserving ? gains.recollision : 0;
    g.leanScale = 0;
    for (const auto& lean : gains.leans) g.leanScale = std::max(g.leanScale, greatest(lean));
    for (size_t i = 0; i < LOOK_VIEWS; ++i) {
        const auto lean = [&](size_t k) { return packedGain(0.5f * (gains.leans[k][i] + g.leanScale), g.leanScale); };
        g.gains[i] = {packedGain(gains.slices[i], g.gainScale.x),
                      packedGain(gains.far[i], g.gainScale.y),
                      packedGain(gains.laid[i], g.gainScale.z),
                      packedGain(gains.thin[i], g.gainScale.w),
                      packedGain(gains.paintAcross[i], float(PAINT_SCALE)),
                      packedGain(gains.paintAbove[i], float(PAINT_SCALE)),
                      packedGain(glm::vec3(gains.shine[i]), float(SHINE_SCALE)),
                      lean(0),
                      lean(1),
                      lean(2),
                      lean(3),
                      lean(4)};
    }
}

void makeGains(DrawContext& ctx, const GrownField& field, size_t species) {
    const FieldLight light = fieldLight(ctx, field, species);
    GrownSpecies& s = *field.species[species];
    keepGains(s, light, s.gains, s.gainKey);
    updateLampGains(ctx, field, s, light);
    updateMeshGains(ctx, field, s, light);
}

}  // namespace sward
