// The table of contents: every component, effect and technique of the engine, side by side (techniques.cpp,
// effects.cpp).
#pragma once
#include "scene/technique.h"

namespace sward {

// All rows. The reference stays the same for the process's life.
const Tables& tables();
// The effects among them; programs that draw nothing have none.
std::span<const EffectRow> effectRows();

// Has a technique in the table for as long as it lives, as if techniques.cpp listed it last: for tests, and for
// programs that bring a technique along. Not while a project is drawn or a reference to one of its fields is held;
// those that were added last go first. What it asks for by features must be among the effects.
class AddedTechnique {
  public:
    explicit AddedTechnique(const TechniqueRow& row);
    ~AddedTechnique();
    AddedTechnique(const AddedTechnique&) = delete;
    AddedTechnique& operator=(const AddedTechnique&) = delete;
};

}  // namespace sward
