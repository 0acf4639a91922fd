// Entities and their components: sparse sets, one a component type, and views over several.
// Handles carry a generation: one whose entity is gone is refused, and never names the entity that took its place.
// Does not: hold blades (they are never entities), run systems, or know any component.
// Not thread-safe, but any number of threads may read through a const Registry.
// Cost: create, destroy, add, remove, get O(1) (amortised; destroy asks every set); each<A, B...> walks A's set.
#pragma once
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace sward {

struct Entity {
    uint32_t index = std::numeric_limits<uint32_t>::max();
    uint32_t generation = 0;
    bool operator==(const Entity&) const = default;
};
inline constexpr Entity kNoEntity{};

namespace detail {
inline constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

struct PoolBase {
    std::vector<uint32_t> sparse;  // entity index -> dense slot, or kNone
    std::vector<uint32_t> dense;   // slot -> entity index; kNone: removed during an iteration
    size_t holes = 0;              // how many of dense are kNone
    int iterating = 0;             // how many iterations are under way
    virtual ~PoolBase() = default;
    // Removes the entity's component; nothing if it has none.
    virtual void remove(uint32_t index) = 0;
    // Ends one iteration; the outermost closes the gaps that removals left.
    virtual void endIteration() = 0;
    // Slot of the entity's component in the dense arrays, or kNone.
    uint32_t slot(uint32_t index) const { return index < sparse.size() ? sparse[index] : kNone; }
    // Sets filled in equal order keep an entity in the same slot: a right guess saves the look-up in `sparse`.
    uint32_t slot(uint32_t index, size_t guess) const {
        return guess < dense.size() && dense[guess] == index ? static_cast<uint32_t>(guess) : slot(index);
    }
};

// Holds the sets of a view still for as long as it lives, exceptions included.
template <size_t N>
struct Iteration {
    std::array<PoolBase*, N> pools;
    explicit Iteration(const std::array<PoolBase*, N>& p) : pools(p) {
        for (PoolBase* pool : pools) ++pool->iterating;
    }
    ~Iteration() {
        for (PoolBase* pool : pools) pool->endIteration();
    }
    Iteration(const Iteration&) = delete;
    Iteration& operator=(const Iteration&) = delete;
};

template <class C>
struct Pool final : PoolBase {
    static_assert(!std::is_same_v<C, bool>, "a vector of bool hands out no references: wrap it in a struct");
    std::vector<C> items;

    // Adds the component, or replaces the one that is there. The reference holds until the set next changes.
    C& add(uint32_t index, C value) {
        if (index >= sparse.size()) sparse.resize(index + 1, kNone);
        if (const uint32_t s = sparse[index]; s != kNone) return items[s] = std::move(value);
        sparse[index] = static_cast<uint32_t>(dense.size());
        dense.push_back(index);
        items.push_back(std::move(value));
        return items.back();
    }
    void remove(uint32_t index) override {
        const uint32_t s = slot(index);
        if (s == kNone) return;
        sparse[index] = kNone;
        if (iterating > 0) {  // the slot stays until the outermost iteration ends, so that nothing moves under it
            dense[s] = kNone;
            ++holes;
            return;
        }
        moveInto(s, dense.size() - 1);
        shrink(dense.size() - 1);
    }
    void endIteration() override {
        if (--iterating > 0 || holes == 0) return;
        size_t kept = 0;
        for (size_t s = 0; s < dense.size(); ++s)
            if (dense[s] != kNone) moveInto(kept++, s);
        shrink(kept);
        holes = 0;
    }

  private:
    void moveInto(size_t to, size_t from) {
        if (to == from) return;
        dense[to] = dense[from];
        items[to] = std::move(items[from]);
        sparse[dense[to]] = static_cast<uint32_t>(to);
    }
    void shrink(size_t size) {
        dense.resize(size);
        items.erase(items.begin() + static_cast<std::ptrdiff_t>(size), items.end());
    }
};

// A number that no component type has yet, from 0.
inline uint32_t nextTypeId() {
    static std::atomic<uint32_t> next = 0;
    return next++;
}
// Number of a component type: the same for the whole run of the process, by the order of first use.
template <class C>
uint32_t typeId() {
    static const uint32_t id = nextTypeId();
    return id;
}
}  // namespace detail

class Registry {
  public:
    Registry() = default;
    // Only to try what happens when generations run out. firstGeneration: at least 1.
    explicit Registry(uint32_t firstGeneration) : firstGeneration_(firstGeneration) {}

    // A new entity with no components.
    Entity create() {
        ++alive_;
        if (!free_.empty()) {
            const uint32_t index = free_.back();
            free_.pop_back();
            return {index, generations_[index]};
        }
        generations_.push_back(firstGeneration_);
        return {static_cast<uint32_t>(generations_.size() - 1), firstGeneration_};
    }
    // Removes the entity and its components. False if the handle is stale.
    bool destroy(Entity e) {
        if (!valid(e)) return false;
        for (auto& pool : pools_)
            if (pool) pool->remove(e.index);
        if (++generations_[e.index] != 0) free_.push_back(e.index);  // 0: worn out, never used again
        --alive_;
        return true;
    }
    // True if the handle names an entity that is alive.
    bool valid(Entity e) const {
        return e.generation != 0 && e.index < generations_.size() && generations_[e.index] == e.generation;
    }
    // Entities that are alive.
    size_t size() const { return alive_; }

    // Adds or replaces. Null if the handle is stale. The pointer holds until C is next added to or removed from.
    template <class C>
    C* add(Entity e, C value = {}) {
        return valid(e) ? &pool<C>().add(e.index, std::move(value)) : nullptr;
    }
    // False if the handle is stale or has no C.
    template <class C>
    bool remove(Entity e) {
        if (!get<C>(e)) return false;
        pool<C>().remove(e.index);
        return true;
    }
    // Null if the handle is stale or has no C. The pointer holds as long as add's.
    template <class C>
    const C* get(Entity e) const {
        const detail::Pool<C>* p = find<C>();
        if (!p || !valid(e)) return nullptr;
        const uint32_t s = p->slot(e.index);
        return s == detail::kNone ? nullptr : &p->items[s];
    }
    // As above, to write to.
    template <class C>
    C* get(Entity e) {
        if (!find<C>() || !valid(e)) return nullptr;
        detail::Pool<C>& p = pool<C>();
        const uint32_t s = p.slot(e.index);
        return s == detail::kNone ? nullptr : &p.items[s];
    }
    // Entities that have a C.
    template <class C>
    size_t count() const {
        const detail::Pool<C>* p = find<C>();
        return p ? p->dense.size() - p->holes : 0;
    }

    // Calls f(Entity, First&, Rest&...) for each entity that has all of them, in First's order: the order in which they
    // were added, until a removal outside an iteration moves the last one into the gap.
    // During it, in f and in iterations nested in it, everything is allowed:
    // - a removed component or entity, the current one included, is not visited afterwards; references to what was
    //   removed from First or Rest hold until the outermost iteration over that component ends;
    // - an entity that gains a First is not visited; one that has First and gains a Rest before its turn is;
    // - adding a First or Rest invalidates the references that f was given to that component.
    template <class First, class... Rest, class F>
    void each(F&& f) {
        detail::Pool<First>& first = pool<First>();
        const std::tuple<detail::Pool<Rest>&...> rest{pool<Rest>()...};
        const detail::Iteration<1 + sizeof...(Rest)> hold({&first, &pool<Rest>()...});
        walk(first, rest, std::index_sequence_for<Rest...>{}, f);
    }
    // The same on a registry that only is read.
    template <class First, class... Rest, class F>
    void each(F&& f) const {
        const detail::Pool<First>* first = find<First>();
        if (!first || !(find<Rest>() && ...)) return;
        walk(*first, std::tuple<const detail::Pool<Rest>&...>{*find<Rest>()...}, std::index_sequence_for<Rest...>{}, f);
    }

  private:
    template <class First, class Rest, size_t... I, class F>
    void walk(First& first, const Rest& rest, std::index_sequence<I...>, F& f) const {
        const size_t end = first.dense.size();
        for (size_t s = 0; s < end; ++s) {
            const uint32_t index = first.dense[s];
            if (index == detail::kNone) continue;
            [[maybe_unused]] const std::array<uint32_t, sizeof...(I)> at{std::get<I>(rest).slot(index, s)...};
            if (((at[I] == detail::kNone) || ...)) continue;
            f(Entity{index, generations_[index]}, first.items[s], std::get<I>(rest).items[at[I]]...);
        }
    }
    template <class C>
    const detail::Pool<C>* find() const {
        const uint32_t id = detail::typeId<C>();
        return id < pools_.size() ? static_cast<const detail::Pool<C>*>(pools_[id].get()) : nullptr;
    }
    template <class C>
    detail::Pool<C>& pool() {
        const uint32_t id = detail::typeId<C>();
        if (id >= pools_.size()) pools_.resize(id + 1);
        if (!pools_[id]) pools_[id] = std::make_unique<detail::Pool<C>>();
        return static_cast<detail::Pool<C>&>(*pools_[id]);
    }

    std::vector<std::unique_ptr<detail::PoolBase>> pools_;  // by type id
    std::vector<uint32_t> generations_;                     // by entity index: of the one that is, or of the next
    std::vector<uint32_t> free_;
    uint32_t firstGeneration_ = 1;
    size_t alive_ = 0;
};

}  // namespace sward
