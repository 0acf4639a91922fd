#include "app/film_dialog.h"

namespace sward {

void askFilm(FilmDialog& d, const Document& doc, bool film) {
    const std::vector<std::string> paths = filmPaths(doc.project());
    d.plan.film = film;
    d.plan.path = film && !paths.empty() ? paths.front() : "";
    d.plan.from = 0;
    d.plan.seconds = d.plan.path.empty() ? 10 : 0;
    d.out = freePictureName(d.plan, doc.project()).string();
    d.error.clear();
    d.open = d.opening = true;
}

}  // namespace sward
