// What a pass or system is handed: the project, the view, and the engine's shared services. No statics anywhere.
#pragma once
#include <glm/glm.hpp>

#include "frame/map_textures.h"
#include "frame/plan.h"
#include "frame/renderer.h"
#include "frame/soil.h"
#include "gpu/program.h"
#include "gpu/resources.h"
#include "shared/bindings.h"
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
// The volume that a view of this matrix (world to clip space) shows.
Frustum frustumOf(const glm::mat4& viewProj);

// Triangles that shade what lies behind them. The vertex array has positions at 0, texture coordinates at 2, and at 3
// to 5 the rows of a matrix to eye-relative positions, one an instance.
struct ShadowCaster {
    GLuint vertexArray = 0, instance = 0;  // the first of its instances
    uint32_t firstIndex = 0, indices = 0;  // of 32 bits
    GLuint image = 0;                      // what is cut out by its alpha below `cutoff`; 0: nothing
    float cutoff = 0;
    glm::vec3 centre{0};  // of a ball around all of them, relative to the eye
    float radius = 0;
    GLsizei instances = 1;
    bool behind = false;  // only what looks away from the light shades; triangles are counter-clockwise from outside
};

// The terrain's nodes as they are drawn this frame, for layers that lie on it.
struct GroundMesh {
    GLuint mesh = 0;                     // vertex array: 17 x 17 corners, triangles as unsigned shorts
    int firstIndex = 0, indices = 0;     // of a node's triangles
    std::span<const TerrainNode> nodes;  // of the terrain
    std::span<const TerrainNode> land;   // with those beyond it
};
// Draws nodes of the mesh, at most NODES_PER_DRAW a call, through a buffer of that many. Returns the number of calls.
size_t drawNodes(const GroundMesh& mesh, std::span<const TerrainNode> nodes, const Buffer& room);

struct GrownFields;   // grass/grown.h
struct GrassFields;   // grass/field.h
struct MaskState;     // grass/mask.h
struct TracedState;   // grass/traced.h
struct ForestsState;  // forest/stand.h
struct ObjectLight;   // frame/object_light.h
struct AirTables;     // sky/air_tables.h
struct Force;         // world/forces.h
// The map around the eye in which forces add up, for passes that draw into it (grass/forces).
struct ForceTarget {
    GLuint framebuffer = 0;
    int side = 0;                   // texels
    std::span<const Force> forces;  // those that reach into it
};

// A picture of what a water mirrors; no texture: it mirrors nothing.
struct Reflection {
    GLuint texture = 0;
    glm::vec2 scale{0}, at{0};  // of its texture coordinates: a clip unit of the view, and at the view's middle
};

// What effects hand to effects that run later (scene/slots.h). Domains never include each other: what is of a domain's
// own is opaque here. First what is the same for all views of a frame; it is kept from frame to frame.
struct SharedByViews {
    Ground ground;  // the terrain; null without one
    HeightBounds bounds;
    GLuint heights = 0;  // the height map's texture; 0: flat
    MaskState* masks = nullptr;
    const TracedState* traced = nullptr;
    GrownFields* grown = nullptr;
    ForestsState* forests = nullptr;
    const ObjectLight* objectLight = nullptr;
    const AirTables* air = nullptr;  // of the sky's model "atmosphere"
    glm::vec3 skyTilt{0};            // how much brighter the sky is towards the horizon (sky/daylight.h)
    ForceTarget forceTarget;
};
// And what each view has of its own; a frame begins with none of it.
struct SharedResources : SharedByViews {
    GroundMesh groundMesh;
    GrassFields* grass = nullptr;
    SoilGrowth soil;
    std::vector<ShadowCaster> casters;  // of this frame
    uint64_t castersHash = 0;           // equal: the same triangles at the same places; who appends adds its own to it
    glm::vec2 sampleShift{0};           // clip units by which the picture is moved in this frame, so that frames add up
    std::vector<Reflection> reflections;  // what each water mirrors, in the order of watersOf (world/water.h)
    LightsGlobals lights{};               // beside the sun, as bound to UBO_LIGHTS
    std::vector<glm::dvec3> lampPlaces;   // theirs in the world; of directional ones: unit vectors towards them
};

// What to draw of a view within the view (ViewRow).
struct ViewTargets;
struct ViewRequest {
    ViewCamera camera;
    glm::mat4 viewProj{1};  // from positions relative to the camera's eye to clip
    bool mirrored = false;  // left and right are exchanged
    float cutAt = 0;        // mirrored: height relative to that eye, below which nothing is drawn
    ViewSettings settings;
    ViewTargets* targets = nullptr;  // drawn into, and resolved
};

inline constexpr GLuint kStencilGround = 0x80;  // the stencil's bit that says where the ground is seen

// The targets of one view.
struct ViewTargets {
    Texture color, depth, resolved,
        image;       // RGBA16F and D32F of all samples; RGBA16F; RGBA8. One sample: no color, drawn into resolved
    Texture motion;  // RGBA16F, where frames add up (post/antialias.h): metres moved since the frame before
    Framebuffer scene, resolve, final;
    int width = 0, height = 0, samples = 0;
    bool stencil = false;  // whether depth has one: D32F_S8
};
// What targets are to be made.
struct TargetsWanted {
    int width = 0, height = 0, samples = 1;  // pixels, at least 1; samples a pixel, one of Gpu::sampleCounts
    bool stencil = false;                    // beside the depth
    int levels = 1;                          // of what is resolved; 0: all
    bool image = false;                      // whether there is one to show on a screen
    bool motion = false;                     // beside a colour of one sample
};
// Whether a view's pictures add up to what it shows (post/antialias.h): not one that is drawn in pieces, nor false
// colours.
bool framesAddUp(const FramePlan& plan, const ViewSettings& s);
// Empty targets; `owner` ("domain/stem") is charged for their bytes.
ViewTargets makeTargets(Gpu& gpu, const std::string& owner, const TargetsWanted& wanted);
// The line that says to lib/scene_depth.glsl which of the two forms depth has; both, for ProgramRow.
std::string depthConstants(const ViewTargets& t);
std::vector<std::string> depthVariants();

// What the scene's depth was: what is drawn into cannot be read.
struct DepthCopy {
    Texture texture;
    int samples = 0;  // of a texel
};

ProgramSources sourcesOf(const ProgramRow& row);

// Pictures that must be quick (detail below 1) of who may wait (background) begin with a sketch: grass is the
// horizontal slice from the eye on, and stages that such a picture can be without are left out. Their programs are
// compiled one a draw, so that somebody sees where he is after a few programs instead of all; what is drawn later is as
// ever.
struct Sketch {
    bool on = false;                   // in this draw
    int left = 0;                      // programs of such stages that this draw may still compile
    std::vector<std::string> waiting;  // and those that it left to later draws, by their names
};
// Whether a sketch of this plan can be without a stage.
bool sketchLeavesOut(Stage stage, const FramePlan& plan);

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
    glm::dvec3 around{0};          // in the world: what is made around the eye once for all views is made around this
    glm::dvec3 eye{0};             // relative to the terrain's corner, or to the world without a terrain
    EffectState* state = nullptr;  // of the effect whose pass or system runs,
    EffectState* seen = nullptr;   // and what it keeps for this view
    PassStats* pass = nullptr;     // of the pass that runs
    const Pass* row = nullptr;
    Sketch* sketch = nullptr;  // of the draw; never null within Renderer::draw

    // The state that the running effect's makeState made; S must be its type.
    template <class S>
    S& own() {
        return *static_cast<S*>(state);
    }
    template <class S>
    S& ofView() {
        return *static_cast<S*>(seen);
    }
    // The pass's program number i for this scene's features, made current. False (and reported) if it does not compile.
    // `constants`: more lines for its sources, such as "const int TRANSPARENCY = 0;\n". `features`: those
    // that it is compiled for, as featureConstants has them, where they are not the whole scene's.
    bool use(size_t program = 0, const std::string& constants = {}, const std::string* features = nullptr);
    bool sketching() const { return sketch && sketch->on; }
    std::string error = {};  // the first program that failed
};

// Copies the depth of what has been drawn so far, charged to `owner`, and binds it for lib/scene_depth.glsl.
void copyDepth(DrawContext& ctx, const std::string& owner, DepthCopy& copy);

}  // namespace sward
