// An editor without a window for tests: real widgets, real input queue, real renderer, on a new project.
// Does not: test anything itself.
#pragma once
#include <gtest/gtest.h>

#include "editor/app/app.h"
#include "editor/ui/driver.h"
#include "support.h"
#include "techniques.h"

namespace sward::test {

// One context and one new project for all tests; each test gets a fresh editor on it.
class EditorFixture : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        auto made = makeHeadlessGpu();
        ASSERT_TRUE(made) << made.error().text();
        gpu = made->release();
    }
    static void TearDownTestSuite() {
        delete gpu;
        gpu = nullptr;
    }
    void SetUp() override {
        ASSERT_NE(gpu, nullptr);
        ASSERT_TRUE(doc.create(dir / "meadow"));
        app = std::make_unique<EditorApp>(doc, *gpu, ui::makeHeadlessSurface(800, 600), false);
        ui = makeUiDriver(*app);
        ok(ui->wait(3));
    }
    void TearDown() override {
        EXPECT_EQ(gpu->errors, 0) << gpu->lastError;
        EXPECT_EQ(app->notice, "");
    }

    void ok(const Status& status) { EXPECT_TRUE(status) << status.error().text(); }
    std::string get(const std::string& label) {
        const Result<std::string> value = ui->get(label);
        return value ? *value : "error: " + value.error().text();
    }
    uint64_t density() {
        const Result<ConstFieldRef> map = findMap(doc.project(), doc.tables().components, "density");
        return map ? static_cast<const MapField*>(map->value)->map.hash() : 0;
    }
    std::string field(const std::string& path) {
        const Result<ConstFieldRef> f = findField(doc.project(), doc.tables().components, path);
        return f ? fieldText(*f) : "error: " + f.error().text();
    }
    // Across the lower middle of the viewport, where there is ground.
    void paint() {
        const Rect& r = app->viewport.rect;
        const double y = static_cast<double>(r.y) + static_cast<double>(r.h) * 0.8;
        ok(ui->drag(static_cast<double>(r.x + r.w * 0.3f), y, static_cast<double>(r.x + r.w * 0.6f), y));
    }

    static inline Gpu* gpu = nullptr;
    TempDir dir;
    Document doc{tables()};
    std::unique_ptr<EditorApp> app;
    std::unique_ptr<UiDriver> ui;
};

}  // namespace sward::test
