// PATHs of fields as people read them: "Lawn › density" for "grass.GrassField.species[lawn].density".
// Does not: know any project; scripts and what is written down keep the PATHs.
#pragma once
#include <span>
#include <string>
#include <vector>

namespace sward::ui {

// The text with each PATH in it (entity.Component.field, lists as species[lawn]) in words: what it belongs to, the
// innermost named element of a list or else the entity, and the field. All else stays.
std::string inWords(const std::string& text);

// A name of a file or struct as it is spelt in what people read: "rootColor" as "rootColour", "centerColor" as
// "centreColour".
std::string spelt(std::string name);

// The same of several texts that stand side by side: where two come to the same words, the entity follows in brackets.
std::vector<std::string> inWordsApart(std::span<const std::string> texts);

}  // namespace sward::ui
