// The command palette: every command by a few letters of its name, and every object of the scene to go to.
// Does not: draw (panels/palette.cpp), nor run anything.
#pragma once
#include <span>
#include <string>
#include <vector>

namespace sward {

struct CommandState;

struct Palette {
    bool open = false, opening = false;
    std::string text;  // what is searched for
    int chosen = 0;    // line of what was found
};

// A line of the palette: a command, or an entity if that is null.
struct PaletteLine {
    const CommandState* state = nullptr;
    std::string label;  // "File › Save", or the entity's name
};

// Opens it with nothing searched for.
void openPalette(Palette& palette);
// How well `text` is what someone meant who typed `typed`: letters of any case, in this order, not all side by side;
// those at the beginnings of words count most, then those that follow each other. 0: it is not; without letters 1.
int paletteMatch(const std::string& typed, const std::string& text);
// What matches, the best first, equals in their given order: commands that can run now, then entities.
std::vector<PaletteLine> paletteLines(const std::string& typed, std::span<const CommandState> states,
                                      const std::vector<std::string>& entities);

}  // namespace sward
