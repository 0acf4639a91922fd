// Entities and their components: sparse sets, one a component type, and views over several.
// Handles carry a generation: one whose entity is gone is refused, and never names the entity that took its place.
// Does not: hold blades (they are never entities), run systems, or know any component.
// Cost: add, remove, get O(1); each<A, B...> walks the smallest set.
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <tuple>
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
    std::vector<Entity> dense;     // slot -> entity; kNoEntity: removed during an iteration
    int iterating = 0;
    bool holes = false;
    virtual ~PoolBase() = default;
    virtual void remove(uint32_t index) = 0;
    uint32_t slot(uint32_t index) const { return index < sparse.size() ? sparse[index] : kNone; }
};

template <class C>
struct Pool final : PoolBase {
    std::vector<C> items;

    C& add(Entity e, C value) {
        if (e.index >= sparse.size()) sparse.resize(e.index + 1, kNone);
        if (const uint32_t s = sparse[e.index]; s != kNone) return items[s] = std::move(value);
        sparse[e.index] = static_cast<uint32_t>(dense.size());
        dense.push_back(e);
        items.push_back(std::move(value));
        return items.back();
    }
    void remove(uint32_t index) override {
        const uint32_t s = slot(index);
        if (s == kNone) return;
        sparse[index] = kNone;
        if (iterating > 0) {  // the slot stays until the outermost iteration ends, so that nothing moves under it
            dense[s] = kNoEntity;
            holes = true;
            return;
        }
        moveInto(s, dense.size() - 1);
        shrink(dense.size() - 1);
    }
    void endIteration() {
        if (--iterating > 0 || !holes) return;
        size_t kept = 0;
        for (size_t s = 0; s < dense.size(); ++s)
            if (!(dense[s] == kNoEntity)) moveInto(kept++, s);
        shrink(kept);
        holes = false;
    }

  private:
    void moveInto(size_t to, size_t from) {
        if (to == from) return;
        dense[to] = dense[from];
        items[to] = std::move(items[from]);
        sparse[dense[to].index] = static_cast<uint32_t>(to);
    }
    void shrink(size_t size) {
        dense.resize(size);
        items.erase(items.begin() + static_cast<std::ptrdiff_t>(size), items.end());
    }
};

inline uint32_t nextTypeId() {
    static uint32_t next = 0;
    return next++;
}
template <class C>
uint32_t typeId() {
    static const uint32_t id = nextTypeId();
    return id;
}
}  // namespace detail

class Registry {
  public:
    // A new entity with no components.
    Entity create() {
        ++alive_;
        if (!free_.empty()) {
            const uint32_t index = free_.back();
            free_.pop_back();
            return {index, generations_[index]};
        }
        generations_.push_back(1);
        return {static_cast<uint32_t>(generations_.size() - 1), 1};
    }
    // Removes the entity and its components. False if the handle is stale.
    bool destroy(Entity e) {
        if (!valid(e)) return false;
        for (auto& pool : pools_)
            if (pool) pool->remove(e.index);
        ++generations_[e.index];
        free_.push_back(e.index);
        --alive_;
        return true;
    }
    bool valid(Entity e) const { return e.index < generations_.size() && generations_[e.index] == e.generation; }
    size_t size() const { return alive_; }

    // Adds or replaces. Null if the handle is stale. The pointer holds until C is next added to or removed from.
    template <class C>
    C* add(Entity e, C value = {}) {
        return valid(e) ? &pool<C>().add(e, std::move(value)) : nullptr;
    }
    // False if the handle is stale or has no C.
    template <class C>
    bool remove(Entity e) {
        detail::Pool<C>* p = find<C>();
        if (!valid(e) || !p || p->slot(e.index) == detail::kNone) return false;
        p->remove(e.index);
        return true;
    }
    // Null if the handle is stale or has no C.
    template <class C>
    C* get(Entity e) {
        detail::Pool<C>* p = find<C>();
        if (!p || !valid(e)) return nullptr;
        const uint32_t s = p->slot(e.index);
        return s == detail::kNone ? nullptr : &p->items[s];
    }
    template <class C>
    const C* get(Entity e) const {
        return const_cast<Registry*>(this)->get<C>(e);
    }
    template <class C>
    size_t count() const {
        const detail::Pool<C>* p = const_cast<Registry*>(this)->find<C>();
        if (!p) return 0;
        size_t n = 0;
        for (const Entity& e : p->dense) n += e == kNoEntity ? 0 : 1;
        return n;
    }

    // Calls f(Entity, First&, Rest&...) for each entity with all of them, in First's order.
    // During it: removing any component or entity is allowed, and what was removed is not visited afterwards;
    // what is added is not visited, and adding a First or Rest invalidates the references that f was given.
    template <class First, class... Rest, class F>
    void each(F&& f) {
        detail::Pool<First>& first = pool<First>();
        const std::tuple<detail::Pool<Rest>*...> rest{&pool<Rest>()...};
        ++first.iterating;
        (++std::get<detail::Pool<Rest>*>(rest)->iterating, ...);
        const size_t end = first.dense.size();
        for (size_t s = 0; s < end; ++s) {
            const Entity e = first.dense[s];
            if (e == kNoEntity) continue;
            if ((hasAt(*std::get<detail::Pool<Rest>*>(rest), e.index, s) && ...))
                f(e, first.items[s], itemAt(*std::get<detail::Pool<Rest>*>(rest), e.index, s)...);
        }
        (std::get<detail::Pool<Rest>*>(rest)->endIteration(), ...);
        first.endIteration();
    }
    template <class First, class... Rest, class F>
    void each(F&& f) const {
        const_cast<Registry*>(this)->each<First, Rest...>(
            [&](Entity e, const First& a, const Rest&... rest) { f(e, a, rest...); });
    }

  private:
    // Sets filled in equal order keep an entity in the same slot: that guess saves the look-up in `sparse`.
    template <class C>
    static bool hasAt(const detail::Pool<C>& p, uint32_t index, size_t guess) {
        return (guess < p.dense.size() && p.dense[guess].index == index) || p.slot(index) != detail::kNone;
    }
    template <class C>
    static C& itemAt(detail::Pool<C>& p, uint32_t index, size_t guess) {
        return p.dense[guess < p.dense.size() ? guess : 0].index == index ? p.items[guess] : p.items[p.slot(index)];
    }
    template <class C>
    detail::Pool<C>* find() {
        const uint32_t id = detail::typeId<C>();
        return id < pools_.size() ? static_cast<detail::Pool<C>*>(pools_[id].get()) : nullptr;
    }
    template <class C>
    detail::Pool<C>& pool() {
        const uint32_t id = detail::typeId<C>();
        if (id >= pools_.size()) pools_.resize(id + 1);
        if (!pools_[id]) pools_[id] = std::make_unique<detail::Pool<C>>();
        return static_cast<detail::Pool<C>&>(*pools_[id]);
    }

    std::vector<std::unique_ptr<detail::PoolBase>> pools_;
    std::vector<uint32_t> generations_;
    std::vector<uint32_t> free_;
    size_t alive_ = 0;
};

}  // namespace sward
