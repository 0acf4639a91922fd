// What a pass or system is handed: the project, the view, and the engine's shared services. No statics anywhere.
#pragma once
#include <glm/glm.hpp>

#include "frame/map_textures.h"
#include "frame/plan.h"
#include "frame/renderer.h"
#include "gpu/program.h"
#include "gpu/resources.h"
#include "shared/frame.h"
#include "shared/grass.h"
#include "shared/light.h"
#include "shared/terrain.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace sward {

// The frustum's six planes over eye-relative positions, normals inward: dot(n, p) + d >= 0 inside.
struct Frustum {
    std::array<glm::vec4, 6> planes;
    // Whether any of the box between `low` and `high` (metres, relative to the eye) may be in view; sometimes true for
    // a box just outside a corner, never false for one that is seen.
    bool touches(const glm::vec3& low, const glm::vec3& high) const;
    bool holds(const glm::vec3& low, const glm::vec3& high) const;  // all of the box
};
Frustum frustumOf(const glm::mat4& viewProj);

// How a species' blades shade each other, made by grass/mask. Texture 0: they do not.
struct BladeShade {
    GLuint texture = 0;
    float radius = 0, top = 0;  // of the mask's cylinder, metres
    std::vector<float> rows;    // mean of the mask's rows at density 1, from the ground up
};

struct CellDraw;  // grass/cells.h
// A species' blades as they are drawn this frame, for passes that draw them once more. Nothing selected: count 0.
struct BladeDraws {
    GLuint mesh = 0, indices = 0, buffer = 0,
           globals = 0;  // vertex array with cells; indices of whole strips; SSBO_BLADES; UBO_SPECIES
    const CellDraw* cells = nullptr;
    size_t count = 0;
    GLuint shadowCommands =
        0;  // `count` commands that the GPU made of cells that it chose, at shadowOffset bytes; 0: the cells are here
    size_t shadowOffset = 0;
    uint32_t strips = 0;  // blades that the indices hold
    int segments = 0;
    uint32_t verticesABlade = 0;  // of drawCommand (grass/cells.h)
    float shading = 1;            // share of them that is enough to shade the soil as all of them would
};

// Triangles that shade what lies behind them. The vertex array has positions at 0, texture coordinates at 2, and at 3
// to 5 the rows of a matrix to eye-relative positions, one an instance.
struct ShadowCaster {
    GLuint vertexArray = 0, instance = 0;
    uint32_t firstIndex = 0, indices = 0;  // of 32 bits
    GLuint image = 0;                      // what is cut out by its alpha below `cutoff`; 0: nothing
    float cutoff = 0;
    glm::vec3 centre{0};  // of a ball around it, relative to the eye
    float radius = 0;
};

// The terrain's nodes as they are drawn this frame, for layers that lie on it.
struct GroundMesh {
    GLuint mesh = 0;                  // vertex array: 17 x 17 corners, triangles as unsigned shorts
    int firstIndex = 0, indices = 0;  // of a node's triangles
    std::span<const TerrainNode> nodes;
};
// Draws nodes of the mesh, at most NODES_PER_DRAW a call, through a buffer of that many. Returns the number of calls.
size_t drawNodes(const GroundMesh& mesh, std::span<const TerrainNode> nodes, const Buffer& room);

struct FieldState;  // grass/field.h
struct Force;       // world/forces.h
// The map around the eye in which forces add up, for passes that draw into it (grass/forces).
struct ForceTarget {
    GLuint framebuffer = 0;
    int side = 0;                   // texels
    std::span<const Force> forces;  // those that reach into it
};

// What effects hand to effects that run later. Domains never include each other: what is of a domain's own is opaque
// here.
struct SharedResources {
    GroundMesh groundMesh;
    FieldState* grass = nullptr;
    Ground ground;  // the terrain; null without one
    HeightBounds bounds;
    GLuint heights = 0;  // the height map's texture; 0: flat
    GLuint cover = 0;    // uniform buffer of CoverGlobals
    std::array<GLuint, MAX_SPECIES> densities{};
    GLuint orientation = 0, vegetation = 0, occlusion = 0, forces = 0, bladeHeights = 0;
    std::vector<ShadowCaster> casters;  // of this frame
    uint64_t castersHash = 0;           // equal: the same triangles at the same places
    std::array<BladeDraws, MAX_SPECIES> blades{};
    std::array<BladeShade, MAX_SPECIES> shades{};
    ForceTarget forceTarget;
    GLuint reflection = 0;         // what the water mirrors; 0: nothing
    glm::vec2 reflectionScale{0};  // of its texture coordinates, a clip unit
    LightsGlobals lights{};        // beside the sun, as bound to UBO_LIGHTS
};

// A view within a view, such as what water mirrors: drawn from stage Reflect, before anything of the view that shows
// it.
struct ViewTargets;
struct ViewRequest {
    unsigned view = 0;  // ViewBits
    ViewCamera camera;
    glm::mat4 viewProj{1};  // from positions relative to the camera's eye to clip
    float cutAt = 0;        // height relative to that eye, below which nothing is drawn
    ViewSettings settings;
    ViewTargets* targets = nullptr;  // drawn into, and resolved
};

inline constexpr GLuint kStencilGround = 0x80;  // the stencil's bit that says where the ground is seen

// The targets of one view.
struct ViewTargets {
    Texture color, depth, resolved,
        image;  // RGBA16F and D32F of all samples; RGBA16F; RGBA8. One sample: no color, drawn into resolved
    Framebuffer scene, resolve, final;
    int width = 0, height = 0, samples = 0;
    bool stencil = false;  // whether depth has one: D32F_S8
};
// What targets are to be made.
struct TargetsWanted {
    int width = 0, height = 0, samples = 1;  // pixels, at least 1; samples a pixel, at most Gpu::maxSamples
    bool stencil = false;                    // beside the depth
    int levels = 1;                          // of what is resolved; 0: all
    bool image = false;                      // whether there is one to show on a screen
};
// Empty targets; `owner` ("domain/stem") is charged for their bytes.
ViewTargets makeTargets(Gpu& gpu, const std::string& owner, const TargetsWanted& wanted);
// The line that says to lib/scene_depth.glsl which of the two forms depth has; both, for ProgramRow.
std::string depthConstants(const ViewTargets& t);
std::vector<std::string> depthVariants();

struct DrawContext {
    Gpu& gpu;
    const Project& project;
    const Tables& tables;
    const FramePlan& plan;
    const ViewCamera& camera;
    const ViewSettings& settings;
    Programs& programs;
    MapTextures& maps;
    SharedResources& shared;
    ViewTargets& targets;
    FrameGlobals& globals;  // systems may write; uploaded before the first pass
    FrameStats& stats;
    Frustum frustum;
    glm::dvec3 around{0};  // in the world: what is made around the eye once for all views is made around this
    std::function<void(const ViewRequest&)> view = {};  // draws one; in stage Reflect only
    glm::dvec3 eye{0};             // relative to the terrain's corner, or to the world without a terrain
    EffectState* state = nullptr;  // of the effect whose pass or system runs
    PassStats* pass = nullptr;     // of the pass that runs
    const Pass* row = nullptr;

    // The state that the running effect's makeState made; S must be its type.
    template <class S>
    S& own() {
        return *static_cast<S*>(state);
    }
    // The pass's program number i for this scene's features, made current. False (and reported) if it does not compile.
    // `constants`: more lines for its sources, such as "const int TRANSPARENCY = 0;\n".
    bool use(size_t program = 0, const std::string& constants = {});
    std::string error = {};  // the first program that failed
};

}  // namespace sward
