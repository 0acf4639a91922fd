#include "terrain/lamp_hills.h"

#include "core/hash.h"
#include "frame/draw_context.h"

namespace sward {
namespace {

constexpr const char* kHillsOwner = "terrain/lamp-hills";
constexpr float kNoHills = -1e6f;  // demanded by no ground at all

struct LampHillsState : EffectState {
    GlName<TextureKind> maps;  // a layer a lamp
    Tally tally;
    Map of;                      // the heights below were taken from
    std::vector<uint64_t> made;  // by lamp: hash of what its map was made from; 0: nothing yet
};

// Everything is lit in maps that are not made yet, as in a sketch.
void makeHillMaps(Gpu& gpu, LampHillsState& s, size_t lamps) {
    constexpr size_t texels = static_cast<size_t>(LAMP_HILLS_LINES) * LAMP_HILLS_STEPS;
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id);
    s.maps = GlName<TextureKind>(id);
    glTextureStorage3D(id, 1, GL_R32F, LAMP_HILLS_LINES, LAMP_HILLS_STEPS, static_cast<GLsizei>(lamps));
    throwWithoutMemory();
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_REPEAT);  // once around the lamp
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glObjectLabel(GL_TEXTURE, id, -1, kHillsOwner);
    s.tally = Tally(gpu, kHillsOwner, 4 * texels * lamps);
    const std::vector<float> nothing(texels * lamps, kNoHills);
    glTextureSubImage3D(id, 0, 0, 0, 0, LAMP_HILLS_LINES, LAMP_HILLS_STEPS, static_cast<GLsizei>(lamps), GL_RED,
                        GL_FLOAT, nothing.data());
    s.made.assign(lamps, 0);
}

void keepHillMaps(DrawContext& ctx) {
    LampHillsState& s = ctx.own<LampHillsState>();
    const size_t lamps = static_cast<size_t>(ctx.shared.lights.casting);
    if (s.made.size() != lamps) makeHillMaps(ctx.gpu, s, lamps);
    glBindTextureUnit(TEX_LAMP_HILLS, s.maps.id());
}

// Names what a lamp's map is made from, beside the heights' texels.
uint64_t hillsOf(const DrawContext& ctx, size_t lamp) {
    const auto& [terrain, origin] = ctx.shared.ground;
    Hasher h;
    const auto add = [&](const auto& v) { h.add(&v, sizeof v); };
    add(ctx.shared.lampPlaces[lamp]), add(ctx.shared.lights.lights[lamp].isPoint);
    add(origin), add(terrain->size), add(terrain->heightRange);
    add(ctx.globals.heightTiling), add(ctx.globals.mapShare);
    return h.value() | 1;
}

void walkHills(DrawContext& ctx) {
    LampHillsState& s = ctx.own<LampHillsState>();
    const Map& heights = ctx.shared.ground.terrain->height.map;
    if (!(s.of.info() == heights.info() && s.of.sameTiles(heights))) s.made.assign(s.made.size(), 0);
    bool begun = false;
    for (size_t i = 0; i < s.made.size(); ++i) {
        const uint64_t wanted = hillsOf(ctx, i);
        if (s.made[i] == wanted) continue;
        if (!begun && !ctx.use()) return;
        if (!begun) glBindImageTexture(IMAGE_LAMP_HILLS, s.maps.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_R32F);
        begun = true;
        glUniform1i(0, static_cast<GLint>(i));
        glDispatchCompute(LAMP_HILLS_LINES / 32, 1, 1);
        ctx.pass->draws += 1;
        s.made[i] = wanted;
    }
    s.of = heights;
    if (begun) glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

const System kHillSystems[] = {{"terrain/lamp-hills/maps", {.reads = {Slot::Lamps, Slot::Ground}}, keepHillMaps}};
const ProgramRow kHillPrograms[] = {{"terrain/lamp-hills", nullptr, nullptr, "terrain/lamp_hills.comp.glsl"}};
const Pass kHillPasses[] = {{"terrain/lamp-hills",
                             Stage::Shadow,
                             kViewMain | kViewReflection,
                             {.reads = {Slot::Lamps, Slot::Ground}, .appends = {Slot::Shadows}},
                             kHillPrograms,
                             walkHills}};

}  // namespace

const EffectRow& lampHillsEffect() {
    static const EffectRow row{
        "terrain/lamp-hills",
        featureSet(Feature::LampHills, Feature::Terrain),
        kHillSystems,
        kHillPasses,
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<LampHillsState>(); },
        "hills shade lamps' light"};
    return row;
}

}  // namespace sward
