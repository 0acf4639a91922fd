// The components that more than one domain reads: plain structs with their defaults; no GL handles.
// Their field tables (names, units, ranges, help) stand in components.cpp; the ranges there are the ones enforced.
// Lengths in metres, angles in degrees, colours linear. y is up; the terrain covers x, z in [0, size].
#pragma once
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <vector>

#include "core/enum_names.h"
#include "maps/map.h"
#include "scene/rows.h"

namespace sward {

// The stable id of an entity, in files, paths, undo and messages. Unique within a project.
struct Name {
    std::string value;
};

// Moves what the entity holds; the terrain with it everything that stands on it.
struct Transform {
    glm::dvec3 position{0};
};

// The editor's viewport does not show what the entity has: what lies behind can be worked on. Pictures, playtests and
// the ray-traced truth do.
struct Hidden {};

// What is seen beyond the terrain: a plain in the haze; the ground as at its edges; or the ground as it comes, farther
// out, to the mean of the terrain (world/land.h). Maps that repeat go on repeating.
enum class LandBeyond { None, Extend, Fade };
inline constexpr auto kLandsBeyond = enumNames<LandBeyond>("none", "extend", "fade");

// The ground: heights, and how it is coloured.
// Source of the colour blend: Jahrmann and Wimmer 2013, equation 1.
struct Terrain {
    glm::dvec2 size{40, 40};
    MapField height;                // float maps in metres; integer maps span heightRange
    glm::dvec2 heightRange{0, 10};  // metres at 0 and at full scale of an integer height map
    float gridSpacing = 0.25f;      // metres between vertices of the finest level
    float lodDistance = 30;         // metres to which the finest level reaches; each next level doubles it
    MapField terrainMap;            // RGBA, colour (sRGB) and opacity over the ground texture
    float heightTiling = 1,
          terrainMapTiling = 1;  // repeats over mapSize; heights are mirrored from repeat to repeat (scene/tiling.h)
    float mapSize = 0;           // metres over which all maps' tilings count, both ways; 0: the whole terrain
    std::string groundTexture;   // PNG repeated over the ground; empty: soil made by the program
    float tileSize = 2;          // metres after which it repeats
    glm::vec3 groundColor{0.12f, 0.09f, 0.06f};  // mean reflectance of the made soil, or factor of the texture
    bool castShadows = false;                    // hills shade what lies behind them
    LandBeyond beyond = LandBeyond::None;
};

// One kind of blade. Shapes: scene/population.h.
struct Species {
    std::string name = "grass";
    MapField density;          // one channel; absent: 1 everywhere
    float densityTiling = 1;   // repeats over Terrain.mapSize
    float bladesPerM2 = 2000;  // at density 1
    float height = 0.08f;
    float heightVariation = 0.25f;  // share of the height, both ways
    float width = 0.004f;
    float bend = 0.5f;  // how far the tip droops, as a share of the length
    float leanDeg = 8;  // mean lean from the vertical towards the painted (or own) direction
    float leanVariationDeg = 10;
    float stiffness = 1;  // against the wind alone: 2 leans and quivers half as far (world/wind.h, windStrength)
    int segments = 3;     // quads a blade
    int smoothness = 5;   // quads a blade has at most where it is tessellated
    std::string texture;  // PNG with alpha; empty: made by the program
    glm::vec3 rootColor{0.045f, 0.065f, 0.02f};
    glm::vec3 midColor{0.055f, 0.125f, 0.03f};
    glm::vec3 tipColor{0.085f, 0.155f, 0.045f};
    float hueVariationDeg = 4;
    float lightnessVariation = 0.15f;
    float rootOcclusion = 0.25f;  // ambient light left at the root; 1 at the tip
    float clumpSize = 0.25f;      // metres; 0: no clumps
    float clumpStrength = 0.5f;   // share of lean, height and tint that a clump's blades have in common
    float translucency = 0;       // light that shines through, as a share of what is reflected; 0: none
    float gloss = 0;              // waxy highlight, as a factor of a leaf's (Fresnel 0.04); 0: none
    float roughness = 0.5f;       // of the highlight
};

// Which blades there are: one cell's, repeated in every cell; or each cell's own (scene/unique.h).
enum class Population { Patch, Unique };
inline constexpr auto kPopulations = enumNames<Population>("patch", "unique");

// Grass, over the whole terrain or on meshes alone: what grows, and the name of how it is drawn (scene/technique.h).
// The technique's settings are components beside it. Tilings are repeats over Terrain.mapSize.
struct GrassField {
    std::string technique = "hybrid";
    std::vector<Species> species{1};
    float cellSize = 0.5f;  // metres; the patch that is repeated covers one cell
    int seed = 1;
    MapField orientation;       // two channels: direction x, z in [0,1] about 0.5; its length is the strength
    MapField vegetation;        // RGBA: colour (sRGB) and opacity over the blades' own
    MapField forces;            // RGBA: push x, z about 0.5, press; times A
    MapField ambientOcclusion;  // one channel: share of the sky that the ground sees
    MapField bladeHeight;       // one channel: share of their height that blades have; absent: 1 (section 4.1.1, blue)
    float orientationTiling = 1, vegetationTiling = 1, ambientOcclusionTiling = 1, forcesTiling = 1,
          bladeHeightTiling = 1;
    Population population = Population::Patch;
    bool onTerrain = true;  // else it grows on meshes alone (grass/mesh_grass_settings.h)
};

// Against sparkling far away (Jahrmann and Wimmer 2013, section 6.4): a blur of 7 pixels whose weights are equal, or a
// bell's.
enum class FarBlur { None, Mean, Gaussian };
inline constexpr auto kFarBlurs = enumNames<FarBlur>("none", "mean", "gaussian");
// How a field far away is shown: beside a GrassField. The picture is blurred as the first field by name asks.
struct FarLook {
    FarBlur farBlur = FarBlur::None;
    float farBlurDistance = 80;       // metres at which the blur is full
    float farDarkening = 0;           // share of light that far grass loses; 0: none
    float farDarkeningDistance = 80;  // metres at which it has lost it
};

enum class LightType { Directional, Point };
inline constexpr auto kLightTypes = enumNames<LightType>("directional", "point");

// A light. The first directional one, in the order of names, is the sun: its strength and colour follow from its
// elevation and the sky's turbidity (sky/sky.h), times intensity and color. All others are lamps (sky/lamps.h):
// intensity 1 is 45 klx, half of a noon sun, at a point light's own place or from a directional light; so a point light
// of attenuation 1 gives 22 klx at one metre, which shows beside the sun at the exposure of day. Where lights are at a
// time: world/lights.h.
struct Light {
    LightType type = LightType::Directional;
    float azimuthDeg = 135;   // clockwise from -z (north); of a point light: where on its circle it starts
    float elevationDeg = 42;  // of a directional light
    float intensity = 1;      // factor
    glm::vec3 color{1};       // factor
    float attenuation = 1;    // beta of a point light, 1/m2: intensity / (1 + beta d^2)
    bool castShadows = true;
    float orbitRadius = 0;   // metres of the circle of a point light around its Transform's position
    float orbitSeconds = 0;  // for one turn, of a directional light's azimuth too; 0: it stands still
};

enum class SkyModel { Clear, Uniform, Atmosphere };
inline constexpr auto kSkyModels = enumNames<SkyModel>("clear", "uniform", "atmosphere");

// The sky: clear by Preetham, Shirley and Smits 1999; uniform, equally bright everywhere, as under clouds; or by the
// light that the atmosphere scatters (Hillaire 2020), which gives the sun's colour and the haze's, too.
struct Sky {
    SkyModel model = SkyModel::Clear;
    float turbidity = 3;
    float intensity = 1;  // factor
};

enum class WindModel { Waves, Noise };
inline constexpr auto kWindModels = enumNames<WindModel>("waves", "noise");

// Wind over the whole scene: the first by name that blows. Everything that grows leans with it (numerics/gust.h).
// Waves: Jahrmann and Wimmer 2013, equation 9, travelling at `speed`. Noise: a picture of gusts that the wind carries
// along.
struct Wind {
    WindModel model = WindModel::Noise;
    float strength = 0.3f;                   // lean of a full gust, metres a metre of blade of stiffness 1; 0: a calm
    float azimuthDeg = 70;                   // where it blows to, clockwise from -z (north)
    float speed = 4;                         // m/s, at which gusts and waves travel
    float gustSize = 8;                      // metres of a gust along the wind; across it twice as much
    float turbulence = 0.4f;                 // share of small gusts, and how much blades quiver
    float quiverHz = 3;                      // of a blade
    MapField gusts;                          // one channel; covers 8 gusts and repeats; absent: made by the program
    float c1 = 0.2f, c2 = 0.05f, c3 = 0.1f;  // of equation 9, 1/m; c1 and c3 in twentieths, so that waves have a period
    float epsilon = 0.5f;                    // of equation 9
};
inline constexpr float kStrongestWind = 2;

// A track that a source of force left: what it pressed between two places, in the world, and when (scene seconds).
struct Track {
    glm::dvec2 from{0}, to{0};
    double seconds = 0;
};
enum class ForceShape { Foot, Wheel, Object, Outline };
inline constexpr auto kForceShapes = enumNames<ForceShape>("foot", "wheel", "object", "outline");

// Presses the grass down where its Transform stands, and aside around it; what moves leaves tracks, which recover.
// Source: Jahrmann and Wimmer 2013, section 5.2; world/forces.h.
struct ForceSource {
    ForceShape shape = ForceShape::Object;
    float radius = 0.3f;   // metres pressed down; of a foot or wheel, half its width; of an outline, of its rim alone
    float length = 0.3f;   // metres of a foot, and of a wheel's tread on the ground
    float headingDeg = 0;  // where a foot or wheel points, clockwise from -z (north)
    float reach = 2;       // radii out to which blades are pushed aside; of an outline, one less, from its edge
    float strength = 1;    // share; 0: none
    float recovery = 20;   // seconds in which a track recovers; infinite: it stays
    std::vector<Track> tracks;  // left in playtest; never saved
};
inline constexpr const char* kOutlineOfNothing =
    "an outline is that of the entity's StaticMesh, and it has none with a file: add one, or choose another shape; it "
    "presses nothing";

// Haze: what is seen fades into the horizon's colour.
struct Fog {
    float visibility = 4000;  // metres at which contrast has fallen to 2% (Koschmieder)
};

// Water up to a level: it stands wherever the terrain lies lower, or only about a place: a scene has as many ponds as
// it likes, each with its own level. Formulas: numerics/water.h.
struct Water {
    float level = 0;                         // metres, in the terrain's heights
    float radius = 0;                        // metres about the Transform's x and z; 0: over the whole terrain
    float clarity = 2.5f;                    // metres over which what lies under water loses all but 2% of its contrast
    glm::vec3 color{0.014f, 0.03f, 0.026f};  // of deep water: share of the light from above that it sends back
    float ripples = 0.35f;    // slopes as a share of the open sea's in this wind; in a calm it lies still
    float rippleSize = 1.2f;  // metres of the longest ripples
    float reflection =
        0.5f;  // pixels of the mirrored view, as a share of the picture's, each way; 0: it mirrors the sky alone
};

// Flowers over the terrain, each a head on a stem that turns to the eye. Any number of entities may have some.
// Source: Jahrmann and Wimmer 2013 (flowers as instanced billboards). Formulas: numerics/flower.h.
struct Flowers {
    MapField density;                           // one channel; absent: 1 everywhere
    float densityTiling = 1;                    // repeats over Terrain.mapSize
    float flowersPerM2 = 3;                     // at density 1
    float height = 0.3f;                        // metres from the ground to the head
    float heightVariation = 0.3f;               // share of the height, both ways
    float headSize = 0.035f;                    // metres across
    glm::vec3 color{0.72f, 0.7f, 0.64f};        // of petals; of each flower's somewhere between this ...
    glm::vec3 secondColor{0.72f, 0.7f, 0.64f};  // ... and this
    glm::vec3 centerColor{0.55f, 0.34f, 0.02f};
    glm::vec3 stemColor{0.05f, 0.1f, 0.025f};
    std::string
        texture;  // PNG with alpha: its top square the head, what is below it the stem; empty: made by the program
    float maxDistance = 150;  // metres from which none is drawn
    int seed = 1;
};

// How light that comes from all around is found: by rules that know only the surface itself, or traced once, with what
// lies around.
enum class BakeLight { Local, Traced };
inline constexpr auto kBakeLights = enumNames<BakeLight>("local", "traced");

// An object standing where its Transform says: bench, stone, house. Files: mesh/mesh_io.h.
struct StaticMesh {
    std::string file;           // .glb or .gltf; empty: nothing to see
    glm::dvec3 rotationDeg{0};  // about x, then z, then y (heading, counter-clockwise from above)
    float scale = 1;
    bool onGround = true;  // the Transform's y counts from the ground below; else from the world's origin
    bool castShadows = true;
    BakeLight bakeLight = BakeLight::Traced;  // local: as on open level ground
};

// What rolls in a playtest: down slopes, and pushed by the walker and by others of its kind. A ball about the
// Transform's place (with a StaticMesh: about the mesh's origin). Out of play it stands still.
struct Rolling {
    float radius = 0.25f;
    float friction = 0.06f;  // of rolling: on a slope of less than about this it comes to rest
    float push = 0.6f;       // share of the walker's motion that it takes; 0: it stands like a wall
};

struct Camera {
    glm::dvec3 eye{2, 1.7, 2};
    glm::dvec3 target{20, 0, 20};
    float fovDeg = 55;   // vertical
    float exposure = 0;  // stops
};

// Where a camera is at a second of its way.
struct CameraKey {
    std::string name = "key";
    float seconds = 0;
    glm::dvec3 eye{2, 1.7, 2};
    glm::dvec3 target{20, 0, 20};
    float fovDeg = 55;
};
// A way that a camera takes, through its keys (world/camera_path.h): for films, and for what changes from picture to
// picture.
struct CameraPath {
    std::vector<CameraKey> keys;  // used in the order of their seconds
    float exposure = 0;           // stops
};

// The rows of the components above, but for those whose stems have them (GrassField, FarLook), in file order.
std::span<const ComponentRow> sharedComponentRows();

// The first directional light by name, whether it shines or not; kNoEntity if there is none.
Entity sunEntity(const Registry& registry);
// Whether a light gives any.
bool shines(const Light& light);

// The union of what all components ask for. coarse: in a view that needs no more, such as a mirror's.
FeatureSet sceneFeatures(const Registry& registry, const Tables& tables, bool coarse = false);
// Which entities ask for a feature; in the order of their names.
std::vector<std::string> entitiesWith(const Registry& registry, const Tables& tables, Feature f);

}  // namespace sward
