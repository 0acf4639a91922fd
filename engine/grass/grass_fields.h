// The row of GrassField, and what a field asks of the scene by all that it is: what grows, how it is drawn, and what is
// painted for it. Does not: draw.
#pragma once
#include <span>

#include "scene/technique.h"

namespace sward {

// `techniques`: the names that GrassField.technique may have; they must outlive the row. fields: room for the table,
// which must outlive it, too.
ComponentRow grassFieldRow(std::span<const char* const> techniques, std::vector<FieldRow>& fields);
// Features of one field, without those of the rest of the scene. coarse: in a view that needs no more, such as a
// mirror's (TechniqueRow::coarse), where blades shade no ground either. A field without blades asks for nothing.
FeatureSet fieldFeatures(std::span<const TechniqueRow> techniques, const FieldEntity& field, bool coarse = false);
// The table of a species.
const ListRow& speciesList();
// The field table of FarLook.
ComponentRow farLookRow();

}  // namespace sward
