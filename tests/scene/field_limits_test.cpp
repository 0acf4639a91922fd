// Limits of fields of grass: what is within them passes, one more is refused with its place and the number.
#include "scene/field_limits.h"

#include <gtest/gtest.h>

#include "fields.h"
#include "scenes.h"

namespace sward::test {
namespace {

Project fieldsOfSpecies(size_t fields, size_t species) {
    Project p = lawn();
    removeEntity(p, "grass");
    for (size_t i = 0; i < fields; ++i) {
        GrassField f;
        f.species.assign(species, Species{});
        put(p, "field" + std::to_string(i), f);
    }
    return p;
}

TEST(FieldLimits, HoldSixteenSpeciesAndEightFields) {
    EXPECT_TRUE(checkFields(fieldsOfSpecies(1, 16)));
    EXPECT_TRUE(checkFields(fieldsOfSpecies(8, 8)));
    EXPECT_GE(kMaxSpecies, 16u);
    EXPECT_GE(kMaxFields, 2u);
}

TEST(FieldLimits, NameTheFieldAndTheNumberThatIsTooMuch) {
    const auto fault = [](const Project& p) {
        const auto f = brokenLimit(p);
        return f ? f->message : "none";
    };
    EXPECT_EQ(fault(fieldsOfSpecies(1, 17)), "field0.GrassField.species: 17 species; a field may have 16");
    EXPECT_EQ(fault(fieldsOfSpecies(9, 1)), "field8.GrassField: it is field 9; a scene may have 8");
    EXPECT_EQ(fault(fieldsOfSpecies(5, 16)),
              "field4.GrassField.species: with it fields have 80 species; a scene may have 64");
    Project p = fieldsOfSpecies(2, 11);
    for (const char* name : {"field0", "field1"})
        for (Species& s : p.registry.get<GrassField>(findEntity(p, name))->species)
            s.density = field(filled({2, 2, 1, PixelType::U8}, 1));
    EXPECT_NE(fault(p).find("field1.GrassField.species: with it fields have 22 density"), std::string::npos)
        << fault(p);
    EXPECT_EQ(checkFields(p).error().code, ExitCode::Unsound);
}

}  // namespace
}  // namespace sward::test
