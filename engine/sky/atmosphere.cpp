#include "sky/atmosphere.h"

#include "frame/draw_context.h"
#include "sky/air_tables.h"
#include "sky/daylight.h"

namespace sward {
namespace {

constexpr const char* kOwner = "sky/atmosphere";

struct AtmosphereState : EffectState {
    AirTables tables;
    unsigned uploaded = 0;
    Texture sky, between;
};

void upload(Gpu& gpu, Texture& texture, const AirTable& table) {
    if (!texture.id()) texture = makeTexture2D(gpu, kOwner, GL_RGBA32F, table.width, table.height);
    glTextureSubImage2D(texture.id(), 0, 0, 0, table.width, table.height, GL_RGB, GL_FLOAT, table.values.data());
}

// For the whole frame: nothing else uses the bindings.
void makeAir(DrawContext& ctx) {
    AtmosphereState& s = ctx.own<AtmosphereState>();
    addAir(ctx.globals, ctx.project, ctx.settings.time, s.tables);
    ctx.shared.air = &s.tables;
    if (s.uploaded != s.tables.changes) {
        upload(ctx.gpu, s.sky, s.tables.sky);
        upload(ctx.gpu, s.between, s.tables.between);
        s.uploaded = s.tables.changes;
    }
    static_assert(TEX_AIR == TEX_SKY + 1);
    const GLuint textures[] = {s.sky.id(), s.between.id()};
    glBindTextures(TEX_SKY, 2, textures);
}

const System kSystems[] = {{kOwner, {.reads = {Slot::Haze}, .writes = {Slot::Haze, Slot::Air}}, makeAir, true}};

}  // namespace

const EffectRow& atmosphereEffect() {
    static const EffectRow row{
        kOwner,
        featureSet(Feature::Sky, Feature::Atmosphere),
        kSystems,
        {},
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<AtmosphereState>(); },
        "sky, sun and haze follow from one model of the air"};
    return row;
}

}  // namespace sward
