// Names of GLSL's types in C++, and the mark of a struct that lies in a uniform buffer, for shared/*.h.
// A struct marked STD140 is laid out by that rule: C++ gives it the alignment of a vec4, members stand in such an order
// that both languages agree, and the build checks each member (gpu/layout.h). Other structs lie in storage buffers or
// are attributes. One member a line, its type and name alone before the semicolon: the build reads them.
// Does not: hold structs.
#pragma once
#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
#define STD140 alignas(16)
namespace sward::glsl {
using glm::ivec2;
using glm::mat4;
using glm::uvec2;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = uint32_t;
}  // namespace sward::glsl
namespace sward {
using namespace glsl;
}
#else
#define STD140
#endif
