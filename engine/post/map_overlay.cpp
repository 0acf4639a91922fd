#include "post/map_overlay.h"

#include "frame/draw_context.h"

namespace sward {
namespace {

constexpr const char* kOwner = "post/map-overlay";

// The texture that the grass reads, if it reads this map; else one of the overlay's own while it is shown.
GLuint textureOf(DrawContext& ctx, const ConstFieldRef& field) {
    const auto* wanted = static_cast<const MapField*>(field.value);
    if (const GrassField* f = firstOf<GrassField>(ctx.project)) {
        const SharedResources& r = ctx.shared;
        if (wanted == &f->orientation && r.orientation) return r.orientation;
        if (wanted == &f->forces && r.forces) return r.forces;
        if (wanted == &f->vegetation && r.vegetation) return r.vegetation;
        if (wanted == &f->ambientOcclusion && r.occlusion) return r.occlusion;
        if (wanted == &f->bladeHeight && r.bladeHeights) return r.bladeHeights;
        for (size_t i = 0; i < f->species.size() && i < r.densities.size(); ++i)
            if (wanted == &f->species[i].density && r.densities[i]) return r.densities[i];
    }
    return ctx.maps.get(kOwner, field.path, wanted->map, !field.row->isForce, true);
}

// How the shader shows it.
float kindOf(const FieldRow& row) {
    return row.isForce ? 3 : row.mapChannels < 3 ? static_cast<float>(row.mapChannels) : 4;
}

// Metres, with room for the ground's own roughness.
float tallestGrass(const Project& project) {
    float most = 0;
    if (const GrassField* f = firstOf<GrassField>(project))
        for (const Species& s : f->species) most = std::max(most, s.height * (1 + s.heightVariation));
    return most + 0.15f;
}

void draw(DrawContext& ctx) {
    const MapOverlay& overlay = ctx.settings.overlay;
    if (overlay.map.empty()) return;
    const Result<ConstFieldRef> field = findField(ctx.project, ctx.tables.components, overlay.map);
    if (!field || field->row->type != FieldType::Map) return;
    const Map& map = static_cast<const MapField*>(field->value)->map;
    const bool pressed =
        field->row->isForce && has(ctx.plan.features, Feature::Forces);  // also where nothing is painted
    if ((map.empty() && !pressed) || !ctx.use(0, depthConstants(ctx.targets))) return;
    if (!map.empty()) glBindTextureUnit(TEX_SCENE, textureOf(ctx, *field));
    glBindTextureUnit(ctx.targets.samples > 1 ? TEX_DEPTH_SAMPLES : TEX_DEPTH, ctx.targets.depth.id());
    const float metresPerPixel =
        1 / pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings));  // at a distance of one metre
    const float texelsPerMetre =
        static_cast<float>(std::max(map.info().width, 1) * overlay.tiling) * ctx.globals.mapShare.x;
    glUniform4f(0, kindOf(*field->row), static_cast<float>(overlay.tiling), metresPerPixel, texelsPerMetre);
    glUniform1f(1, tallestGrass(ctx.project));
    glUniform1i(2, !map.empty());
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    ctx.pass->draws += 1;
    ctx.pass->instances += 1;
}

const ProgramRow kPrograms[] = {{"post/map-overlay", "post/fullscreen.vert.glsl", "post/map_overlay.frag.glsl", nullptr,
                                 featureSet(Feature::TerrainHeights, Feature::Forces, Feature::Grass), depthVariants}};
const Pass kPasses[] = {{"post/map-overlay", Stage::Overlay, kViewMain, kSceneDepth | kImage, kImage, kPrograms, draw}};

}  // namespace

const EffectRow& mapOverlayEffect() {
    static const EffectRow row{"post/map-overlay",
                               featureSet(Feature::Terrain),
                               {},
                               kPasses,
                               nullptr,
                               "shows the painted map that the editor asks for"};
    return row;
}

}  // namespace sward
