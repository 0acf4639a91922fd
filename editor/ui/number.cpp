// Numbers: a slider that a double click or Ctrl+click turns into a text line, so that what is typed may be "inf", may
// leave the slider's range, and may be refused with a message beside it.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>

#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward::ui {
namespace {

constexpr const char* kNoText = " ";  // the widget's own text; ours is drawn over it

std::string format(double value, const NumberSpec& spec) {
    const std::string unit = spec.unit.empty() ? "" : " " + spec.unit;
    if (std::isinf(value)) return "inf" + unit;
    return numberText(value, spec.integer, spec.precise) + unit;
}

// Rounds what a drag gives to about three significant digits of the range.
double rounded(double value, const NumberSpec& spec) {
    if (spec.integer) return std::round(value);
    const double span = spec.softMax > spec.softMin ? spec.softMax - spec.softMin : std::max(std::abs(value), 1.0);
    const double step = std::pow(10.0, std::floor(std::log10(span)) - 2);
    return std::round(value / step) * step;
}

bool wideRange(const NumberSpec& spec) {
    return spec.softMin >= 0 && spec.softMax - spec.softMin >= 1000 * std::max(spec.softMin, 1e-3) &&
           spec.softMax > 100;
}

// The filled part says where in its range the number is, under the number itself.
void drawFill(double value, const NumberSpec& spec, bool logarithmic) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    double share = (value - spec.softMin) / (spec.softMax - spec.softMin);
    if (logarithmic) {
        const double least = std::max(spec.softMin, 1e-3);  // where ImGui takes a logarithmic slider to begin
        share = value <= least ? 0 : std::log(value / least) / std::log(spec.softMax / least);
    }
    const float x = low.x + (high.x - low.x) * static_cast<float>(std::clamp(share, 0.0, 1.0));
    const ImU32 color = ImGui::IsItemActive() ? kFillHeld : ImGui::IsItemHovered() ? kFillHot : kFill;
    if (x > low.x + 1)
        ImGui::GetWindowDrawList()->AddRectFilled(low, {x, high.y}, color, ImGui::GetStyle().FrameRounding);
}

void drawText(const std::string& text) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax(),
                 size = ImGui::CalcTextSize(text.c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(low, high, true);
    list.AddText({std::max(low.x + 3, (low.x + high.x - size.x) / 2), (low.y + high.y - size.y) / 2},
                 ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    list.PopClipRect();
}

NumberEdit drag(const std::string& id, double& value, const NumberSpec& spec) {
    NumberEdit edit;
    double moved = value;
    const bool logarithmic = wideRange(spec);
    const int flags =
        ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    bool changed;
    ImGui::PushStyleColor(ImGuiCol_SliderGrab, 0);
    ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, 0);
    if (spec.softMax > spec.softMin) {
        if (std::isinf(moved)) moved = spec.softMax;
        changed =
            ImGui::SliderScalar(id.c_str(), ImGuiDataType_Double, &moved, &spec.softMin, &spec.softMax, kNoText, flags);
        drawFill(value, spec, logarithmic);
    } else {
        const double speed = spec.step > 0 ? spec.step : std::max(std::abs(value), 1.0) * 0.005;
        const int dragFlags = ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat;
        changed = ImGui::DragScalar(id.c_str(), ImGuiDataType_Double, &moved, static_cast<float>(speed), nullptr,
                                    nullptr, kNoText, dragFlags);
    }
    ImGui::PopStyleColor(2);
    if (changed && ImGui::IsMouseDragging(0, 2)) {  // a click alone, such as the first of two, changes nothing
        moved = std::clamp(rounded(moved, spec), spec.hardMin, spec.hardMax);
        edit.changed = moved != value;
        value = moved;
    }
    drawText(format(value, spec));
    return edit;
}

// The text line in the slider's place. Escape leaves the value as it was.
NumberEdit type(const std::string& id, double value, const NumberSpec& spec) {
    NumberEdit edit;
    WidgetBook& b = currentBook();
    if (b.editAge == 0) focusNext();
    const bool entered = inputText((id + "#edit").c_str(), "", b.editText);
    const bool active = ImGui::IsItemActive();
    const bool left = entered || (b.editActive && !active) || (!active && ++b.editAge > 4);
    if (active) b.editAge = 1;
    b.editActive = active;
    if (left) {
        if (b.editText != numberText(value, spec.integer, spec.precise)) edit.typed = b.editText;
        b.editing.clear();
    }
    return edit;
}

}  // namespace

NumberEdit number(const std::string& label, double& value, const NumberSpec& spec) {
    WidgetBook& b = currentBook();
    const std::string path = b.scope + label, id = "##" + path;
    NumberEdit edit;
    if (b.editing == path) {
        edit = type(id, value, spec);
    } else {
        edit = drag(id, value, spec);
        const bool ask = ImGui::IsItemHovered() &&
                         (ImGui::IsMouseDoubleClicked(0) || (ImGui::GetIO().KeyCtrl && ImGui::IsMouseClicked(0)));
        if (ask) {
            b.editing = path;
            b.editText = numberText(value, spec.integer, spec.precise);
            b.editAge = 0;
            b.editActive = false;
            edit.changed = false;
        }
    }
    record(label, Kind::Slider, numberText(value, spec.integer, spec.precise));
    return edit;
}

bool slider(const std::string& label, float& value, const NumberSpec& spec) {
    double v = value;
    NumberEdit edit = number(label, v, spec);
    if (edit.typed) {
        std::string error;
        const std::optional<double> parsed = parseNumber(*edit.typed, spec, error);
        setError(label, error);
        if (parsed) v = *parsed, edit.changed = true;
    } else if (edit.changed) {
        setError(label, "");
    }
    if (!edit.changed) return false;
    value = static_cast<float>(v);
    return true;
}

std::string numberText(double value, bool integer, bool precise) {
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    if (value == 0) value = 0;  // without a minus
    if (integer) return fmt::format("{}", static_cast<long long>(value));
    return precise ? fmt::format("{}", value) : fmt::format("{}", static_cast<float>(value));
}

std::optional<double> parseNumber(const std::string& text, const NumberSpec& spec, std::string& error) {
    error.clear();
    char* end = nullptr;
    const double v = std::strtod(text.c_str(), &end);
    while (end && *end == ' ') ++end;
    const std::string rest = end ? end : "";
    const bool number = end != text.c_str() && (rest.empty() || rest == spec.unit) && !std::isnan(v);
    if (!number)
        error = "'" + text + "' is not a number";
    else if (std::isinf(v) && !(spec.allowInf && v > 0))
        error = "infinity is not a value here";
    else if (!std::isinf(v) && (v < spec.hardMin || v > spec.hardMax))
        error = fmt::format("{} is outside {} to {}", text, numberText(spec.hardMin), numberText(spec.hardMax));
    else if (spec.integer && v != std::floor(v))
        error = "'" + text + "' is not a whole number";
    return error.empty() ? std::optional(v) : std::nullopt;
}

}  // namespace sward::ui
