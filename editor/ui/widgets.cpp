#include "ui/widgets.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/words.h"

namespace sward::ui {

WidgetBook& currentBook() { return *static_cast<WidgetBook*>(ImGui::GetIO().UserData); }

namespace {

std::string pathOf(const std::string& label) { return currentBook().scope + label; }

// What is shown of a label: the part after the last '/', before "##".
std::string shown(const std::string& label) {
    const size_t slash = label.rfind('/');
    return slash == std::string::npos ? label : label.substr(slash + 1);
}

// IEC 61966-2-1; a picker shows what the screen shows.
float toSrgb(float v) { return v <= 0.0031308f ? 12.92f * std::max(v, 0.f) : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f; }
float fromSrgb(float v) { return v <= 0.04045f ? std::max(v, 0.f) / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); }

// What a person expects of Escape; ImGui does it only with keyboard navigation on, which would take our keys.
void closeOnEscape() {
    if (escapePressed() && !ImGui::GetIO().WantTextInput) ImGui::CloseCurrentPopup();
}

std::string idOf(const std::string& label) { return "##" + pathOf(label); }

}  // namespace

void beginBook(WidgetBook& b) {
    ImGui::GetIO().UserData = &b;
    b.next.clear();
    if (!b.hovering) b.hoverX = b.hoverY = -1;
    b.hovering = b.tooltipDue = false;
    b.scope.clear();
}

void endBook(WidgetBook& b) {
    std::swap(b.widgets, b.next);
    if (!b.editing.empty() && !b.widgets.count(b.editing)) b.editing.clear();
}

Scope::Scope(const std::string& name) : length_(currentBook().scope.size()) { currentBook().scope += name + "/"; }
Scope::~Scope() { currentBook().scope.resize(length_); }

Disabled::Disabled(bool disabled) {
    ImGui::BeginDisabled(disabled);
    currentBook().disabled.push_back(disabled);
}
Disabled::~Disabled() {
    currentBook().disabled.pop_back();
    ImGui::EndDisabled();
}

Widget& record(const std::string& label, Kind kind, const std::string& value) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const ImVec2 clipLow = ImGui::GetWindowDrawList()->GetClipRectMin();
    const ImVec2 clipHigh = ImGui::GetWindowDrawList()->GetClipRectMax();
    const float x = (low.x + high.x) / 2, y = (low.y + high.y) / 2;
    const std::string path = pathOf(label);
    if (currentBook().reveal == path) {
        ImGui::SetScrollFromPosY(y - ImGui::GetWindowPos().y, 0.5f);
        currentBook().reveal.clear();
    }
    Widget& w = currentBook().next[path];
    w = {kind, low.x, low.y, high.x, high.y, value};
    const std::vector<bool>& off = currentBook().disabled;
    w.enabled = std::find(off.begin(), off.end(), true) == off.end();
    w.visible = x >= clipLow.x && x < clipHigh.x && y >= clipLow.y && y < clipHigh.y;
    return w;
}

void recordAt(const std::string& path, const Widget& widget) { currentBook().next[path] = widget; }

bool takeReveal(const std::string& path) {
    const bool wanted = currentBook().reveal == path;
    if (wanted) currentBook().reveal.clear();
    return wanted;
}

bool typing(const WidgetBook& b) { return !b.editing.empty() || !b.typing.empty(); }

const std::string* errorAt(const std::string& label) {
    const auto it = currentBook().errors.find(pathOf(label));
    return it == currentBook().errors.end() ? nullptr : &it->second;
}

void setError(const std::string& label, const std::string& message) {
    if (message.empty())
        currentBook().errors.erase(pathOf(label));
    else
        currentBook().errors[pathOf(label)] = message;
}

void beside(float width, float gap) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;  // where a new line ends
    if (ImGui::GetItemRectMax().x + gap + width <= right) ImGui::SameLine(0, gap);
}

void tooltip(const std::string& text) {
    constexpr double kRestSeconds = 0.45;
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsAnyMouseDown()) return;
    WidgetBook& b = currentBook();
    const ImVec2 corner = ImGui::GetItemRectMin();
    if (b.hoverX != corner.x || b.hoverY != corner.y)
        b.hoverX = corner.x, b.hoverY = corner.y, b.hoverSince = ImGui::GetTime();
    b.hovering = true;
    b.tooltipDue = ImGui::GetTime() - b.hoverSince < kRestSeconds;
    if (b.tooltipDue) return;
    ImGui::BeginTooltip();
    // ImGui measures a tooltip in its first frame and shows it in the next, which must come under a still pointer, too.
    if (ImGui::IsWindowAppearing())
        b.tooltipDue = true;
    else
        b.next["Tooltip"] = {Kind::Label, 0, 0, 0, 0, text};
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool button(const std::string& label, float width, bool accent) {
    if (accent) pushAccent();
    const bool pressed = ImGui::Button((shown(label) + "#" + idOf(label)).c_str(), {width, 0});
    if (accent) popAccent();
    record(label, Kind::Button);
    return pressed;
}

bool checkbox(const std::string& label, bool& value, bool titled) {
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);  // an empty one is seen
    ImGui::PushStyleColor(ImGuiCol_Border, ImU32(kDimText));
    const bool changed = ImGui::Checkbox(((titled ? shown(label) : "") + "#" + idOf(label)).c_str(), &value);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    record(label, Kind::Checkbox, value ? "true" : "false");
    return changed;
}

bool selectable(const std::string& label, bool selected, bool* doubleClicked) {
    const bool pressed = ImGui::Selectable((inWords(shown(label)) + "#" + idOf(label)).c_str(), selected,
                                           ImGuiSelectableFlags_DontClosePopups);
    if (doubleClicked) *doubleClicked = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
    record(label, Kind::Button, selected ? "true" : "false");
    return pressed;
}

bool section(const std::string& label, const std::string& title, bool openAtFirst) {
    const int flags = openAtFirst ? ImGuiTreeNodeFlags_DefaultOpen : 0;
    const bool open = ImGui::CollapsingHeader((title + "##" + idOf(label)).c_str(), flags);
    record(label, Kind::Section, open ? "true" : "false").open = open;
    return open;
}

bool sectionIsOpen(const std::string& label, const std::string& title) {
    return ImGui::GetStateStorage()->GetInt(ImGui::GetID((title + "##" + idOf(label)).c_str())) != 0;
}

bool input(const std::string& label, std::string& text, const char* hint, bool* entered, const LineHelp& help) {
    const bool enter = inputText(idOf(label).c_str(), hint, text, help);
    const bool left = ImGui::IsItemDeactivatedAfterEdit();
    record(label, Kind::Text, text);
    if (entered) *entered = enter;
    return enter || left;
}

std::optional<std::string> textField(const std::string& label, const std::string& value) {
    WidgetBook& b = currentBook();
    const std::string path = pathOf(label);
    std::string shownText = value;
    std::string& text = b.typing == path ? b.typedText : shownText;
    inputText(idOf(label).c_str(), "", text);
    const bool active = ImGui::IsItemActive();
    record(label, Kind::Text, text);
    if (active && b.typing != path) b.typing = path, b.typedText = shownText;
    if (active || b.typing != path) return std::nullopt;
    b.typing.clear();
    return b.typedText != value ? std::optional(b.typedText) : std::nullopt;
}

bool combo(const std::string& label, std::span<const std::string> items, int& chosen) {
    const bool known = chosen >= 0 && chosen < static_cast<int>(items.size());
    const std::string preview = known ? items[static_cast<size_t>(chosen)] : "";
    const std::vector<std::string> words = inWordsApart(items);
    const bool open = ImGui::BeginCombo(idOf(label).c_str(), known ? words[static_cast<size_t>(chosen)].c_str() : "");
    if (!open) {
        record(label, Kind::Combo, preview);
        return false;
    }
    // The button was met before its list; the last item is the list's window now.
    const auto before = currentBook().widgets.find(pathOf(label));
    if (before != currentBook().widgets.end()) (currentBook().next[pathOf(label)] = before->second).open = true;
    closeOnEscape();
    bool changed = false;
    const Scope scope(label);
    for (int i = 0; i < static_cast<int>(items.size()); ++i) {
        const std::string& item = items[static_cast<size_t>(i)];
        if (ImGui::Selectable((words[static_cast<size_t>(i)] + "##" + std::to_string(i)).c_str(), i == chosen)) {
            changed = i != chosen;
            chosen = i;
        }
        record(item, Kind::Button, i == chosen ? "true" : "false");
    }
    ImGui::EndCombo();
    return changed;
}

bool beginMenu(const std::string& label) {
    const bool open = ImGui::BeginMenu(shown(label).c_str());
    if (!open) record(label, Kind::Menu);
    if (open) {
        // The last item is now the menu's window; its button is what the mouse must find, and that was met before.
        Widget& w = currentBook().next[pathOf(label)];
        const auto before = currentBook().widgets.find(pathOf(label));
        if (before != currentBook().widgets.end()) w = before->second;
        w.open = true;
        closeOnEscape();
        currentBook().scope += label + "/";
    }
    return open;
}

void endMenu() {
    ImGui::EndMenu();
    std::string& scope = currentBook().scope;
    const size_t slash = scope.rfind('/', scope.size() - 2);
    scope.resize(slash == std::string::npos ? 0 : slash + 1);
}

bool menuItem(const std::string& label, const std::string& chord, bool checked, bool enabled) {
    const bool pressed =
        ImGui::MenuItem(shown(label).c_str(), chord.empty() ? nullptr : chord.c_str(), checked, enabled);
    record(label, Kind::Button, checked ? "true" : "false").enabled = enabled;
    return pressed;
}

bool colorEdit(const std::string& label, float linear[3]) {
    float srgb[3];
    for (int i = 0; i < 3; ++i) srgb[i] = toSrgb(linear[i]);
    const bool changed = srgbEdit(label, srgb);
    for (int i = 0; i < 3 && changed; ++i) linear[i] = fromSrgb(srgb[i]);
    return changed;
}

bool srgbEdit(const std::string& label, float srgb[3]) {
    const std::string id = idOf(label);
    const ImVec4 shownColor{srgb[0], srgb[1], srgb[2], 1};
    if (ImGui::ColorButton(id.c_str(), shownColor, ImGuiColorEditFlags_NoTooltip)) ImGui::OpenPopup(id.c_str());
    Widget& w = record(label, Kind::Button);
    if (!ImGui::BeginPopup(id.c_str())) return false;
    w.open = true;
    closeOnEscape();
    const int flags = ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoOptions |
                      ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_DisplayRGB |
                      ImGuiColorEditFlags_DisplayHex;
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 14);
    const bool changed = ImGui::ColorPicker3((id + "picker").c_str(), srgb, flags);
    ImGui::EndPopup();
    return changed;
}

}  // namespace sward::ui
