#include "techniques.h"

#include "grass/drawing.h"
#include "grass/grass_fields.h"
#include "grass/hybrid.h"
#include "grass/mesh_grass_settings.h"
#include "grass/raytraced_settings.h"
#include "grass/slice_settings.h"
#include "grass/tessellated_settings.h"
#include "scene/accepted_picture.h"
#include "scene/antialias.h"
#include "scene/components.h"
#include "scene/forest.h"
#include "scene/ground_path.h"
#include "scene/in_folder.h"
#include "scene/locked.h"
#include "scene/map_layers.h"
#include "scene/scatter.h"
#include "scene/technique.h"

namespace sward {
namespace {

// All rows, and what they refer to. GrassField's field `technique` takes the names of the techniques that are there.
struct Store {
    std::vector<TechniqueRow> techniques;
    std::vector<const char*> names;
    std::vector<FieldRow> grassFields;
    std::vector<ComponentRow> components;
    Tables all;

    Store() {
        for (const TechniqueRow& row : hybridTechniques()) techniques.push_back(row);
        techniques.push_back(tessellatedTechnique());
        techniques.push_back(raytracedTechnique());
        describe();
    }
    void describe() {
        names.clear();
        for (const TechniqueRow& row : techniques) names.push_back(row.name);
        const std::span<const ComponentRow> shared = sharedComponentRows();
        components.assign(shared.begin(), shared.end());
        for (const ComponentRow& row :
             {grassFieldRow(names, grassFields), hybridTiersRow(), grassSlicesRow(), tessellatedBladesRow(),
              raytracedGrassRow(), grassDrawingRow(), farLookRow(), meshGrassRow(), groundPathRow(), mapLayersRow(),
              scatterRow(), forestRow(), lockedRow(), inFolderRow(), acceptedPictureRow(), antialiasRow()})
            components.push_back(row);
        all = {components, effectRows(), techniques};
    }
};
Store& store() {
    static Store rows;
    return rows;
}

}  // namespace

const Tables& tables() { return store().all; }

AddedTechnique::AddedTechnique(const TechniqueRow& row) {
    store().techniques.push_back(row);
    store().describe();
}
AddedTechnique::~AddedTechnique() {
    store().techniques.pop_back();
    store().describe();
}

}  // namespace sward
