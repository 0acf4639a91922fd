// What scripts need of the editor's user interface, so that `ui.*` drives real widgets without knowing them.
// Does not: draw; editor/ui/driver.h implements it over the input queue.
// Labels are paths ("Brush/Radius", "Menu/File/Save", "Viewport", "Inspector/lawn.GrassField.maxGeom").
// What lies in a closed menu, another entity's inspector or a scrolled-away place is opened first, as a person would.
#pragma once
#include <array>
#include <filesystem>
#include <string>

#include "core/error.h"

namespace sward {

class UiDriver {
  public:
    virtual ~UiDriver() = default;
    // Presses the left button at the widget's centre. Fails if there is no such widget or it is disabled.
    virtual Status click(const std::string& label) = 0;
    // Presses the right button there.
    virtual Status rightClick(const std::string& label) = 0;
    // A file from the desktop is dropped onto the window.
    virtual Status drop(const std::filesystem::path& file) = 0;
    // Enters a value as a person would: types a number or text, ticks a box, chooses from a list.
    virtual Status set(const std::string& label, const std::string& text) = 0;
    // What the widget shows: a number without unit, "true", the chosen item.
    virtual Result<std::string> get(const std::string& label) = 0;
    // Whether there is such a widget; what hides it is opened to look, of which menus are closed again.
    virtual bool exists(const std::string& label) = 0;
    // "ctrl+z", "f5", "[".
    virtual Status key(const std::string& chord) = 0;
    // Where the widget is on the screen: left, top, right, bottom, in window pixels from the top left.
    virtual Result<std::array<double, 4>> rect(const std::string& label) = 0;
    // The left button, in window pixels; `held`: modifiers that are down meanwhile, as in "ctrl+shift", or "".
    virtual Status drag(double x1, double y1, double x2, double y2, const std::string& held = "") = 0;
    // Builds that many frames; none below 1.
    virtual Status wait(int frames) = 0;
    // PNG of the whole window, the viewport refined.
    virtual Status screenshot(const std::filesystem::path& file) = 0;
};

}  // namespace sward
