// Where the members of the structs that C++ and GLSL share (shaders/shared/*.h) lie. C++ knows neither std140 nor
// std430: the structs' members stand in such an order that all agree, and layout.cpp does not compile where they do
// not. The list is made by CMake from the headers' text (tools/shared_layout.cmake). Source: OpenGL 4.5 core,
// section 7.6.2.2. Does not: say what GL made of a struct; tests/gpu/layout_gl_test.cpp compares this list with linked
// programs.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace sward {

struct SharedMember {
    std::string_view of;    // the struct
    std::string_view type;  // of one element, as the header writes it
    std::string_view name;
    size_t offset;  // bytes from the struct's begin
    size_t stride;  // bytes from one element to the next; of what is no array, its size
    size_t count;   // elements; 1: no array
};
// All members of all shared structs, each struct's in its order.
std::span<const SharedMember> sharedMembers();

}  // namespace sward
