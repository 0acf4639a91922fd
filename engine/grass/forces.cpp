#include "grass/forces.h"

#include "frame/draw_context.h"
#include "shared/wind.h"
#include "world/forces.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/forces";
constexpr int kForcesSide = 512;   // texels
constexpr double kLeastSide = 32;  // metres
constexpr float kWidths = 8;       // of the largest force

// A force as its square is drawn.
struct ForcesDrawn {
    glm::vec4 line;
    glm::vec3 size;
};
struct ForcesState : EffectState {
    Texture map;
    Framebuffer target;
    VertexArray squares;
    Buffer drawn, globals;
    std::vector<Force> forces;
    size_t squaresDrawn = 0;  // those that are no outlines
    Outlines outlines;
    glm::dvec2 corner{0};  // of the map, relative to the terrain's corner
    double side = kLeastSide;
};

void describe(GLuint squares) {
    glVertexArrayBindingDivisor(squares, 0, 1);
    for (GLuint attribute = 0; attribute < 2; ++attribute) {
        glEnableVertexArrayAttrib(squares, attribute);
        glVertexArrayAttribBinding(squares, attribute, 0);
    }
    glVertexArrayAttribFormat(squares, 0, 4, GL_FLOAT, GL_FALSE, offsetof(ForcesDrawn, line));
    glVertexArrayAttribFormat(squares, 1, 3, GL_FLOAT, GL_FALSE, offsetof(ForcesDrawn, size));
}

std::unique_ptr<EffectState> makeForcesState(DrawContext& ctx) {
    auto s = std::make_unique<ForcesState>();
    s->map = makeTexture2D(ctx.gpu, kOwner, GL_RGBA16F, kForcesSide, kForcesSide);
    s->target = makeFramebuffer(s->map.id(), 0, kOwner);
    s->squares = makeVertexArray(kOwner);
    describe(s->squares.id());
    return s;
}

// Where the map lies: about the eye, in whole texels.
void place(ForcesState& s, const glm::dvec2& eye) {
    float widest = 0;
    for (const Force& f : s.forces) widest = std::max(widest, farOf(f));
    s.side = std::max(kLeastSide, static_cast<double>(kWidths * widest));
    const double texel = s.side / kForcesSide;
    s.corner = (glm::floor(eye / texel) - glm::dvec2(kForcesSide / 2)) * texel;
}

void listForces(DrawContext& ctx) {
    ForcesState& s = ctx.own<ForcesState>();
    const glm::dvec2 eye(ctx.eye.x, ctx.eye.z);
    s.forces = forcesOf(ctx.project, ctx.settings.time, &s.outlines);
    place(s, eye);
    std::erase_if(s.forces, [&](const Force& f) {
        const glm::dvec2 far(static_cast<double>(farOf(f)));
        return glm::any(glm::lessThan(glm::max(f.from, f.to) + far, s.corner)) ||
               glm::any(glm::greaterThan(glm::min(f.from, f.to) - far, s.corner + s.side));
    });
    std::vector<ForcesDrawn> drawn;
    for (const Force& f : s.forces)
        if (!f.outline)
            drawn.push_back({glm::vec4(glm::vec2(f.from - eye), glm::vec2(f.to - eye)), {f.radius, f.reach, f.share}});
    s.squaresDrawn = drawn.size();
    ctx.shared.forceTarget = {s.target.id(), kForcesSide, s.forces};
    writeBuffer(ctx.gpu, s.drawn, kOwner, drawn.size() * sizeof(ForcesDrawn), drawn.data());
    const ForceGlobals g{s.corner - eye, static_cast<float>(1 / s.side)};
    writeBuffer(ctx.gpu, s.globals, kOwner, sizeof(g), &g);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_FORCE, s.globals.id());
    glBindTextureUnit(TEX_FORCE, s.map.id());
}

void drawForces(DrawContext& ctx) {
    ForcesState& s = ctx.own<ForcesState>();
    if (!ctx.use()) return;
    const float none[4] = {0, 0, 0, 0};
    glClearNamedFramebufferfv(s.target.id(), GL_COLOR, 0, none);
    glBindFramebuffer(GL_FRAMEBUFFER, s.target.id());
    glViewport(0, 0, kForcesSide, kForcesSide);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glBlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
    glVertexArrayVertexBuffer(s.squares.id(), 0, s.drawn.id(), 0, sizeof(ForcesDrawn));
    glBindVertexArray(s.squares.id());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(s.squaresDrawn));
    ctx.pass->draws += 1;
    ctx.pass->instances += s.squaresDrawn;
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
}

const System kSystems[] = {{"grass/forces/list", {.writes = {Slot::ForceList}}, listForces, true}};
const ProgramRow kPrograms[] = {{"grass/forces", "grass/forces.vert.glsl", "grass/forces.frag.glsl", nullptr}};
const Pass kPasses[] = {{"grass/forces",
                         Stage::Simulate,
                         kViewMain | kViewReflection,
                         {.reads = {Slot::ForceList}, .writes = {Slot::Forces}},
                         kPrograms,
                         drawForces}};

}  // namespace

const EffectRow& forcesEffect() {
    static const EffectRow row{"grass/forces",  featureSet(Feature::Forces, Feature::Grass, Feature::Terrain),
                               kSystems,        kPasses,
                               makeForcesState, "something presses on the grass"};
    return row;
}

}  // namespace sward
