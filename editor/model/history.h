// Undo and redo as two stacks of steps, bounded in bytes.
// Does not: decide what a step holds; Document does.
#pragma once
#include "model/document.h"

namespace sward {

class History {
  public:
    // The steps that can be undone hold at most this many bytes, but for the newest.
    explicit History(size_t budgetBytes) : budget_(budgetBytes) {}

    // A new step: what could be redone is forgotten, and the oldest steps go while all together exceed the budget.
    // The newest always stays.
    void push(UndoStep step);
    // Forgets all steps; position() begins at 0.
    void clear();
    // Null if there is none. `forward` false: the step to undo; true: to redo.
    const UndoStep* next(bool forward) const;
    // The step was applied: it moves to the other stack.
    void moved(bool forward);
    // All steps that can be undone, the oldest first, and forgets them.
    std::vector<UndoStep> takeAll();
    // How many steps lie behind the present state, forgotten ones included: undo takes it back.
    uint32_t position() const { return static_cast<uint32_t>(undo_.size()) + forgotten_; }
    size_t bytes() const { return bytes_; }  // of the steps that can be undone
    // Labels of all steps, the oldest first, and how many of them are behind the present state.
    std::vector<std::string> labels() const;
    size_t done() const { return undo_.size(); }

  private:
    struct Entry {
        UndoStep step;
        size_t bytes;
    };
    std::vector<Entry> undo_, redo_;
    size_t budget_, bytes_ = 0;
    uint32_t forgotten_ = 0;
};

// Memory that a step keeps from being freed: tiles of its states before that are not also in its states after, and the
// states themselves.
size_t stepBytes(const UndoStep& step);
// Adds a change to those of a step: a later one to the same component or entity extends the earlier.
void mergeChange(std::vector<Change>& changes, Change change);
// Drops changes that change nothing.
void dropEmptyChanges(std::vector<Change>& changes);
// Puts the project into the state after (forward) or before the changes.
void applyChanges(Project& p, const std::vector<Change>& changes, bool forward);

}  // namespace sward
