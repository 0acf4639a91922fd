// Which pictures a film has, and what is refused.
#include "model/film_plan.h"

#include <gtest/gtest.h>

#include "objects.h"

namespace sward::test {
namespace {

struct Films : testing::Test {
    Films() {
        p.dir = dir / "p", p.name = "p";
        CameraPath path;
        path.keys.resize(2);
        path.keys[0].name = "a", path.keys[0].eye = {0, 1, 0}, path.keys[0].target = {0, 1, -1};
        path.keys[1].name = "b", path.keys[1].eye = {4, 1, 0}, path.keys[1].target = {4, 1, -1};
        path.keys[1].seconds = 2;
        put(p, "way", path);
        put(p, "empty", CameraPath{});
        std::filesystem::create_directories(dir / "p");
    }
    std::string refusal(const FilmPlan& plan) {
        const Status s = checkFilm(plan, p);
        return s ? "" : s.error().text();
    }
    TempDir dir;
    Project p;
};

TEST_F(Films, AFilmAlongAPathHasAllOfIt) {
    const FilmPlan plan{.film = true, .out = dir / "film", .path = "way", .fps = 10};
    EXPECT_EQ(framesOf(plan, p), 21) << "both ends";
    EXPECT_EQ(fileOf(plan, 7), dir / "film" / "frame_0007.png");
    EXPECT_EQ(viewIn(plan, p, {}, 20).eye.x, 4);
    EXPECT_EQ(secondOf(plan, 20), 2);
    EXPECT_EQ(refusal(plan), "");
    EXPECT_EQ(filmPaths(p), std::vector<std::string>{"way"});
    FilmPlan rest = plan;
    rest.from = 1;
    EXPECT_EQ(framesOf(rest, p), 11);
    rest.from = 3;
    EXPECT_NE(refusal(rest).find("no length"), std::string::npos);
}

TEST_F(Films, OfTheViewTheTimeAloneGoesOn) {
    const FilmPlan plan{.film = true, .out = dir / "film", .fps = 25, .from = 3, .seconds = 2};
    EXPECT_EQ(framesOf(plan, p), 51);
    EXPECT_EQ(secondOf(plan, 50), 5);
    EXPECT_EQ(viewIn(plan, p, {{1, 2, 3}, {0, 0, 0}, 55, 0}, 40).eye, glm::dvec3(1, 2, 3));
}

TEST_F(Films, WhatCannotBeIsRefusedWithItsRemedy) {
    EXPECT_NE(refusal({.out = dir / "a.png", .width = 0}).find("no size"), std::string::npos);
    EXPECT_NE(refusal({.out = dir / "a.jpg"}).find(".png or .exr"), std::string::npos);
    EXPECT_NE(refusal({.out = dir / "none" / "a.png"}).find("no such folder"), std::string::npos);
    EXPECT_NE(refusal({}).find("no place"), std::string::npos);
    FilmPlan film{.film = true, .out = dir / "film"};
    EXPECT_NE(refusal(film).find("no length"), std::string::npos);
    film.seconds = 1, film.fps = 0;
    EXPECT_NE(refusal(film).find("pictures a second"), std::string::npos);
    film.fps = 25, film.seconds = 1e6;
    EXPECT_NE(refusal(film).find("too many"), std::string::npos);
    film.seconds = 1, film.format = "bmp";
    EXPECT_NE(refusal(film).find("format"), std::string::npos);
    film.format = "png", film.path = "empty";
    EXPECT_NE(refusal(film).find("keys"), std::string::npos);
}

TEST_F(Films, NothingIsReplaced) {
    writeText(dir / "p.png", "x");
    EXPECT_NE(refusal({.out = dir / "p.png"}).find("there already"), std::string::npos);
    EXPECT_EQ(freePictureName({}, p), dir / "p-2.png");
    EXPECT_EQ(freePictureName({.film = true}, p), dir / "p-film");
    std::filesystem::create_directories(dir / "film");
    writeText(dir / "film" / "frame_0000.png", "x");
    EXPECT_NE(refusal({.film = true, .out = dir / "film", .seconds = 1}).find("a film here already"),
              std::string::npos);
}

}  // namespace
}  // namespace sward::test
