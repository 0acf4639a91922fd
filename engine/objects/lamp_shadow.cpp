#include "objects/lamp_shadow.h"

#include <algorithm>

#include "core/hash.h"
#include "objects/shadow_maps.h"
#include "shared/objects.h"

namespace sward {
namespace {

constexpr const char* kLampOwner = "objects/lamp-shadow";
constexpr double kCascadeReach[LAMP_MAPS] = {8, 16, 32, 64, 128, 256};  // metres from the eye
constexpr double kCascadeSlack = 0.1;                  // share of the reach that the eye may move before a map is stale
constexpr double kCascadeHalf = 1.02 + kCascadeSlack;  // half a map's side, as a share of the reach: and room for taps
constexpr float kUnseen = 1e-4f;                       // light that no screen shows, as a share of white

// What is drawn anew as one: all faces of a cube, or a cascade.
struct DrawnMap {
    glm::dvec3 centre{0};   // of a cascade, in the world
    uint64_t drawn = 0;     // hash of what it shows; 0: nothing yet
    bool mirrored = false;  // drawn for what water mirrors, whose places round otherwise
};
struct LampMaps {
    bool isPoint = true;
    DrawnMap drawn[LAMP_MAPS]{};  // of a cube the first
    LightAxes axes = {};          // of a directional lamp
    // Maps that are drawn each by itself.
    int parts() const { return isPoint ? 1 : LAMP_MAPS; }
};
struct LampShadowState : EffectState {
    ShadowMaps maps;
    std::vector<LampMaps> lamps;
};
// From a view's eye to the maps, which all views share.
struct LampShadowView : EffectState {
    Buffer globals;
    LampShadowGlobals values{};
};

bool isPoint(const LightGlobals& light) { return light.isPoint > 0; }

// Maps for the lamps that cast; those that are there stay as long as there are as many, of the same kinds.
void keepMaps(DrawContext& ctx, LampShadowState& s) {
    const LightsGlobals& lights = ctx.shared.lights;
    const size_t lamps = static_cast<size_t>(lights.casting);
    if (s.lamps.size() != lamps) {
        s.maps = {};
        s.maps = makeShadowMaps(ctx.gpu, kLampOwner, LAMP_SHADOW_SIDE, LAMP_MAPS * lights.casting);
        s.lamps.assign(lamps, LampMaps());
    }
    for (size_t i = 0; i < lamps; ++i) {
        const bool point = isPoint(lights.lights[i]);
        if (s.lamps[i].isPoint != point) s.lamps[i] = LampMaps();
        s.lamps[i].isPoint = point;
    }
}

void aimCascades(DrawContext& ctx, LampMaps& lamp, const glm::vec3& towards, LampCascades& out) {
    if (lamp.axes.towards != towards || lamp.axes.origin != ctx.shared.ground.origin) {
        lamp.axes = axesAcross(towards, ctx.shared.ground.origin);
        for (DrawnMap& map : lamp.drawn) map.drawn = 0;
    }
    for (int i = 0; i < LAMP_MAPS; ++i) {
        DrawnMap& map = lamp.drawn[i];
        if (map.drawn == 0 || glm::distance(map.centre, ctx.around) > kCascadeSlack * kCascadeReach[i]) {
            map.centre = ctx.around;
            map.drawn = 0;
        }
        const double half = kCascadeReach[i] * kCascadeHalf;
        out.cascades[i].toMap = mapAround(lamp.axes, map.centre, ctx.camera.eye, half, LAMP_SHADOW_SIDE);
        out.cascades[i].reach = static_cast<float>(kCascadeReach[i]);
        out.cascades[i].texel = static_cast<float>(2 * half / LAMP_SHADOW_SIDE);
    }
}

void aimLamps(DrawContext& ctx) {
    LampShadowState& s = ctx.own<LampShadowState>();
    LampShadowView& view = ctx.ofView<LampShadowView>();
    keepMaps(ctx, s);
    for (size_t i = 0; i < s.lamps.size(); ++i) {
        if (s.lamps[i].isPoint) continue;
        LampCascades& out = view.values.lamps[i];
        aimCascades(ctx, s.lamps[i], ctx.shared.lights.lights[i].place, out);
        glNamedBufferSubData(view.globals.id(), static_cast<GLintptr>(i * sizeof(out)), sizeof(out), &out);
    }
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_LAMP_SHADOW, view.globals.id());
    glBindTextureUnit(TEX_LAMP_SHADOW, s.maps.texture.id());
}

// Metres from a lamp to which its light is seen at all; the next power of two, so that a flickering lamp's maps stay.
float seenTo(const LightGlobals& l) {
    const float share = std::max({l.color.x, l.color.y, l.color.z}) / kUnseen;
    if (!(share > 1)) return 0;
    const float reach = std::sqrt((share - 1) / l.beta);  // infinite where it does not fade
    return std::exp2(std::ceil(std::log2(reach)));
}

// A face of a cube: its axis, and those across; as cubePlace has them (shaders/lib/lamp_shadow.glsl).
struct Face {
    glm::vec3 ahead, right, up;
};
Face faceOf(int face) {
    const int axis = face / 2, right = axis == 0 ? 2 : 0, up = axis == 1 ? 2 : 1;
    Face f{glm::vec3(0), glm::vec3(0), glm::vec3(0)};
    f.ahead[axis] = face % 2 == 0 ? 1.0f : -1.0f;
    f.right[right] = f.up[up] = 1;
    return f;
}

// Whether some of a ball, from the lamp, lies in a face's pyramid.
bool inFace(const Face& f, const glm::vec3& centre, float radius) {
    const float share = static_cast<float>(LAMP_SHADOW_SHARE), length = std::sqrt(1 + share * share);
    const float ahead = glm::dot(f.ahead, centre);
    for (const glm::vec3& across : {f.right, f.up})
        if (share * std::abs(glm::dot(across, centre)) - ahead > radius * length) return false;
    return ahead > -radius;
}

void setRows(const glm::vec4 (&rows)[4]) { glUniform4fv(1, 4, &rows[0].x); }

void drawFace(DrawContext& ctx, const LampShadowState& s, const LightGlobals& light, int layer, int face) {
    const Face f = faceOf(face);
    const auto row = [&](const glm::vec3& axis, float scale) {
        return glm::vec4(axis, -glm::dot(axis, light.place)) * scale;
    };
    const float share = static_cast<float>(LAMP_SHADOW_SHARE), near = static_cast<float>(LAMP_SHADOW_NEAR);
    const float reach = seenTo(light);
    beginShadowMap(s.maps, layer + face);
    setRows({row(f.right, share), row(f.up, share), glm::vec4(0, 0, 0, near), row(f.ahead, 1)});
    const bool inMirror = glm::dot(glm::cross(f.right, f.up), f.ahead) > 0;
    for (const ShadowCaster& c : ctx.shared.casters) {
        const glm::vec3 from = c.centre - light.place;
        if (glm::length(from) - c.radius < reach && inFace(f, from, c.radius)) drawCaster(ctx, c, inMirror);
    }
}

void drawCascade(DrawContext& ctx, const LampShadowState& s, const LampMaps& lamp, const ShadowCascade& cascade,
                 int layer) {
    const glm::mat4 m = glm::transpose(cascade.toMap);
    const glm::vec4 one(0, 0, 0, 1);
    beginShadowMap(s.maps, layer);
    setRows({m[0] * 2.0f - one, m[1] * 2.0f - one, m[2], one});
    glEnable(GL_DEPTH_CLAMP);  // what stands nearer to the light than the map still shades
    for (const ShadowCaster& c : ctx.shared.casters)
        if (shadesWithin(lamp.axes, c, cascade.reach)) drawCaster(ctx, c);
    glDisable(GL_DEPTH_CLAMP);
}

// What all maps of a lamp show, and for a cube from where.
uint64_t wantedOf(const DrawContext& ctx, size_t i) {
    Hasher h;
    h.add(&ctx.shared.castersHash, sizeof ctx.shared.castersHash);
    h.add(&ctx.shared.lampPlaces[i], sizeof ctx.shared.lampPlaces[i]);
    const float reach = seenTo(ctx.shared.lights.lights[i]);
    if (isPoint(ctx.shared.lights.lights[i])) h.add(&reach, sizeof reach);
    return h.value() | 1;
}

// The mirror takes what the main view drew; the main view draws its own, so that it is the same without a mirror.
bool isStale(const DrawContext& ctx, const DrawnMap& map, uint64_t wanted) {
    return map.drawn != wanted || (map.mirrored && ctx.globals.mirrored == 0);
}

void drawLamp(DrawContext& ctx, LampShadowState& s, size_t i, uint64_t wanted) {
    LampMaps& lamp = s.lamps[i];
    const LampCascades& values = ctx.ofView<LampShadowView>().values.lamps[i];
    const int first = LAMP_MAPS * static_cast<int>(i);
    for (int m = 0; m < lamp.parts(); ++m) {
        DrawnMap& map = lamp.drawn[m];
        if (!isStale(ctx, map, wanted)) continue;
        if (!lamp.isPoint) drawCascade(ctx, s, lamp, values.cascades[m], first + m);
        for (int face = 0; lamp.isPoint && face < LAMP_MAPS; ++face)
            drawFace(ctx, s, ctx.shared.lights.lights[i], first, face);
        map.drawn = wanted;
        map.mirrored = ctx.globals.mirrored != 0;
    }
}

void drawLamps(DrawContext& ctx) {
    LampShadowState& s = ctx.own<LampShadowState>();
    bool begun = false;
    for (size_t i = 0; i < s.lamps.size(); ++i) {
        const uint64_t wanted = wantedOf(ctx, i);
        const auto* maps = s.lamps[i].drawn;
        const auto stale = [&](const DrawnMap& map) { return isStale(ctx, map, wanted); };
        if (std::none_of(maps, maps + s.lamps[i].parts(), stale)) continue;
        if (!begun && !ctx.use()) return;
        if (!begun) glViewport(0, 0, LAMP_SHADOW_SIDE, LAMP_SHADOW_SIDE);
        begun = true;
        drawLamp(ctx, s, i, wanted);
    }
}

const System kLampSystems[] = {{"objects/lamp-aim", {.reads = {Slot::Lamps, Slot::Ground}}, aimLamps}};
const ProgramRow kLampPrograms[] = {
    {"objects/lamp-shadow", "objects/lamp_shadow.vert.glsl", "objects/shadow.frag.glsl", nullptr}};
const Pass kLampPasses[] = {{"objects/lamp-shadow",
                             Stage::Shadow,
                             kViewMain | kViewReflection,
                             {.reads = {Slot::Casters, Slot::Lamps}, .appends = {Slot::Shadows}},
                             kLampPrograms,
                             drawLamps}};

}  // namespace

const EffectRow& lampShadowEffect() {
    static const EffectRow row{
        "objects/lamp-shadow",
        featureSet(Feature::LampShadows),
        kLampSystems,
        kLampPasses,
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<LampShadowState>(); },
        "objects shade lamps' light",
        [](DrawContext& ctx) -> std::unique_ptr<EffectState> {
            auto view = std::make_unique<LampShadowView>();
            view->globals = makeBuffer(ctx.gpu, kLampOwner, sizeof(LampShadowGlobals), nullptr);
            return view;
        }};
    return row;
}

}  // namespace sward
