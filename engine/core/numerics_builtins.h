// C++ side of the common subset: the GLSL names that formulas may use, for the `real` of the enclosing namespace.
// Included by numerics.h only, once in sward::f32 and once in sward::f64, hence no guard.
// Scalar functions are plain functions, not templates: min(real, int) is then an error here as it is in GLSL.
// Vector min, max, clamp, mix, dot, cross, ... are GLM's, found by their arguments.

using uint = std::uint32_t;
using vec2 = glm::vec<2, real>;
using vec3 = glm::vec<3, real>;
using vec4 = glm::vec<4, real>;
using ivec2 = glm::ivec2;
using mat2 = glm::mat<2, 2, real>;
using mat3 = glm::mat<3, 3, real>;

// Functions of one or two numbers, as GLSL 4.50 section 8 has them; the C library's rounding and domain (log of a
// negative number is not-a-number). round: halves away from zero, where GLSL leaves it open.
inline real abs(real x) { return std::fabs(x); }
inline real sign(real x) { return real(int(x > 0) - int(x < 0)); }
inline real floor(real x) { return std::floor(x); }
inline real ceil(real x) { return std::ceil(x); }
inline real round(real x) { return std::round(x); }
inline real sqrt(real x) { return std::sqrt(x); }
inline real sin(real x) { return std::sin(x); }
inline real cos(real x) { return std::cos(x); }
inline real tan(real x) { return std::tan(x); }
inline real acos(real x) { return std::acos(x); }
inline real atan(real x) { return std::atan(x); }
inline real atan(real y, real x) { return std::atan2(y, x); }
inline real exp(real x) { return std::exp(x); }
inline real log(real x) { return std::log(x); }
inline real log2(real x) { return std::log2(x); }
inline real pow(real x, real y) { return std::pow(x, y); }
inline real min(real a, real b) { return b < a ? b : a; }
inline real max(real a, real b) { return a < b ? b : a; }
inline real clamp(real x, real a, real b) { return min(max(x, a), b); }
inline real mix(real a, real b, real t) { return a * (1 - t) + b * t; }
// The same names for whole numbers. abs of the least int is undefined.
inline int abs(int x) { return x < 0 ? -x : x; }
inline int min(int a, int b) { return b < a ? b : a; }
inline int max(int a, int b) { return a < b ? b : a; }
inline int clamp(int x, int a, int b) { return min(max(x, a), b); }
