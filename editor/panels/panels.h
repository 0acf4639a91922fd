// The panels, one row each; a panel is a file of its own beside this one.
// Does not: keep state; that is in EditorApp.
#pragma once
#include <span>

#include "app/app.h"

namespace sward {

enum class Dock { Menu, BrushBar, Tools, Viewport, Outliner, Inspector, Bottom, StatusBar, Dialog };

struct PanelRow {
    const char* name;  // the first part of its widgets' paths
    Dock dock;
    void (*draw)(EditorApp&);
    bool hideable;               // listed in the View menu
    const char* menu = nullptr;  // what it is called there, if not by its name
    bool edits = false;          // greyed while the project is played
};
std::span<const PanelRow> panelRows();
// All of them, each in its area, with the splitters between.
void drawPanels(EditorApp& app);

void drawMenuBar(EditorApp& app);
void drawPlayBar(EditorApp& app);
void drawBrushBar(EditorApp& app);
void drawToolStrip(EditorApp& app);
void drawViewport(EditorApp& app);
void drawOutliner(EditorApp& app);
void drawInspector(EditorApp& app);
void drawConsole(EditorApp& app);
void drawProfiler(EditorApp& app);
void drawTiers(EditorApp& app);
void drawAccuracy(EditorApp& app);
void drawStatusBar(EditorApp& app);
void drawFileDialog(EditorApp& app);
void drawUnsavedDialog(EditorApp& app);
void drawRecoveryDialog(EditorApp& app);

// 627 M, 12.3 k
std::string counted(uint64_t n);

// Heights and widths of what does not follow from the layout, at the present font.
float brushBarHeight(int rows);
float statusBarHeight();
float toolStripWidth();

}  // namespace sward
