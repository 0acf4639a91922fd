// Thin wrappers over Dear ImGui's widgets that write down, each frame, what is on the screen: path -> rectangle, value.
// Scripts and tests find widgets by that path ("Brush/Radius") and then use the real mouse and keyboard on them.
// Does not: lay panels out, nor change any document: widgets hand back what the person did.
// The book of the current ImGui context is bound by beginBook (io.UserData); all calls between NewFrame and Render.
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sward::ui {

enum class Kind { Button, Checkbox, Slider, Text, Combo, Menu, Section, Label, Area, Vector };

struct Widget {
    Kind kind = Kind::Button;
    float x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // window pixels
    std::string value;                     // as text: a number in shortest form, "true", a combo's choice
    bool enabled = true;
    bool visible = true;  // its centre is not scrolled or clipped away
    bool open = false;    // Menu, Combo, Section: what it holds is on the screen
};

using Errors = std::map<std::string, std::string>;  // by path: what was wrong with the last value typed there

struct WidgetBook {
    std::map<std::string, Widget> widgets;  // of the last whole frame
    std::map<std::string, Widget> next;     // of the frame being built
    Errors errors;
    std::string scope;           // "Brush/"
    std::vector<bool> disabled;  // of the Disabled blocks around, outermost first
    std::string reveal;          // path to scroll to when it is next met
    std::string editing;         // path of the number being typed
    std::string editText;
    int editAge = 0;  // frames since typing was asked for
    bool editActive = false;
    float hoverX = -1, hoverY = -1;             // corner of the item with a tooltip under the pointer ...
    double hoverSince = 0;                      // ... and when the pointer came to it (ImGui's clock)
    bool hovering = false, tooltipDue = false;  // in this frame; a tooltip waits to be shown
    std::string typing;                         // path of the textField being typed, and its text
    std::string typedText;
};

// After NewFrame and after Render.
void beginBook(WidgetBook& book);
// What was recorded since beginBook is what scripts and tests find from now on.
void endBook(WidgetBook& book);
// That of the frame being built; only between the two.
WidgetBook& currentBook();

// Widgets inside are recorded as "Name/..." (nested scopes join).
class Scope {
  public:
    // Until the end of its life.
    explicit Scope(const std::string& name);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    size_t length_;
};

// What is inside is greyed and takes no input, and is recorded so.
class Disabled {
  public:
    // Until the end of its life; false changes nothing.
    explicit Disabled(bool disabled);
    ~Disabled();
    Disabled(const Disabled&) = delete;
    Disabled& operator=(const Disabled&) = delete;
};

// Writes down ImGui's last item under the current scope.
Widget& record(const std::string& label, Kind kind, const std::string& value = {});
// Writes down what is no ImGui item, such as a grip drawn over a picture, at a whole path.
void recordAt(const std::string& path, const Widget& widget);
// True once if someone waits for the widget at a whole path to be scrolled into sight; the caller scrolls.
bool takeReveal(const std::string& path);
// A number or a text is being typed, and not yet entered.
bool typing(const WidgetBook& book);
// What was wrong with the value last typed at label; null if nothing.
const std::string* errorAt(const std::string& label);
void setError(const std::string& label, const std::string& message);  // empty: none

// Shown when the pointer has rested on the last item for a moment; empty text shows nothing. Recorded as "Tooltip".
void tooltip(const std::string& text);
// The next widget goes beside the last one, if so much finds room there in its window or column, else on a new line.
void beside(float width, float gap = 6);

// True if it was pressed. Width 0: as the label needs; `accent`: it is the usual choice, or is switched on.
bool button(const std::string& label, float width = 0, bool accent = false);
// True if the value was changed. Not `titled`: the label stands elsewhere.
bool checkbox(const std::string& label, bool& value, bool titled = true);
// A line of a list, PATHs in it shown in words; true if it was pressed.
bool selectable(const std::string& label, bool selected, bool* doubleClicked = nullptr);
// A section that opens and closes; true while open. `title` is what is shown of it.
bool section(const std::string& label, const std::string& title, bool openAtFirst = true);
// Whether a section is open that is not built in this frame; one that never was built is not.
bool sectionIsOpen(const std::string& label, const std::string& title);
// What arrows and Tab make of the text that is being typed; empty functions leave it.
struct LineHelp {
    std::function<std::string(const std::string& text, int step)> recall;  // up: -1, down: 1
    std::function<std::string(const std::string& text)> complete;
};
// One line of text; true when it was changed and left, or Enter was pressed.
bool input(const std::string& label, std::string& text, const char* hint = "", bool* entered = nullptr,
           const LineHelp& help = {});
// A line over a value kept elsewhere: what was typed, once it was left or Enter was pressed; nothing while unchanged.
// Escape gives up.
std::optional<std::string> textField(const std::string& label, const std::string& value);
// PATHs are shown in words (words.h), and recorded as they are. True if another choice was made. Items are recorded as
// label/item while open.
bool combo(const std::string& label, std::span<const std::string> items, int& chosen);
// True while it is open; endMenu then.
bool beginMenu(const std::string& label);
// After the items of an open menu.
void endMenu();
// True if it was chosen. `chord` is shown beside it.
bool menuItem(const std::string& label, const std::string& chord = {}, bool checked = false, bool enabled = true);
// A colour in linear light, edited in a picker behind a swatch; also while the person drags in the picker.
bool colorEdit(const std::string& label, float linear[3]);
// The same of a colour in sRGB.
bool srgbEdit(const std::string& label, float srgb[3]);

// How a number is edited.
struct NumberSpec {
    double softMin = 0, softMax = 1;  // the slider's range; softMin == softMax: dragged without ends
    double hardMin = -1e30, hardMax = 1e30;
    std::string unit;  // shown after the number
    bool integer = false;
    bool precise = false;   // stored as double: positions
    bool allowInf = false;  // "inf" may be typed
    double step = 0;        // of dragging without ends; 0: by the value
};
// What the person did to a number in this frame.
struct NumberEdit {
    bool changed = false;              // `value` was moved; while it is held, frame after frame
    std::optional<std::string> typed;  // entered by keyboard; not yet applied
};
// A slider; a double click or Ctrl+click types instead. The width is ImGui's next item width.
NumberEdit number(const std::string& label, double& value, const NumberSpec& spec);
// The same with typed text applied: parsed, refused beyond the hard range with an error at label. True if changed.
bool slider(const std::string& label, float& value, const NumberSpec& spec);

// "0.5", "12", "inf": the shortest text that gives the same float, or double if precise.
std::string numberText(double value, bool integer = false, bool precise = false);
// A number within [hardMin, hardMax]; else what is wrong with it, in error.
std::optional<double> parseNumber(const std::string& text, const NumberSpec& spec, std::string& error);

}  // namespace sward::ui
