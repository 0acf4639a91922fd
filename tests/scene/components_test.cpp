// The tables: every field round-trips through a project file, and has sound ranges and defaults.
#include "scene/components.h"

#include <gtest/gtest.h>

#include <set>

#include "core/json.h"
#include "project/project_files.h"
#include "scene/map_layers.h"
#include "scene/project.h"
#include "tests/maps/images.h"
#include "tests/rows.h"
#include "tests/support.h"

using namespace sward;
using namespace sward::test;

namespace {
void* at(void* base, const FieldRow& row) { return static_cast<std::byte*>(base) + row.offset; }

template <class F>
void eachField(std::span<const FieldRow> fields, const std::string& path, void* base, F&& f) {
    for (const FieldRow& row : fields) {
        f(row, path + "." + row.name, at(base, row));
        if (row.type != FieldType::List) continue;
        for (size_t i = 0; i < row.list->size(at(base, row)); ++i)
            eachField(row.list->fields, path + "." + row.name + "[" + std::to_string(i) + "]",
                      row.list->editAt(at(base, row), i), f);
    }
}
template <class F>
void eachField(F&& f) {
    for (const ComponentRow& row : rows()) {
        const auto component = row.clone(row.defaults());
        eachField(row.fields, row.name, component.get(), f);
    }
}

// A value that no default has and that the table allows; different at every call.
double valueFor(const FieldRow& row, int n) {
    const double low = std::max(row.hardMin, row.softMin), high = std::min(row.hardMax, row.softMax);
    return low + (high - low) * (0.211 + 0.017 * (n % 30));
}
void fill(const FieldRow& row, void* value, int n) {
    const double v = valueFor(row, n);
    switch (row.type) {
        case FieldType::Bool:
            *static_cast<bool*>(value) ^= true;
            break;
        case FieldType::Int:
            *static_cast<int*>(value) = int(v);
            break;
        case FieldType::Float:
            *static_cast<float*>(value) = float(v);
            break;
        case FieldType::Vec2:
            *static_cast<glm::dvec2*>(value) = {v, v * 0.999};
            break;
        case FieldType::Vec3:
            *static_cast<glm::dvec3*>(value) = {v, v * 0.999, v * 0.998};
            break;
        case FieldType::Color:
            *static_cast<glm::vec3*>(value) = {v, v * 0.999, v * 0.998};
            break;
        case FieldType::String:
            if (!row.isFile) *static_cast<std::string*>(value) = fmt::format("name \"{}\" \u00e4\n", n);
            break;
        case FieldType::Name:
            *static_cast<std::string*>(value) = row.options.back();
            break;
        case FieldType::Enum:
            setEnumIndex(value, static_cast<int>(row.options.size()) - 1);
            break;
        case FieldType::Map: {
            auto& field = *static_cast<MapField*>(value);
            field.map = patternMap({5 + n % 7, 4, row.map->channels, row.map->type});
            field.file = fmt::format("maps/{}.{}", n, row.map->type == PixelType::F32 ? "exr" : "png");
            break;
        }
        case FieldType::List:
            break;
    }
}
std::string textOf(const FieldRow& row, void* value) {
    const std::string text = fieldText({value, &row, nullptr, "", ""});
    if (row.type != FieldType::Map) return text;
    return text + " " + std::to_string(static_cast<const MapField*>(value)->map.hash());
}
std::map<std::string, std::string> allTexts(Project& p) {
    std::map<std::string, std::string> out;
    for (const auto& [name, entity] : p.entities)
        for (const ComponentRow& row : rows())
            if (void* component = row.edit(p.registry, entity))
                eachField(
                    row.fields, name + "." + row.name, component,
                    [&](const FieldRow& f, const std::string& path, void* value) { out[path] = textOf(f, value); });
    return out;
}
}  // namespace

TEST(Components, EveryFieldHasHelpAndSoundRangesAroundItsDefault) {
    std::set<std::string> names;
    for (const ComponentRow& row : rows()) EXPECT_TRUE(names.insert(row.name).second && row.help[0]) << row.name;
    eachField([](const FieldRow& f, const std::string& path, void* value) {
        EXPECT_GT(std::string_view(f.help).size(), 8u) << path;
        EXPECT_NE(f.unit, nullptr) << path;
        if (f.type == FieldType::Enum) {
            EXPECT_LT(static_cast<size_t>(enumIndex(value)), f.options.size()) << path;
        }
        if (f.type == FieldType::List) {
            EXPECT_NE(f.list, nullptr) << path;
        }
        if (f.type == FieldType::Map) {
            ASSERT_NE(f.map, nullptr) << path;
            constexpr int kChannels[] = {1, 2, 4, 4, 1};
            EXPECT_EQ(f.map->channels, kChannels[static_cast<size_t>(f.map->kind)]) << path;
            EXPECT_FALSE(f.map->kind == MapKind::Heights && f.map->type == PixelType::U8) << path;
            EXPECT_GT(f.map->texelsPerMetre, 0) << path;
        }
        if (f.type > FieldType::Color || f.type == FieldType::Bool) return;
        EXPECT_LT(f.hardMin, f.hardMax) << path;
        EXPECT_TRUE(f.hardMin <= f.softMin && f.softMin < f.softMax && f.softMax <= f.hardMax) << path;
        EXPECT_TRUE(setFieldText({value, &f, nullptr, "", path}, textOf(f, value)))
            << path << ": its default is refused";
    });
}

TEST(Components, EveryFieldReadsBackFromItsText) {
    int n = 0;
    eachField([&](const FieldRow& f, const std::string& path, void* value) {
        if (f.type == FieldType::Map || f.type == FieldType::List || f.isFile) return;
        fill(f, value, ++n);
        const std::string text = textOf(f, value);
        fill(f, value, n + 1);
        const Status set = setFieldText({value, &f, nullptr, "", path}, text);
        EXPECT_TRUE(set) << path << (set ? "" : set.error().text());
        EXPECT_EQ(textOf(f, value), text) << path;
    });
    EXPECT_GT(n, 40);
}

TEST(Components, EveryFieldOutsideItsRangeIsRefusedAndKeepsItsValue) {
    eachField([](const FieldRow& f, const std::string& path, void* value) {
        if (f.type != FieldType::Float && f.type != FieldType::Int) return;
        const std::string before = textOf(f, value);
        for (const std::string& text : {shortestText(f.hardMin - 1), shortestText(f.hardMax * 2 + 1),
                                        std::string("nan"), std::string("-inf"), std::string("x"), std::string("")}) {
            const Status set = setFieldText({value, &f, nullptr, "", path}, text);
            ASSERT_FALSE(set) << path << " " << text;
            EXPECT_EQ(set.error().code, ExitCode::Usage);
            EXPECT_NE(set.error().remedy.find(shortestText(f.hardMax)), std::string::npos) << "the range is named";
        }
        EXPECT_EQ(bool(setFieldText({value, &f, nullptr, "", path}, "inf")), f.allowInf) << path;
        if (!f.allowInf) {
            EXPECT_EQ(textOf(f, value), before);
        }
    });
}

TEST(Components, EveryFieldOfEveryComponentRoundTripsThroughAProjectFile) {
    TempDir dir;
    Project p;
    p.dir = dir / "p";
    p.name = "all \"fields\"";
    int n = 0;
    for (const ComponentRow& row : rows()) {
        const Entity e = *addEntity(p, std::string("e-") + row.name);
        row.assign(p.registry, e, nullptr);
        void* component = row.edit(p.registry, e);
        if (row.name == std::string("GrassField")) static_cast<GrassField*>(component)->species.resize(3);
        if (isRowOf<MapLayers>(row)) {
            static_cast<MapLayers*>(component)->layers.resize(2);
            static_cast<MapLayers*>(component)->layers[1].masks.resize(2);
        }
        eachField(row.fields, row.name, component,
                  [&](const FieldRow& f, const std::string&, void* value) { fill(f, value, ++n); });
        repairComponent(row, component);
    }
    const auto written = saveProject(p, rows());
    ASSERT_TRUE(written) << written.error().text();
    const std::string text = readText(dir / "p/project.json");
    LoadReport report;
    Result<Project> again = loadProject(dir / "p", rows(), &report);
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_TRUE(report.repaired.empty());
    EXPECT_EQ(again->name, p.name);
    EXPECT_EQ(allTexts(*again), allTexts(p));
    EXPECT_TRUE(saveProject(*again, rows())->empty());
    std::filesystem::remove(dir / "p/project.json");
    ASSERT_TRUE(saveProject(*again, rows()));
    EXPECT_EQ(readText(dir / "p/project.json"), text) << "byte for byte";
}
