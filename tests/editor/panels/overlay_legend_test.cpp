#include "panels/overlay_legend.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

TEST(OverlayLegend, SaysOfEachMapWhatItsEndsMean) {
    std::map<std::string, std::string> said;
    const auto visit = [&](std::span<const FieldRow> fields, const auto& again) -> void {
        for (const FieldRow& f : fields) {
            if (f.type == FieldType::Map && f.map->kind == MapKind::Amounts)
                said[f.name] = fmt::format("{} {}", f.map->least, f.map->most);
            if (f.list) again(f.list->fields, again);
        }
    };
    for (const ComponentRow& row : sharedComponentRows()) visit(row.fields, visit);
    EXPECT_EQ(said["density"], "0 bare 1 full");
    EXPECT_EQ(said["ambientOcclusion"], "0 closed 1 open");
    EXPECT_EQ(said["bladeHeight"], "0 no height 1 full height");
    EXPECT_EQ(said["gusts"], "0 calm 1 gust");
    for (const auto& [name, ends] : said)
        EXPECT_TRUE(ends != "0 bare 1 full" || name == "density") << name << " needs words of its own";
}

}  // namespace
}  // namespace sward
