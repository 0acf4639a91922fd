#include "model/history.h"

#include <unordered_set>

#include "model/field_walk.h"

namespace sward {
namespace {

const std::shared_ptr<void>& state(const Change& c, bool forward) { return forward ? c.after : c.before; }

void collectTiles(const ComponentRow& row, const void* component, std::unordered_set<const Tile*>& tiles, size_t& own) {
    eachMap(row.fields, component, [&](const MapField& field) {
        for (int ty = 0; ty < field.map.tilesY(); ++ty)
            for (int tx = 0; tx < field.map.tilesX(); ++tx) tiles.insert(field.map.tile(tx, ty).get());
        own += size_t(field.map.tilesX()) * size_t(field.map.tilesY()) * sizeof(std::shared_ptr<const Tile>);
    });
}

}  // namespace

size_t stepBytes(const UndoStep& step) {
    constexpr size_t kComponentBytes = 1024;  // about what one holds beside its maps
    std::unordered_set<const Tile*> before, after;
    size_t bytes = 0;
    for (const Change& c : step.changes) {
        bytes += 2 * kComponentBytes;
        if (c.row && c.before) collectTiles(*c.row, c.before.get(), before, bytes);
        if (c.row && c.after) collectTiles(*c.row, c.after.get(), after, bytes);
    }
    for (const Tile* tile : before)
        if (!after.contains(tile)) bytes += tile->heldBytes();
    return bytes;
}

void mergeChange(std::vector<Change>& changes, Change change) {
    for (Change& c : changes)
        if (c.entity == change.entity && c.row == change.row) {
            c.after = std::move(change.after);
            return;
        }
    changes.push_back(std::move(change));
}

void dropEmptyChanges(std::vector<Change>& changes) {
    std::erase_if(changes, [](const Change& c) {
        if (!c.before || !c.after) return !c.before && !c.after;
        return !c.row || sameFields(c.row->fields, c.before.get(), c.after.get());
    });
}

// Entities come first and go last, so that components always find theirs whatever the order of the changes.
void applyChanges(Project& p, const std::vector<Change>& changes, bool forward) {
    for (const Change& c : changes)
        if (!c.row && state(c, forward) && !p.entities.contains(c.entity)) CHECK(bool(addEntity(p, c.entity)));
    for (const Change& c : changes) {
        if (!c.row) continue;
        const Entity e = findEntity(p, c.entity);
        if (const void* value = state(c, forward).get())
            c.row->assign(p.registry, e, value);
        else
            c.row->remove(p.registry, e);
    }
    for (const Change& c : changes)
        if (!c.row && !state(c, forward)) removeEntity(p, c.entity);
}

void History::push(UndoStep step) {
    redo_.clear();
    const size_t bytes = stepBytes(step);
    undo_.push_back({std::move(step), bytes});
    bytes_ += bytes;
    size_t gone = 0;
    for (; bytes_ > budget_ && gone + 1 < undo_.size(); ++gone) bytes_ -= undo_[gone].bytes;
    undo_.erase(undo_.begin(), undo_.begin() + static_cast<std::ptrdiff_t>(gone));
    forgotten_ += static_cast<uint32_t>(gone);
}

std::vector<UndoStep> History::takeAll() {
    std::vector<UndoStep> steps;
    for (Entry& e : undo_) steps.push_back(std::move(e.step));
    clear();
    return steps;
}

void History::clear() { *this = History(budget_); }

std::vector<std::string> History::labels() const {
    std::vector<std::string> out;
    for (const Entry& e : undo_) out.push_back(e.step.label);
    for (auto e = redo_.rbegin(); e != redo_.rend(); ++e) out.push_back(e->step.label);
    return out;
}

const UndoStep* History::next(bool forward) const {
    const std::vector<Entry>& stack = forward ? redo_ : undo_;
    return stack.empty() ? nullptr : &stack.back().step;
}

void History::moved(bool forward) {
    std::vector<Entry>&from = forward ? redo_ : undo_, &to = forward ? undo_ : redo_;
    to.push_back(std::move(from.back()));
    from.pop_back();
    if (forward)
        bytes_ += to.back().bytes;
    else
        bytes_ -= to.back().bytes;
}

}  // namespace sward
