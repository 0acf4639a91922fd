// Folders of the outliner: what lies in them, and how it comes there. Each edit is one undo step.
// Does not: draw them (panels/outliner.cpp).
#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "model/document.h"

namespace sward {

// Entities by folder, both by name; "" holds those that lie in none.
std::map<std::string, std::vector<std::string>> entitiesByFolder(const Project& p);
// "folder", or with the next number behind it if there is one.
std::string freeFolder(const Project& p);
// "": out of any folder. Usage error naming an entity that is not there, or a name of blanks.
Status moveToFolder(Document& document, std::span<const std::string> entities, const std::string& folder);
// All that lies in it comes to the other, which may be there already; "" dissolves it. Usage error if there is none.
Status renameFolder(Document& document, const std::string& from, const std::string& to);

}  // namespace sward
