// What another program saved in the open project's folder is asked about, and either side can be kept.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

class Other {
  public:
    Other(const std::filesystem::path& dir, const char* entity) : doc_(tables()) {
        EXPECT_TRUE(doc_.open(dir));
        EXPECT_TRUE(doc_.addEntity(entity));
        EXPECT_TRUE(doc_.save());
    }

  private:
    Document doc_;
};

TEST_F(EditorUi, WhatAnotherSavedIsTakenOrReplacedAsThePersonSays) {
    const auto has = [&](const char* entity) { return findEntity(doc.project(), entity) != kNoEntity; };
    ok(doc.addEntity("mine"));
    Other(dir / "meadow", "theirs");
    ok(ui->key("ctrl+s"));
    EXPECT_TRUE(doc.dirty()) << "it asks first";
    ok(ui->click("Outside/Cancel"));
    ok(ui->key("ctrl+s"));
    ok(ui->click("Outside/Take theirs"));
    EXPECT_TRUE(has("theirs"));
    EXPECT_FALSE(has("mine"));
    ok(ui->key("ctrl+z"));
    EXPECT_TRUE(has("mine"));
    Other(dir / "meadow", "again");
    ok(ui->key("ctrl+s"));
    ok(ui->click("Outside/Save mine over it"));
    EXPECT_FALSE(doc.dirty());
    EXPECT_FALSE(ui->exists("Outside/Cancel"));
}

}  // namespace
}  // namespace sward
