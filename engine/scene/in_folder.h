// In which folder of the editor's outliner an entity lies. A folder is its name: it is there while anything lies in it.
// Does not: move, hide or draw anything; folders are for people alone.
#pragma once
#include <string>

#include "scene/project.h"
#include "scene/rows.h"

namespace sward {

struct InFolder {
    std::string folder;  // as it is shown; empty: as if the component were not there
};

const ComponentRow& inFolderRow();
// "" for what lies in none, and for names of no entity.
std::string folderOf(const Project& p, const std::string& entity);

}  // namespace sward
