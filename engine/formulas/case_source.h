// The text of a formula, as it stands in shaders/numerics: what C++, GLSL and the graphs of hard cases all run.
// Does not: parse; it finds a function by its name at the beginning of a line, as the files are laid out.
#pragma once
#include <filesystem>
#include <string>

#include "core/error.h"
#include "formulas/case_curve.h"

namespace sward {

// Where a curve's formula lies.
std::filesystem::path caseFile(const CaseCurve& curve);
// All overloads of FN `function` in the text of such a file, each with the comment above it; empty if there is none.
std::string functionText(const std::string& file, const std::string& function);
// Ours of a curve and every printed form beside it in its file. Failed if the file cannot be read.
Result<std::string> caseText(const CaseCurve& curve);

}  // namespace sward
