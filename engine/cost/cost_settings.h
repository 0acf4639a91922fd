// What a sweep tries: techniques, and for each a list of settings as PATH=VALUE. One table, so that a new technique is
// one row. Does not: draw or measure (cost.h).
#pragma once
#include <string>
#include <vector>

#include "frame/renderer.h"
#include "scene/project.h"

namespace sward {

// Values by name: of a field of GrassField ("maxGeom=6"), or of the view ("msaa=1", "detail=0.5").
struct CostSetting {
    std::string technique;  // a name of kTechniques
    std::vector<std::string> values;
    std::string text() const;  // "maxGeom=6 msaa=4"; "as it is" without values
};

struct CostTechnique {
    const char* name;
    // Adds settings to try around a field's own.
    void (*add)(const GrassField& own, std::vector<CostSetting>& out);
};
// The table: one row a technique, each name as in kTechniques.
std::span<const CostTechnique> costTechniques();

// All settings for a project's grass (the first field by name), some 40, in the table's order; of one technique if it
// is named. Usage error: no such technique. Unsound: the project has no grass.
Result<std::vector<CostSetting>> costSettings(const Project& project, const std::string& technique = {});
// Whether `a` draws all that `b` draws and perhaps more: no distance, share of detail or number of samples is smaller,
// all else is equal.
bool drawsNoLess(const CostSetting& a, const CostSetting& b);
// Makes it the project's (each field of grass) and the view's. Usage error: a name or value that does not exist.
Status applySetting(Project& project, const Tables& tables, const CostSetting& setting, ViewSettings& view);

}  // namespace sward
