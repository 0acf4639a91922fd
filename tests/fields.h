// A field of grass with the settings of every technique beside it, each within reach by its name.
#pragma once
#include <memory>
#include <string>

#include "grass/cells.h"
#include "grass/drawing.h"
#include "grass/hybrid.h"
#include "grass/raytraced_settings.h"
#include "grass/slice_settings.h"
#include "grass/tessellated_settings.h"
#include "scene/project.h"
#include "techniques.h"

namespace sward::test {

// The techniques that are built in.
enum class Technique { Hybrid, Geometry, Slices, Flat, Tessellated, Raytraced };
inline constexpr const char* kTechniqueNames[] = {"hybrid", "geometry", "slices", "flat", "tessellated", "raytraced"};
inline const char* nameOf(Technique t) { return kTechniqueNames[static_cast<int>(t)]; }

// The component of an entity, added where it has none.
template <class C>
C& having(Registry& registry, Entity e) {
    C* own = registry.get<C>(e);
    return own ? *own : *registry.add<C>(e, C{});
}

// Members of a field's components: of an entity, which must outlive them, as must every other's getting no such
// component; or of a field that is in no project yet.
struct FlatField {
    std::shared_ptr<Registry> alone;  // where a field is that is in no project
    Registry& registry;
    Entity entity;
    GrassField& grows;
    HybridTiers& hybrid;
    GrassSlices& sliced;
    GrassDrawing& drawing;
    TessellatedBlades& tessellated;
    RaytracedGrass& raytraced;
    FarLook& far;

    FlatField(Registry& r, Entity e)
        : registry(r),
          entity(e),
          grows(having<GrassField>(r, e)),
          hybrid(having<HybridTiers>(r, e)),
          sliced(having<GrassSlices>(r, e)),
          drawing(having<GrassDrawing>(r, e)),
          tessellated(having<TessellatedBlades>(r, e)),
          raytraced(having<RaytracedGrass>(r, e)),
          far(having<FarLook>(r, e)) {}
    FlatField() : FlatField(std::make_shared<Registry>()) {}
    explicit FlatField(std::shared_ptr<Registry> r) : FlatField(*r, r->create()) { alone = std::move(r); }
    FieldEntity asField() const { return {registry, entity, grows}; }

    std::string& technique = grows.technique;
    std::vector<Species>& species = grows.species;
    float& cellSize = grows.cellSize;
    int& seed = grows.seed;
    MapField &orientation = grows.orientation, &vegetation = grows.vegetation, &forces = grows.forces,
             &ambientOcclusion = grows.ambientOcclusion, &bladeHeight = grows.bladeHeight;
    float &orientationTiling = grows.orientationTiling, &vegetationTiling = grows.vegetationTiling,
          &ambientOcclusionTiling = grows.ambientOcclusionTiling, &forcesTiling = grows.forcesTiling,
          &bladeHeightTiling = grows.bladeHeightTiling;
    Population& population = grows.population;

    float &minGeom = hybrid.minGeom, &maxGeom = hybrid.maxGeom, &minBTF = hybrid.minBTF, &maxBTF = hybrid.maxBTF;

    int &slices = sliced.slices, &sliceWidth = sliced.sliceWidth, &sliceHeight = sliced.sliceHeight,
        &farSize = sliced.farSize;
    float &farHeight = sliced.farHeight, &sharpness = sliced.sharpness;
    Storage& storage = sliced.storage;
    SliceCover& sliceCover = sliced.sliceCover;
    LightWeighting& lightWeights = sliced.lightWeights;
    WeightsAt& weightsAt = sliced.weightsAt;
    Filtering& filtering = sliced.filtering;

    Transparency& transparency = drawing.transparency;
    Culling& culling = drawing.culling;
    float& fade = drawing.fade;
    int& shadowMask = drawing.shadowMask;
    bool& groundShadows = drawing.groundShadows;

    float &maxDistance = tessellated.maxDistance, &pixelsPerQuad = tessellated.pixelsPerQuad,
          &thinning = tessellated.thinning, &leastPixels = tessellated.leastPixels, &lowerFrom = tessellated.lowerFrom;
    LevelBy& levelBy = tessellated.levelBy;
    bool& widening = tessellated.widening;
    Beyond& beyond = tessellated.beyond;
    Tessellation& tessellation = tessellated.tessellation;

    FarBlur& farBlur = far.farBlur;
    float &farBlurDistance = far.farBlurDistance, &farDarkening = far.farDarkening,
          &farDarkeningDistance = far.farDarkeningDistance;
};

// Pixels of a metre at one metre's distance: 768 of them over 60 degrees.
inline constexpr float kPixelsPerMetre = 665;

// What a cell query is of: a field's first species.
inline QueryOf queryOf(const Terrain& terrain, const HeightBounds& bounds, const FlatField& field, const Patch& patch) {
    return {terrain,          bounds, field.grows,
            field.species[0], patch,  tiersOf(tables().techniques, field.asField(), kPixelsPerMetre).blades,
            field.fade};
}

// The field of an entity named so, which is there.
inline FlatField flatField(Project& p, const std::string& entity = "grass") {
    return {p.registry, findEntity(p, entity)};
}

// Gives an entity, made if it is not there, all that `field` has.
inline FlatField put(Project& p, const std::string& entity, const FlatField& field) {
    Entity e = findEntity(p, entity);
    if (e == kNoEntity) e = *addEntity(p, entity);
    p.registry.add(e, GrassField(field.grows));
    p.registry.add(e, HybridTiers(field.hybrid));
    p.registry.add(e, GrassSlices(field.sliced));
    p.registry.add(e, GrassDrawing(field.drawing));
    p.registry.add(e, TessellatedBlades(field.tessellated));
    p.registry.add(e, RaytracedGrass(field.raytraced));
    p.registry.add(e, FarLook(field.far));
    return {p.registry, e};
}

}  // namespace sward::test
