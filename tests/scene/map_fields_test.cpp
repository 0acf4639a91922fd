#include "scene/map_fields.h"
#include "tests/rows.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sward {
namespace {

// Calls f with each map's row and the table in which it stands, and that of the component that holds both.
template <class F>
void eachMapRow(F&& f) {
    for (const ComponentRow& row : rows()) {
        for (const FieldRow& field : row.fields) {
            if (field.type == FieldType::Map) f(row, row.fields, field);
            if (!field.list) continue;
            for (const FieldRow& inner : field.list->fields)
                if (inner.type == FieldType::Map) f(row, field.list->fields, inner);
        }
    }
}
bool stands(std::span<const FieldRow> table, const FieldRow& row, FieldType type) {
    return std::any_of(table.begin(), table.end(), [&](const FieldRow& f) {
        return f.offset == row.offset && f.type == type && std::string_view(f.name) == row.name;
    });
}

Project meadow() {
    Project p;
    p.registry.add<Terrain>(*addEntity(p, "ground"))->heightTiling = 3;
    GrassField field;
    field.species.resize(2);
    field.species[0].name = "lawn";
    field.species[1].name = "weeds";
    field.species[1].densityTiling = 5;
    field.species[1].bladesPerM2 = 77;
    field.orientationTiling = 7;
    p.registry.add<GrassField>(*addEntity(p, "meadow"), std::move(field));
    return p;
}

}  // namespace

TEST(MapFields, WhatAMapsRowNamesStandsBesideTheMap) {
    size_t maps = 0;
    eachMapRow([&](const ComponentRow& owner, std::span<const FieldRow> table, const FieldRow& field) {
        ++maps;
        const MapRow& m = *field.map;
        SCOPED_TRACE(std::string(owner.name) + "." + field.name);
        EXPECT_TRUE(!m.tiling || stands(table, *m.tiling, FieldType::Float));
        EXPECT_TRUE(!m.heightRange || stands(table, *m.heightRange, FieldType::Vec2));
        EXPECT_TRUE(!m.bladesPerM2 || stands(table, *m.bladesPerM2, FieldType::Float));
        EXPECT_TRUE(!m.packedWith || stands(owner.fields, *m.packedWith, FieldType::Map));
        EXPECT_EQ(m.heightRange != nullptr, m.kind == MapKind::Heights);
        EXPECT_TRUE(!m.bladesPerM2 || m.role == MapRole::Density);
    });
    EXPECT_GE(maps, 10u);
}

TEST(MapFields, AreFoundInTheMapsOwnListElement) {
    Project p = meadow();
    const Result<FieldRef> density = findField(p, rows(), "meadow.GrassField.species[weeds].density");
    ASSERT_TRUE(density);
    const FieldRef blades = fieldBeside(*density, *density->row->map->bladesPerM2);
    EXPECT_EQ(blades.path, "meadow.GrassField.species[weeds].bladesPerM2");
    EXPECT_EQ(fieldText(blades), "77");
    ASSERT_TRUE(setFieldText(blades, "12"));
    EXPECT_EQ(fieldText(*findField(p, rows(), blades.path)), "12") << "the field itself, not another's";
    EXPECT_EQ(mapTiling(*density), 5);
    EXPECT_EQ(mapTiling(*findField(p, rows(), "meadow.GrassField.species[lawn].density")), 1);
}

TEST(MapFields, TilingsAreOfTheComponentOrNone) {
    Project p = meadow();
    EXPECT_EQ(mapTiling(*findField(p, rows(), "ground.Terrain.height")), 3);
    EXPECT_EQ(mapTiling(*findField(p, rows(), "ground.Terrain.terrainMap")), 1);
    EXPECT_EQ(mapTiling(*findField(p, rows(), "meadow.GrassField.orientation")), 7);
    p.registry.add<Wind>(*addEntity(p, "wind"));
    EXPECT_EQ(mapTiling(*findField(p, rows(), "wind.Wind.gusts")), 1) << "it lies over gusts, not over the terrain";
}

TEST(MapFields, HeightsAreNeverReadFromEightBits) {
    eachMapRow([](const ComponentRow&, std::span<const FieldRow>, const FieldRow& field) {
        EXPECT_EQ(mapWish(field).isHeight, field.map->kind == MapKind::Heights) << field.name;
        EXPECT_EQ(mapWish(field).channels, field.map->channels) << field.name;
    });
}

}  // namespace sward
