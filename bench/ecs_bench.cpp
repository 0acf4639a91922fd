// A view over two components against the plain loop over two arrays that it stands for.
#include <benchmark/benchmark.h>

#include "bench/limits.h"
#include "ecs/registry.h"

namespace {
using namespace sward;

constexpr int kEntities = 1'000'000;
struct Position {
    float x = 0, y = 0, z = 0;
};
struct Velocity {
    float x = 1, y = 2, z = 3;
};

// Both hold the same million entities, in equal order.
struct World {
    Registry registry;
    std::vector<Position> positions{kEntities};
    std::vector<Velocity> velocities{kEntities};
    World() {
        for (int i = 0; i < kEntities; ++i) {
            const Entity e = registry.create();
            registry.add(e, Position{});
            registry.add(e, Velocity{});
        }
    }
};
World& world() {
    static World w;
    return w;
}

void advance(Position& p, const Velocity& v) {
    p.x += 0.01f * v.x;
    p.y += 0.01f * v.y;
    p.z += 0.01f * v.z;
}
void walkView(World& w) {
    w.registry.each<Position, Velocity>([](Entity, Position& p, const Velocity& v) { advance(p, v); });
    benchmark::ClobberMemory();
}
void walkArrays(World& w) {
    for (size_t i = 0; i < w.positions.size(); ++i) advance(w.positions[i], w.velocities[i]);
    benchmark::ClobberMemory();
}

void ecsView(benchmark::State& state) {
    for (auto _ : state) walkView(world());
    state.SetItemsProcessed(state.iterations() * kEntities);
}
void ecsArrays(benchmark::State& state) {
    for (auto _ : state) walkArrays(world());
    state.SetItemsProcessed(state.iterations() * kEntities);
}
BENCHMARK(ecsView)->Name("ecs/view")->Unit(benchmark::kMillisecond);
BENCHMARK(ecsArrays)->Name("ecs/arrays")->Unit(benchmark::kMillisecond);

// In turns, so that both meet the same machine; the median of the pairs' ratios.
SWARD_LIMITS("ecs", [] {
    World& w = world();
    std::vector<double> ratios;
    for (int i = 0; i < 41; ++i) {
        const double arrays = seconds([&] { walkArrays(w); });
        const double view = seconds([&] { walkView(w); });
        if (i >= 4) ratios.push_back(view / arrays);
    }
    reportLimit("ecs: view of two components over a million entities / plain loop", median(ratios), 2.5, "x");
});
}  // namespace
