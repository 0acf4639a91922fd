// What a new project is to be like: a template by its picture, its size and its relief. Part of the dialog New.
// Does not: make it (app/templates.h).
#pragma once
#include "app/file_tasks.h"
#include "app/thumbnails.h"

namespace sward {

// Paths: "Template/pond", "Size", "Relief". Choosing a template takes its own size and relief.
void drawNewProject(FileDialog& files, Thumbnails& thumbnails);
// A template as a picture above its title; true if it was pressed.
bool drawTemplate(const ProjectTemplate& from, Thumbnails& thumbnails, const ui::TileSize& size, bool chosen);
// The one of that name; null for none.
const ProjectTemplate* findTemplate(const std::vector<ProjectTemplate>& templates, const std::string& name);
// Chooses one with the size and relief that suit it.
void chooseTemplate(NewProject& wish, const ProjectTemplate& from);

}  // namespace sward
