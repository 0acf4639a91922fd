// Cells that rays ask for often have their blades posed once for all threads.
#include "reference/posed_cells.h"

#include <gtest/gtest.h>

#include "fields.h"
#include "objects.h"
#include "reference/ray_field.h"
#include "support.h"

namespace sward::test {
namespace {

struct Field {
    Project p;
    std::vector<std::unique_ptr<RayField>> fields;
    GrassMemory memory;

    Field() {
        Terrain t;
        t.size = {4, 4};
        put(p, "ground", t);
        FlatField f;
        f.cellSize = 1;
        f.species[0].bladesPerM2 = 3000;
        put(p, "grass", f);
        auto made = makeRayFields(p, 0, JobControl());
        if (made) fields = std::move(*made);
    }
    const RayField& field() const { return *fields.at(0); }
    // How many rays ask before the cell is there; 0: it is not after `most`.
    uint32_t raysUntilPosed(GrassMemory& of, int x, int z, uint32_t most) const {
        for (uint32_t n = 1; n <= most; ++n)
            if (posedCell(field(), 0, cellAt(field(), *of.tables, 0, x, z), x, z)) return n;
        return 0;
    }
};

TEST(PosedCells, AreMadeOnceTheyAreWorthIt) {
    Field f;
    ASSERT_EQ(f.fields.size(), 1u);
    const uint32_t first = f.raysUntilPosed(f.memory, 1, 2, 3000);
    EXPECT_GT(first, 32u) << "one that few rays ask for costs nothing";
    EXPECT_LE(first, 3000u / 8);
    GrassMemory another;
    const uint32_t second = f.raysUntilPosed(another, 1, 2, 3000);
    EXPECT_LT(second, first) << "another thread finds it";
    EXPECT_GT(second, 0u);
    EXPECT_EQ(f.field().kinds[0]->posed.cells.size(), 1u);
}

TEST(PosedCells, HoldEachBladeAsItStands) {
    Field f;
    ASSERT_GT(f.raysUntilPosed(f.memory, 2, 1, 3000), 0u);
    const Cell& cell = cellAt(f.field(), *f.memory.tables, 0, 2, 1);
    ASSERT_TRUE(cell.posed);
    EXPECT_NEAR(static_cast<double>(cell.posed->blades.size()), 3000, 200);
    for (const PosedBlade& b : cell.posed->blades) {
        const Posed own = poseBladeAt(f.field(), *f.field().kinds[0], cell, 2, 1, b.index);
        ASSERT_EQ(own.root, b.root);
        ASSERT_EQ(own.tip, b.tip);
        ASSERT_EQ(own.width, b.width);
    }
    EXPECT_EQ(numberOf(*cell.posed, 0), cell.posed->blades[0].index);
}

TEST(PosedCells, AreNoMoreThanTheirBudget) {
    Field f;
    *f.field().posedBytes = kPosedBytes - 1000;
    EXPECT_EQ(f.raysUntilPosed(f.memory, 1, 1, 5000), 0u);
    EXPECT_TRUE(f.field().kinds[0]->posed.cells.empty());
    *f.field().posedBytes = 0;
    EXPECT_GT(f.raysUntilPosed(f.memory, 1, 1, 5000), 0u);
    const size_t each = f.field().posedBytes->load();
    EXPECT_GT(each, 3000 * sizeof(PosedBlade) / 2);
    EXPECT_LT(each, 3000 * 300u);
}

}  // namespace
}  // namespace sward::test
