// How rows of formulas are written; for the formulas_*.cpp files only.
// clang-format off: bodies are laid out as the shader lines that they become
#pragma once
#include <cmath>
#include <limits>

#include "formulas/formula_rows.h"

// The GLSL names of a formula namespace, ahead of the C library's of the same name.
#define SWARD_NUMERICS(ns)                                                                                   \
    using namespace ns;                                                                                      \
    using ns::abs, ns::sign, ns::floor, ns::ceil, ns::round, ns::sqrt, ns::sin, ns::cos, ns::atan, ns::acos; \
    using ns::exp, ns::log, ns::log2, ns::pow, ns::min, ns::max, ns::clamp, ns::mix, ns::real, ns::vec2;     \
    using ns::vec3, ns::vec4

// A body written once: float, double and text.
#define BODY(...)                            \
    FormulaBody {                            \
        [](const float* x, float* y) {       \
            SWARD_NUMERICS(sward::f32);      \
            (void)x;                         \
            __VA_ARGS__                      \
        },                                   \
            [](const double* x, double* y) { \
                SWARD_NUMERICS(sward::f64);  \
                (void)x;                     \
                __VA_ARGS__                  \
            },                               \
            #__VA_ARGS__                     \
    }

namespace sward {

// Seeded floats for sweeps; the same on every machine (std distributions are not).
class Sweep {
  public:
    explicit Sweep(uint32_t seed) : state_(seed) {}
    // 32 random bits; each call gives the next.
    uint32_t bits() { return state_ = f64::hash2(state_, 1u); }
    // Uniform in [0,1), exactly a float.
    double unit() { return double(f32::hashUnit(bits())); }
    // Uniform in [a, b), rounded to float.
    double in(double a, double b) { return double(float(a + (b - a) * unit())); }
    // Log-uniform in [a, b], a > 0.
    double size(double a, double b) { return double(float(std::exp(in(std::log(a), std::log(b))))); }
    // Uniform whole number in [a, b].
    int whole(int a, int b) { return a + int(bits() % uint32_t(b - a + 1)); }
    // A direction, uniform over the sphere.
    std::vector<double> direction();

  private:
    uint32_t state_;
};

// Samples from a group of the expected values: inputs and wanted outputs are fields, flattened in order. `unit` gives
// the scale of output i of a record; nullptr: 1. Records for which a field is missing are skipped.
using FormulaUnit = double (*)(const ExpectedRecord& record, size_t output, double want);
std::function<FormulaSamples(const ExpectedValues&)> fromGroup(std::string group, std::vector<std::string> inputs,
                                                               std::vector<std::string> outputs,
                                                               FormulaUnit unit = nullptr);
// Samples whose wanted values the double form gives: `make` returns the inputs of one sample.
std::function<FormulaSamples(const ExpectedValues&)> sweep(int count,
                                                           std::function<std::vector<double>(Sweep&, int)> make);
// Samples written out; wanted values from the double form if `want` is empty.
std::function<FormulaSamples(const ExpectedValues&)> listed(std::vector<std::vector<double>> inputs,
                                                            std::vector<std::vector<double>> want = {});

// FormulaUnit of relative errors: |want|, or 1 where want is 0.
double relativeUnit(const ExpectedRecord& record, size_t output, double want);
// |got - want| / max(|want|, scale): relative, absolute below scale.
double relativeError(double got, double want, double scale);
// Distance on the circle of [0, 1).
double circleError(double got, double want, double scale);
// How far got is above want: for bounds, where less is fine.
double excessError(double got, double want, double scale);

// The wind's inputs as the engine hands them to a shader: phases of the 8 m cell and the time, wrapped in double; place
// in the cell. The last three are the raw position and time, for the published form.
std::vector<double> windInputs(double px, double pz, double t, const double c[3], double eps);

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Each appends the rows of one formulas_*.cpp to `rows`; formulaRows calls all of them.
void addHybridRows(std::vector<FormulaRow>& rows);
void addHybridShapeRows(std::vector<FormulaRow>& rows);
void addForestRows(std::vector<FormulaRow>& rows);
void addRayRows(std::vector<FormulaRow>& rows);
void addBladeRows(std::vector<FormulaRow>& rows);
void addSceneRows(std::vector<FormulaRow>& rows);
void addAgreementRows(std::vector<FormulaRow>& rows);

}  // namespace sward
