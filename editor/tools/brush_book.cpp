#include "tools/brush_book.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "brushes/shape.h"

namespace sward {
namespace {
constexpr float kFreshMetres = 0.1f;  // a stamp at full strength; a stroke puts about seven over each place
constexpr float kFreshImprint = 2;    // metres that white is above black

// What would be a hill becomes a hollow of its shape.
void turnOver(BrushSettings& brush) {
    brush.value = -brush.value;
    if (brush.blend == HeightBlend::Maximum)
        brush.blend = HeightBlend::Minimum;
    else if (brush.blend == HeightBlend::Minimum)
        brush.blend = HeightBlend::Maximum;
}
}  // namespace

BrushSettings& currentBrush(BrushBook& book) {
    const auto key = std::make_pair(book.tool, book.map);
    const auto it = book.settings.find(key);
    if (it != book.settings.end()) return it->second;
    BrushSettings fresh;
    fresh.radius = 2;
    fresh.strength = 0.5f;
    if (book.tool != kViewTool) fresh.mode = book.tool;
    fresh.map = book.map;
    if (book.kind == MapKind::Heights) fresh.value = fresh.mode == "flatten" ? 0 : kFreshMetres;
    if (fresh.mode == "imprint")
        fresh.value = kFreshImprint, fresh.radius = 8, fresh.strength = 1, fresh.shape = builtInShape("mountain");
    return book.settings.emplace(key, fresh).first->second;
}

glm::vec3& currentColor(BrushBook& book) { return book.colors.try_emplace(book.map, 1.f).first->second; }

BrushSettings strokeBrush(BrushBook& book, bool ctrl, bool shift) {
    BrushSettings brush = currentBrush(book);
    brush.color = currentColor(book);
    brush.mirrorX = book.mirrorX, brush.mirrorZ = book.mirrorZ;
    if (ctrl && shift) {
        brush.mode = "subtract";
    } else if (shift) {
        brush.mode = book.shiftErases && book.kind != MapKind::Heights ? "subtract" : "smooth";
    } else if (ctrl) {
        if (brush.mode == "add")
            brush.mode = "subtract";
        else if (brush.mode == "subtract")
            brush.mode = "add";
        else if (brush.mode == "raise")
            brush.mode = "lower";
        else if (brush.mode == "lower")
            brush.mode = "raise";
        else if (brush.mode == "set")
            brush.value = 0;
        else if (brush.mode == "imprint")
            turnOver(brush);
        else if (brush.mode == "comb" || brush.mode == "direction" || brush.mode == "press")
            brush.mode = "subtract";
    }
    return brush;
}

std::string colorText(const glm::vec3& color) {
    const glm::ivec3 c(glm::round(glm::clamp(color, 0.f, 1.f) * 255.f));
    return fmt::format("#{:02x}{:02x}{:02x}", c.x, c.y, c.z);
}

std::optional<glm::vec3> parseColor(const std::string& text) {
    const std::string digits = text.starts_with('#') ? text.substr(1) : text;
    unsigned value = 0;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    if (digits.size() != 6 || fault != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    return glm::vec3(value >> 16, value >> 8 & 255, value & 255) / 255.f;
}

void growBrush(BrushSettings& brush, int steps) {
    const float radius = brush.radius * std::pow(1.2f, static_cast<float>(steps));
    const float unit = std::pow(10.f, std::floor(std::log10(radius)) - 1);  // two significant digits
    brush.radius = std::clamp(std::round(radius / unit) * unit, 0.05f, 500.f);
}

void strengthenBrush(BrushSettings& brush, int steps) {
    const float strength = brush.strength + 0.1f * static_cast<float>(steps);
    brush.strength = std::clamp(std::round(strength * 20) / 20, 0.05f, 1.f);
}

}  // namespace sward
