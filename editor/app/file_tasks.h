// Opening, saving and leaving a project as menus and keys ask for it: what is being asked of the person meanwhile.
// Does not: draw the dialogs (panels/file_dialog.cpp, panels/unsaved_dialog.cpp).
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/messages.h"
#include "model/document.h"

namespace sward {

enum class FileTask { None, Open, SaveAs, New, Export };
struct FileDialog {
    FileTask task = FileTask::None;
    bool opening = false;          // ImGui's popup is to be opened in this frame
    std::filesystem::path folder;  // whose folders are listed
    std::string path;              // what is typed
    std::string bladesWithin;      // of an export: metres; empty: all that grow
    std::string error;
    std::vector<std::pair<std::string, bool>> entries;  // name, is a project
};
// What waits for the answer to "save, discard or cancel".
struct UnsavedDialog {
    std::function<void()> then;  // empty: not asked
    bool opening = false;
    std::string error;
};

// Runs `then` at once, or after the person has answered what to do with unsaved work.
void askFirst(UnsavedDialog& unsaved, const Document& document, std::function<void()> then);
// Opens the file dialog; Open and New ask about unsaved work first. All three must outlive the dialog. Export names the
// scene's .glb.
void requestTask(FileDialog& files, UnsavedDialog& unsaved, const Document& document, FileTask task);
// Saves, and says how many files were written. False if it failed, which is shown; or if the project was never saved:
// then the dialog asks where.
bool saveNow(Document& document, FileDialog& files, Messages& messages);

}  // namespace sward
