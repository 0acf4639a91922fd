#include "ecs/registry.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <random>
#include <set>

namespace sward {
namespace {

struct Place {
    int x = 0;
};
struct Speed {
    int v = 0;
};
struct Colour {
    int c = 0;
};
struct Owner {  // move-only: maps and handles may be
    std::unique_ptr<int> p;
};

std::vector<Entity> make(Registry& r, int n) {
    std::vector<Entity> out;
    for (int i = 0; i < n; ++i) {
        out.push_back(r.create());
        r.add(out.back(), Place{i});
    }
    return out;
}
std::vector<int> placesSeen(Registry& r) {
    std::vector<int> seen;
    r.each<Place>([&](Entity, Place& p) { seen.push_back(p.x); });
    return seen;
}

// --- handles

TEST(Registry, AStaleHandleIsRefusedByEveryCall) {
    Registry r;
    const Entity e = r.create();
    r.add(e, Place{7});
    EXPECT_TRUE(r.destroy(e));
    EXPECT_FALSE(r.valid(e));
    EXPECT_EQ(r.get<Place>(e), nullptr);
    EXPECT_EQ(std::as_const(r).get<Place>(e), nullptr);
    EXPECT_EQ(r.add(e, Place{1}), nullptr);
    EXPECT_FALSE(r.remove<Place>(e));
    EXPECT_FALSE(r.destroy(e));
    EXPECT_EQ(r.count<Place>(), 0u);
    EXPECT_EQ(r.size(), 0u);
}

TEST(Registry, AStaleHandleNeverNamesTheEntityThatTookItsPlace) {
    Registry r;
    const Entity old = r.create();
    r.add(old, Place{1});
    r.destroy(old);
    const Entity young = r.create();
    ASSERT_EQ(young.index, old.index) << "the test needs the index to be used again";
    r.add(young, Place{2});
    EXPECT_FALSE(old == young);
    EXPECT_EQ(r.get<Place>(old), nullptr);
    EXPECT_FALSE(r.remove<Place>(old));
    EXPECT_FALSE(r.destroy(old));
    ASSERT_NE(r.get<Place>(young), nullptr);
    EXPECT_EQ(r.get<Place>(young)->x, 2);
}

TEST(Registry, HandlesThatWereNeverGivenAreRefused) {
    Registry r;
    const Entity e = r.create();
    EXPECT_FALSE(r.valid(kNoEntity));
    EXPECT_FALSE(r.valid({e.index, 0}));
    EXPECT_FALSE(r.valid({e.index, e.generation + 1}));
    EXPECT_FALSE(r.valid({e.index + 1, 1}));
    EXPECT_EQ(r.add(kNoEntity, Place{}), nullptr);
}

TEST(Registry, AnIndexWhoseGenerationsRanOutIsNeverUsedAgain) {
    Registry r(std::numeric_limits<uint32_t>::max());
    const Entity last = r.create();
    EXPECT_TRUE(r.destroy(last));
    const Entity next = r.create();
    EXPECT_NE(next.index, last.index);
    EXPECT_FALSE(r.valid(last));
    EXPECT_FALSE(r.valid({last.index, 0}));
    EXPECT_FALSE(r.valid({last.index, 1}));
    EXPECT_EQ(r.size(), 1u);
}

// --- components

TEST(Registry, AddReplacesAndRemoveIsTrueOnce) {
    Registry r;
    const Entity e = r.create();
    r.add(e, Place{1});
    EXPECT_EQ(r.add(e, Place{2})->x, 2);
    EXPECT_EQ(r.count<Place>(), 1u);
    EXPECT_TRUE(r.remove<Place>(e));
    EXPECT_FALSE(r.remove<Place>(e));
    EXPECT_EQ(r.count<Place>(), 0u);
    EXPECT_TRUE(r.valid(e));
}

TEST(Registry, RemovalFromTheMiddleLeavesEveryOtherComponentWithItsEntity) {
    Registry r;
    const auto e = make(r, 5);
    r.remove<Place>(e[1]);
    r.destroy(e[3]);
    for (int i : {0, 2, 4}) {
        ASSERT_NE(r.get<Place>(e[i]), nullptr) << i;
        EXPECT_EQ(r.get<Place>(e[i])->x, i);
    }
    EXPECT_EQ(r.count<Place>(), 3u);
}

TEST(Registry, AComponentTypeNobodyHasIsAskedForWithoutHarm) {
    Registry r;
    const Entity e = r.create();
    EXPECT_EQ(r.get<Colour>(e), nullptr);
    EXPECT_FALSE(r.remove<Colour>(e));
    EXPECT_EQ(std::as_const(r).count<Colour>(), 0u);
    std::as_const(r).each<Colour>([](Entity, const Colour&) { FAIL(); });
}

TEST(Registry, MoveOnlyComponentsAreMovedNeverLost) {
    Registry r;
    std::vector<Entity> e;
    for (int i = 0; i < 100; ++i) {
        e.push_back(r.create());
        r.add(e.back(), Owner{std::make_unique<int>(i)});
    }
    for (int i = 0; i < 100; i += 3) r.destroy(e[i]);
    r.each<Owner>([&](Entity x, Owner& o) {
        if (*o.p % 3 == 1) r.remove<Owner>(x);
    });
    for (int i = 0; i < 100; ++i) {
        const Owner* o = r.get<Owner>(e[i]);
        ASSERT_EQ(o != nullptr, i % 3 == 2) << i;
        if (o) {
            EXPECT_EQ(*o->p, i);
        }
    }
}

TEST(Registry, MovingARegistryKeepsHandles) {
    Registry a;
    const auto e = make(a, 3);
    const Registry b = std::move(a);
    EXPECT_EQ(b.size(), 3u);
    EXPECT_EQ(b.get<Place>(e[2])->x, 2);
}

// --- views

TEST(RegistryView, VisitsExactlyTheEntitiesThatHaveAllComponentsInTheFirstsOrder) {
    Registry r;
    const auto e = make(r, 12);
    for (int i = 11; i >= 0; --i)  // another order than Place's
        if (i % 2 == 0) r.add(e[i], Speed{10 * i});
    for (int i = 0; i < 12; ++i)
        if (i % 3 == 0) r.add(e[i], Colour{100 * i});
    std::vector<int> seen;
    r.each<Place, Speed, Colour>([&](Entity x, Place& p, Speed& s, Colour& c) {
        EXPECT_EQ(x, e[p.x]);
        EXPECT_EQ(s.v, 10 * p.x);
        EXPECT_EQ(c.c, 100 * p.x);
        seen.push_back(p.x);
    });
    EXPECT_EQ(seen, (std::vector<int>{0, 6}));
    seen.clear();
    std::as_const(r).each<Speed, Place>([&](Entity, const Speed&, const Place& p) { seen.push_back(p.x); });
    EXPECT_EQ(seen, (std::vector<int>{10, 8, 6, 4, 2, 0}));
}

TEST(RegistryView, WritesThroughItsReferences) {
    Registry r;
    const auto e = make(r, 3);
    r.each<Place>([](Entity, Place& p) { p.x += 100; });
    EXPECT_EQ(r.get<Place>(e[2])->x, 102);
}

// --- changes during iteration

TEST(RegistryIteration, DestroyingTheCurrentEntityKeepsItsReferencesToTheEnd) {
    Registry r;
    const auto e = make(r, 6);
    std::vector<int> seen;
    r.each<Place>([&](Entity x, Place& p) {
        const int before = p.x;
        r.destroy(x);
        EXPECT_EQ(p.x, before);
        EXPECT_EQ(r.get<Place>(x), nullptr);
        seen.push_back(p.x);
    });
    EXPECT_EQ(seen, (std::vector<int>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(r.count<Place>(), 0u);
    EXPECT_EQ(r.size(), 0u);
    EXPECT_FALSE(r.valid(e[0]));
}

TEST(RegistryIteration, WhatIsDestroyedBeforeItsTurnIsNotVisitedAndNothingIsVisitedTwice) {
    Registry r;
    const auto e = make(r, 6);
    std::vector<int> seen;
    r.each<Place>([&](Entity, Place& p) {
        seen.push_back(p.x);
        if (p.x == 2) {
            r.destroy(e[0]);  // visited already
            r.destroy(e[3]);  // next
            r.destroy(e[5]);  // last
        }
    });
    EXPECT_EQ(seen, (std::vector<int>{0, 1, 2, 4}));
    EXPECT_EQ(placesSeen(r), (std::vector<int>{1, 2, 4}));
    EXPECT_EQ(r.count<Place>(), 3u);
}

TEST(RegistryIteration, RemovingAnyComponentOfTheViewTakesTheEntityOutOfIt) {
    Registry r;
    const auto e = make(r, 5);
    for (int i = 0; i < 5; ++i) r.add(e[i], Speed{i});
    std::vector<int> seen;
    r.each<Place, Speed>([&](Entity, Place& p, Speed& s) {
        seen.push_back(p.x);
        if (p.x == 1) {
            r.remove<Speed>(e[0]);
            r.remove<Speed>(e[1]);
            EXPECT_EQ(s.v, 1);
            r.remove<Speed>(e[2]);
            r.remove<Place>(e[3]);
        }
    });
    EXPECT_EQ(seen, (std::vector<int>{0, 1, 4}));
    EXPECT_EQ(r.count<Speed>(), 2u);
    EXPECT_EQ(r.get<Speed>(e[3])->v, 3);
    EXPECT_EQ(r.get<Place>(e[2])->x, 2);
}

TEST(RegistryIteration, ARemovedComponentThatIsAddedAgainIsNotVisitedButKept) {
    Registry r;
    const auto e = make(r, 4);
    std::vector<int> seen;
    r.each<Place>([&](Entity x, Place& p) {
        const int was = p.x;  // adding moves the set
        seen.push_back(was);
        r.remove<Place>(x);
        r.add(x, Place{was + 10});
        if (was == 0) {
            r.remove<Place>(e[2]);
            r.add(e[2], Place{12});
        }
    });
    EXPECT_EQ(seen, (std::vector<int>{0, 1, 3}));
    for (int i = 0; i < 4; ++i) EXPECT_EQ(r.get<Place>(e[i])->x, i + 10);
    EXPECT_EQ(r.count<Place>(), 4u);
}

TEST(RegistryIteration, AnAddedFirstIsNotVisitedAndAnAddedRestIsIfItsTurnIsYetToCome) {
    Registry r;
    const auto e = make(r, 4);
    r.add(e[1], Speed{1});
    std::vector<int> seen;
    r.each<Place, Speed>([&](Entity, Place& p, Speed&) {
        seen.push_back(p.x);
        if (p.x != 1) return;
        r.add(e[0], Speed{0});  // its turn is over
        r.add(e[3], Speed{3});
        const Entity young = r.create();
        r.add(young, Place{99});
        r.add(young, Speed{99});
    });
    EXPECT_EQ(seen, (std::vector<int>{1, 3}));
    EXPECT_EQ(placesSeen(r), (std::vector<int>{0, 1, 2, 3, 99}));
}

TEST(RegistryIteration, AnEntityMadeInPlaceOfADestroyedOneIsNotVisited) {
    Registry r;
    const auto e = make(r, 4);
    std::vector<int> seen;
    r.each<Place>([&](Entity, Place& p) {
        seen.push_back(p.x);
        if (p.x == 0) {
            r.destroy(e[2]);
            const Entity young = r.create();
            EXPECT_EQ(young.index, e[2].index);
            r.add(young, Place{50});
        }
    });
    EXPECT_EQ(seen, (std::vector<int>{0, 1, 3}));
    EXPECT_EQ(placesSeen(r), (std::vector<int>{0, 1, 3, 50}));
}

TEST(RegistryIteration, NestedIterationsSeeEachOthersRemovals) {
    Registry r;
    const auto e = make(r, 5);
    for (int i = 0; i < 5; ++i) r.add(e[i], Speed{i});
    std::vector<std::pair<int, int>> seen;
    r.each<Place>([&](Entity, Place& p) {
        r.each<Speed, Place>([&](Entity y, Speed& s, Place& q) {
            EXPECT_EQ(s.v, q.x);
            seen.emplace_back(p.x, s.v);
            if (p.x == 0 && s.v == 1) r.destroy(y);
            if (p.x == 2 && s.v == 2) r.remove<Place>(e[4]);
        });
        EXPECT_EQ(r.count<Place>(), p.x < 2 ? 4u : 3u);
    });
    EXPECT_EQ(seen, (std::vector<std::pair<int, int>>{
                        {0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {2, 0}, {2, 2}, {2, 3}, {3, 0}, {3, 2}, {3, 3}}));
    EXPECT_EQ(r.count<Speed>(), 4u);
    EXPECT_EQ(r.get<Speed>(e[4])->v, 4);
}

TEST(RegistryIteration, AComponentTypeFirstMetDuringAnIterationMovesNothing) {
    struct Late {
        int n = 0;
    };
    Registry r;
    const auto e = make(r, 3);
    r.each<Place>([&](Entity x, Place& p) {
        r.add(x, Late{p.x});
        EXPECT_EQ(p.x, r.get<Late>(x)->n);
    });
    EXPECT_EQ(r.count<Late>(), 3u);
}

TEST(RegistryIteration, AnExceptionEndsTheIterationInOrder) {
    Registry r;
    const auto e = make(r, 4);
    const auto throwing = [&](Entity x, Place& p) {
        r.destroy(x);
        if (p.x == 1) throw std::runtime_error("stop");
    };
    EXPECT_THROW(r.each<Place>(throwing), std::runtime_error);
    EXPECT_EQ(placesSeen(r), (std::vector<int>{2, 3}));
    r.destroy(e[2]);  // had the iteration stayed open, this would leave a hole for ever
    EXPECT_EQ(placesSeen(r), (std::vector<int>{3}));
    EXPECT_EQ(r.count<Place>(), 1u);
}

// --- against a naive model

struct Model {
    struct Row {
        std::optional<int> place, speed, owner;
    };
    std::map<std::pair<uint32_t, uint32_t>, Row> rows;
    static std::pair<uint32_t, uint32_t> key(Entity e) { return {e.index, e.generation}; }
};

class RegistryAgainstModel : public testing::TestWithParam<unsigned> {
  protected:
    Registry r;
    Model m;
    std::vector<Entity> ever;  // every handle that was given out, stale ones too
    std::mt19937 random{GetParam()};
    int serial = 0;

    int below(size_t n) { return static_cast<int>(random() % n); }
    Entity any() { return ever[random() % ever.size()]; }

    // One random change; inside iterations too.
    void change() {
        const int what = below(8);
        if (what == 0 || ever.empty()) {
            const Entity e = r.create();
            ASSERT_TRUE(m.rows.emplace(Model::key(e), Model::Row{}).second) << "a handle was given out twice";
            ever.push_back(e);
            return;
        }
        const Entity e = any();
        const auto row = m.rows.find(Model::key(e));
        const bool alive = row != m.rows.end();
        const int n = ++serial;
        switch (what) {
            case 1:
                ASSERT_EQ(r.destroy(e), alive);
                if (alive) m.rows.erase(row);
                return;
            case 2:
            case 3:
                ASSERT_EQ(r.add(e, Place{n}) != nullptr, alive);
                if (alive) row->second.place = n;
                return;
            case 4:
                ASSERT_EQ(r.add(e, Speed{n}) != nullptr, alive);
                if (alive) row->second.speed = n;
                return;
            case 5:
                ASSERT_EQ(r.add(e, Owner{std::make_unique<int>(n)}) != nullptr, alive);
                if (alive) row->second.owner = n;
                return;
            case 6:
                ASSERT_EQ(r.remove<Place>(e), alive && row->second.place.has_value());
                if (alive) row->second.place.reset();
                return;
            default:
                ASSERT_EQ(r.remove<Speed>(e), alive && row->second.speed.has_value());
                if (alive) row->second.speed.reset();
        }
    }

    // Changes things while iterating; every visit must be of an entity that has both at that moment, once.
    void iterate(int depth) {
        std::set<std::pair<uint32_t, uint32_t>> seen;
        r.each<Place, Speed>([&](Entity e, Place& p, Speed& s) {
            const auto row = m.rows.find(Model::key(e));
            ASSERT_NE(row, m.rows.end());
            ASSERT_EQ(row->second.place, p.x);
            ASSERT_EQ(row->second.speed, s.v);
            ASSERT_TRUE(seen.insert(Model::key(e)).second) << "visited twice";
            if (below(4) == 0) change();
            if (depth < 2 && below(40) == 0) iterate(depth + 1);
        });
    }

    void compare() {
        ASSERT_EQ(r.size(), m.rows.size());
        for (const Entity e : ever) {
            const auto row = m.rows.find(Model::key(e));
            const bool alive = row != m.rows.end();
            ASSERT_EQ(r.valid(e), alive);
            const Place* p = r.get<Place>(e);
            const Speed* s = r.get<Speed>(e);
            const Owner* o = r.get<Owner>(e);
            ASSERT_EQ(p ? std::optional(p->x) : std::nullopt, alive ? row->second.place : std::nullopt);
            ASSERT_EQ(s ? std::optional(s->v) : std::nullopt, alive ? row->second.speed : std::nullopt);
            ASSERT_EQ(o ? std::optional(*o->p) : std::nullopt, alive ? row->second.owner : std::nullopt);
        }
        size_t both = 0, places = 0, viewed = 0;
        for (const auto& [key, row] : m.rows) {
            places += row.place ? 1 : 0;
            both += row.place && row.owner ? 1 : 0;
        }
        std::as_const(r).each<Owner, Place>([&](Entity e, const Owner& o, const Place& p) {
            ++viewed;
            ASSERT_EQ(m.rows.at(Model::key(e)).owner, *o.p);
            ASSERT_EQ(m.rows.at(Model::key(e)).place, p.x);
        });
        ASSERT_EQ(viewed, both);
        ASSERT_EQ(r.count<Place>(), places);
    }
};

TEST_P(RegistryAgainstModel, ARandomProgramEndsWithTheSameEntitiesAndComponents) {
    for (int round = 0; round < 60; ++round) {
        for (int i = 0; i < 40; ++i) ASSERT_NO_FATAL_FAILURE(change());
        ASSERT_NO_FATAL_FAILURE(iterate(0));
        ASSERT_NO_FATAL_FAILURE(compare());
    }
    EXPECT_GT(m.rows.size(), 20u) << "the program must leave something to compare";
}
INSTANTIATE_TEST_SUITE_P(Seeds, RegistryAgainstModel, testing::Range(1u, 9u));

}  // namespace
}  // namespace sward
