// An editor without a window for tests: real widgets, real input queue, real renderer, on a new project.
// Does not: test anything itself.
#pragma once
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "editor/app/app.h"
#include "editor/ui/driver.h"
#include "grass/drawing.h"
#include "grass/slice_settings.h"
#include "scenes.h"
#include "support.h"
#include "techniques.h"

namespace sward::test {

// A new project for each test, and a fresh editor on it.
class EditorFixture : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(doc.create(dir / "meadow"));
        thinOut();
        openEditor();
    }
    void TearDown() override {
        EXPECT_EQ(gpu->errors, 0) << gpu->lastError;
        EXPECT_EQ(app->messages.notice, "");
    }

    // What panels and hands do does not depend on how good the grass is: light from blade to blade is traced for
    // seconds after each change of a species, and slices and near blades are most of a frame. No undo step: this is how
    // the project begins.
    void thinOut() {
        Project& p = const_cast<Project&>(doc.project());
        p.registry.add<GrassDrawing>(findEntity(p, "lawn"), {.bakeLight = BakeLight::Local});
        p.registry.add<GrassSlices>(findEntity(p, "lawn"), {.slices = 2});
        p.registry.get<GrassField>(findEntity(p, "lawn"))->species[0].bladesPerM2 /= 10;
        ASSERT_TRUE(doc.save());
    }
    // Of 800 x 600 points; what panels and hands do does not depend on how fine the picture is, nor on its blades.
    void openEditor() {
        app = std::make_unique<EditorApp>(doc, *gpu, ui::makeHeadlessSurface(800, 600, 0.5f), false);
        app->picture.resolution.most = 1.0 / 64;
        ui = makeUiDriver(*app);
        ok(ui->wait(3));
    }
    void ok(const Status& status) { EXPECT_TRUE(status) << status.error().text(); }
    // Draws frames until it is so, for a minute at most: what runs beside is as slow as the machine is busy.
    template <class Done>
    void waitUntil(Done done) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
        while (!done() && std::chrono::steady_clock::now() < end) {
            ok(ui->wait(1));
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
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
        const Rect& r = app->hand.rect;
        const double y = static_cast<double>(r.y) + static_cast<double>(r.h) * 0.8;
        ok(ui->drag(static_cast<double>(r.x + r.w * 0.3f), y, static_cast<double>(r.x + r.w * 0.6f), y));
    }

    Gpu* const gpu = &test::gpu();
    TempDir dir;
    Document doc{tables()};
    std::unique_ptr<EditorApp> app;
    std::unique_ptr<UiDriver> ui;
};

// Tests of panels and of the editor as a whole; one suite over several files, so that a context is made once.
class EditorUi : public EditorFixture {};

// The same for tools of a hybrid field: tiers, rings, combing, overlays, erasing.
class EditorTools : public EditorFixture {
  protected:
    TierDistances tiers() {
        const HybridTiers* own = doc.project().registry.get<HybridTiers>(findEntity(doc.project(), "lawn"));
        return tiersOf(own ? *own : HybridTiers{});
    }
    std::array<double, 2> grip(const std::string& tier) {
        const auto r = ui->rect("Viewport/Ring " + tier);
        EXPECT_TRUE(r) << (r ? "" : r.error().text());
        return r ? std::array{((*r)[0] + (*r)[2]) / 2, ((*r)[1] + (*r)[3]) / 2} : std::array{0.0, 0.0};
    }
    const MapField& mapOf(const std::string& path) {
        return *static_cast<const MapField*>(findField(doc.project(), tables().components, path)->value);
    }
    // Left button down at a place; frames run.
    void press(double x, double y) {
        app->queue.push({InputKind::Move, x, y, 0, false});
        ok(ui->wait(2));
        app->queue.push({InputKind::Button, 0, 0, 0, true});
        ok(ui->wait(1));
    }
    void moveTo(double x, double y) {
        app->queue.push({InputKind::Move, x, y, 0, false});
        ok(ui->wait(1));
    }
    void release() {
        app->queue.push({InputKind::Button, 0, 0, 0, false});
        ok(ui->wait(2));
    }
    std::vector<uint8_t> picture() {
        app->clock.refineNow = true;
        app->picture.drawnRevision = ~uint64_t(0);
        ok(ui->wait(2));
        app->clock.refineNow = false;
        std::vector<uint8_t> pixels(static_cast<size_t>(app->picture.width) * app->picture.height * 4);
        glGetTextureImage(app->picture.texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(pixels.size()),
                          pixels.data());
        return pixels;
    }
};

}  // namespace sward::test
