#include "post/map_overlay.h"

#include "frame/draw_context.h"
#include "scene/technique.h"

namespace sward {
namespace {

constexpr const char* kOwner = "post/map-overlay";

// The texture that something else reads, if it does; else one of the overlay's own while it is shown.
GLuint textureOf(DrawContext& ctx, const ConstFieldRef& field) {
    if (const GLuint shared = ctx.maps.shared(field.path)) return shared;
    return ctx.maps.get(kOwner, field.path, static_cast<const MapField*>(field.value)->map,
                        field.row->map->kind == MapKind::Colours, true);
}

// How the shader shows it.
int kindNumber(MapKind kind) {
    switch (kind) {
        case MapKind::Amounts:
            return 1;
        case MapKind::Directions:
            return 2;
        case MapKind::Forces:
            return 3;
        case MapKind::Colours:
            return 4;
        case MapKind::Heights:
            return 5;
    }
    return 0;
}

// The land's lowest ground, seen from the eye; one over its relief; metres between contour lines, about ten of them:
// 1, 2 or 5 times a power of ten.
glm::vec3 reliefOf(const DrawContext& ctx) {
    const double low = static_cast<double>(ctx.shared.bounds.low), high = static_cast<double>(ctx.shared.bounds.high),
                 relief = std::max(high - low, 1e-3), tenth = relief / 10,
                 power = std::pow(10.0, std::floor(std::log10(tenth))), times = tenth / power;
    return {low - ctx.eye.y, 1 / relief, power * (times <= 1 ? 1 : times <= 2 ? 2 : times <= 5 ? 5 : 10)};
}

// Metres, with room for the ground's own roughness.
float tallestGrass(const Project& project) {
    float most = 0;
    for (const auto& [name, field] : fieldsOf(project))
        for (const Species& s : field.grows.species) most = std::max(most, s.height * (1 + s.heightVariation));
    return most + 0.15f;
}

void drawOverlay(DrawContext& ctx) {
    const MapOverlay& overlay = ctx.settings.overlay;
    if (overlay.map.empty()) return;
    const Result<ConstFieldRef> field = findField(ctx.project, ctx.tables.components, overlay.map);
    if (!field || field->row->type != FieldType::Map) return;
    const Map& map = static_cast<const MapField*>(field->value)->map;
    const bool pressed = field->row->map->kind == MapKind::Forces &&
                         has(ctx.plan.features, Feature::Forces);  // also where nothing is painted
    if ((map.empty() && !pressed) || !ctx.use(0, depthConstants(ctx.targets))) return;
    if (!map.empty()) glBindTextureUnit(TEX_SCENE, textureOf(ctx, *field));
    glBindTextureUnit(ctx.targets.samples > 1 ? TEX_DEPTH_SAMPLES : TEX_DEPTH, ctx.targets.depth.id());
    const float metresPerPixel =
        1 / pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings));  // at a distance of one metre
    const float texelsPerMetre =
        static_cast<float>(std::max(map.info().width, 1) * overlay.tiling) * ctx.globals.mapShare.x;
    glUniform1i(0, kindNumber(field->row->map->kind));
    glUniform1f(1, tallestGrass(ctx.project));
    glUniform1i(2, !map.empty());
    glUniform1f(3, static_cast<float>(overlay.tiling));
    glUniform1f(4, metresPerPixel);
    glUniform1f(5, texelsPerMetre);
    const glm::vec3 relief = reliefOf(ctx);
    glUniform3f(6, relief.x, relief.y, relief.z);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    ctx.pass->draws += 1;
    ctx.pass->instances += 1;
}

const ProgramRow kPrograms[] = {
    {"post/map-overlay", "post/fullscreen.vert.glsl", "post/map_overlay.frag.glsl", nullptr, depthVariants}};
const Pass kPasses[] = {
    {"post/map-overlay",
     Stage::Overlay,
     kViewMain,
     {.reads = {Slot::SceneDepth, Slot::Image, Slot::Grass, Slot::Forces, Slot::Ground}, .writes = {Slot::Image}},
     kPrograms,
     drawOverlay}};

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
