// What the dialog of screenshots and films asks: the plan as it is typed.
// Does not: draw the dialog (panels/film_dialog.cpp), nor the pictures (app/film.h).
#pragma once
#include <string>

#include "model/document.h"
#include "model/film_plan.h"

namespace sward {

struct FilmDialog {
    bool open = false, opening = false;
    FilmPlan plan;
    std::string out;  // as typed
    std::string error;
};
// Opens it for a film or one picture; size and rate stay as they were used last.
void askFilm(FilmDialog& dialog, const Document& document, bool film);

}  // namespace sward
