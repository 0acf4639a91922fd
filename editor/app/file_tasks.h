// Opening, saving and leaving a project as menus and keys ask for it: what is being asked of the person meanwhile.
// Does not: draw the dialogs (panels/file_dialog.cpp, panels/unsaved_dialog.cpp).
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/messages.h"
#include "app/templates.h"
#include "app/waiting.h"
#include "model/document.h"

namespace sward {

// The last two are for one field: a map to an image, the file that a field names.
enum class FileTask { None, Open, SaveAs, New, Export, Recording, ExportMap, ChooseFile };
struct FileDialog {
    FileTask task = FileTask::None;
    bool opening = false;                                       // ImGui's popup is to be opened in this frame
    std::filesystem::path folder;                               // whose folders are listed
    std::string path;                                           // what is typed
    std::string bladesWithin;                                   // of an export: metres; empty: all that grow
    std::function<Status(const std::filesystem::path&)> write;  // of a Recording: writes its file
    std::string error;
    std::vector<std::pair<std::string, bool>> entries;  // name, is a project
    std::string field;                                  // PATH of the field that the task is for
    std::vector<std::string> files;  // in the folder, of the kind that the task names; empty where it names folders
    NewProject wish;                 // what a new project is to be like, made from one of these:
    std::vector<ProjectTemplate> templates;
};
// Whether the task names a file, and not a folder.
bool namesFile(FileTask task);
// Whether a file of this name is of the kind that the task names.
bool fitsTask(const FileDialog& files, const Document& document, const std::filesystem::path& name);
// Opens the file dialog for one field of the project.
void requestFieldTask(FileDialog& files, const Document& document, FileTask task, const std::string& field);
// What waits for the answer to "save, discard or cancel".
struct UnsavedDialog {
    std::function<void()> then;  // empty: not asked
    bool opening = false;
    std::string error;
};

// The question what to do about files of the open project that another program changed.
struct OutsideDialog {
    std::map<std::string, FileStamp> files;  // by name; empty: not asked
    std::map<std::string, FileStamp> kept;   // whatever is on disk, the person said that what is open here counts
    std::map<std::string, FileStamp> told;   // about which they were asked, and said nothing yet
    bool opening = false;
    bool saving = false;  // asked before a save; else as soon as it was seen
    std::string error;
};
// Whether what is on disk is another program's, about which the person has not decided.
bool othersOnDisk(const OutsideDialog& outside, const Document& document);
// Asks about such files; but once only, unless it is to be saved over them. True if it asks.
bool askOutside(OutsideDialog& outside, const Document& document, bool saving);
// What is open here counts: later saves replace what is on disk.
void keepOwn(OutsideDialog& outside);
// What is on disk takes the place of what is open here; undo goes back. `taken` runs once it has; errors, as
// Document::takeFromDisk gives them, ask again.
void takeTheirs(OutsideDialog& outside, Document& document, Waiting& waiting, std::function<void()> taken);

// Runs `then` at once, or after the person has answered what to do with unsaved work.
void askFirst(UnsavedDialog& unsaved, const Document& document, std::function<void()> then);
// Opens the file dialog; Open and New ask about unsaved work first. All three must outlive the dialog. Export names the
// scene's .glb, Recording a script, which FileDialog::write writes.
void requestTask(FileDialog& files, UnsavedDialog& unsaved, const Document& document, FileTask task);
// An export that was refused is asked for again: the dialog is back with what was typed, and says why. Nothing while
// another dialog of files is open: false.
bool askAgain(FileDialog& files, const std::filesystem::path& file, const Error& why);
struct SaveParts {
    Document& doc;
    FileDialog& files;
    OutsideDialog& outside;
    Messages& messages;
    Waiting& waiting;
};
// Saves, and says how many files were written, or shows why it failed. A project that was never saved: the dialog asks
// where; one that another program changed: the person is asked whose counts. True if it is saved when this returns, and
// not later.
bool saveNow(const SaveParts& parts);

}  // namespace sward
