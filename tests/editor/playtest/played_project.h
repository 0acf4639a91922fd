// A project with a ball to play in, for tests of playtests.
// Does not: test anything itself.
#pragma once
#include <gtest/gtest.h>

#include "model/document.h"
#include "playtest/playtest.h"
#include "project/project_files.h"
#include "support.h"
#include "techniques.h"

namespace sward::test {

// A new project of 40 x 40 m with a ball; unsaved work, something to undo and to do again.
struct Fixture {
    TempDir dir;
    Document doc{tables()};
    Fixture() {
        EXPECT_TRUE(doc.create(dir / "p"));
        ok(doc.addEntity("ball"));
        for (const char* c : {"Transform", "Rolling", "StaticMesh"}) ok(doc.addComponent("ball", c));
        ok(doc.setField("ball.Transform.position", "[20, 0.5, 20]"));
        ok(doc.setField("ball.Rolling.radius", "0.5"));
        ok(doc.setField("ball.StaticMesh.file", "ball.glb"));
        ok(doc.setField("sun.Light.elevationDeg", "20"));
        EXPECT_TRUE(doc.undo());
    }
    void ok(const Status& s) { EXPECT_TRUE(s) << s.error().text(); }
    PlayStart start() {
        PlayStart s;
        s.view = {{17, 5, 20}, {27, 5, 20}, 60, 0.5f};
        s.byClock = false;
        return s;
    }
    uint64_t hash() { return projectHash(doc.project(), tables().components); }
};
inline PlayInput walkEast() {
    PlayInput in;
    in.move = {0, 1};
    in.yaw = 3.14159265358979 / 2;
    return in;
}

}  // namespace sward::test
