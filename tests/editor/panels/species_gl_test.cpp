// The species panel in the editor: presets are added, applied and copied by clicks.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, SpeciesAreAddedDressedAndCopiedFromPictures) {
    const auto field = [&]() -> const GrassField& {
        return *doc.project().registry.get<GrassField>(findEntity(doc.project(), "lawn"));
    };
    app->layout.tab = "Species";
    ok(ui->wait(2));
    EXPECT_TRUE(ui->exists("Species/Own/lawn"));
    const Thumbnail& picture = speciesThumbnail(app->thumbnails, field().species[0], doc.project().dir);
    EXPECT_NE(picture.texture.id(), 0u) << picture.error;
    ok(ui->click("Species/Presets/reed"));
    ok(ui->click("Species/Add as New"));
    ok(ui->wait(2));
    ASSERT_EQ(field().species.size(), 2u);
    EXPECT_EQ(field().species[1].name, "reed");
    EXPECT_EQ(app->brushes.map, "lawn.GrassField.species[reed].density") << "it is painted next";
    EXPECT_EQ(get("Species/Own/reed"), "true");
    ok(ui->click("Species/Own/lawn"));
    EXPECT_EQ(app->brushes.map, "lawn.GrassField.species[lawn].density");
    ok(ui->click("Species/Apply to Species"));
    EXPECT_EQ(field().species[0].height, field().species[1].height);
    ok(ui->click("Species/Duplicate"));
    ASSERT_EQ(field().species.size(), 3u);
    EXPECT_EQ(field().species[2].name, "lawn2");
}

}  // namespace
}  // namespace sward
