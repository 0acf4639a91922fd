// Open, Save As, New, Export, and files for single fields: a browser of folders, and of files where one is named. A
// folder that holds project.json is a project and is marked; images and objects are shown as pictures.
#include <imgui.h>

#include <algorithm>
#include <functional>

#include "app/background_work.h"
#include "app/edits.h"
#include "app/file_tasks.h"
#include "app/thumbnails.h"
#include "core/log.h"
#include "model/map_import.h"
#include "panels/new_project.h"
#include "panels/panels.h"
#include "project/project_files.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

namespace fs = std::filesystem;

// How a task is told: the dialog's title, its button, what was done, and what is named.
struct TaskWords {
    const char *title, *action, *done, *named;
};
const TaskWords& wordsOf(FileTask task) {
    static constexpr TaskWords kWords[] = {
        {"", "", "", ""},
        {"Open a project", "Open", "opened", "folder of the project"},
        {"Save the project as", "Save", "saved", "folder of the project"},
        {"New project", "Create", "created", "folder of the project"},
        {"Export the scene", "Export", "exporting", "file, ending in .glb"},
        {"Save the recorded session", "Save", "recorded", "file, ending in .lua"},
        {"Export a map", "Export", "exported", "file, ending in .png, .exr, .tif or .r16"},
        {"Choose a file", "Choose", "chosen:", "file"},
    };
    return kWords[static_cast<size_t>(task)];
}

void list(FileDialog& d, const Document& doc) {
    d.entries.clear();
    d.files.clear();
    std::error_code error;
    for (fs::directory_iterator it(d.folder, fs::directory_options::skip_permission_denied, error), end;
         !error && it != end; it.increment(error)) {
        std::error_code ignored;
        const std::string name = it->path().filename().string();
        if (name.starts_with('.')) continue;
        if (!it->is_directory(ignored)) {
            if (fitsTask(d, doc, it->path())) d.files.push_back(name);
            continue;
        }
        d.entries.emplace_back(name, fs::exists(it->path() / "project.json", ignored));
    }
    if (error) d.error = d.folder.string() + ": " + error.message();
    std::sort(d.entries.begin(), d.entries.end());
    std::sort(d.files.begin(), d.files.end());
}

void enter(FileDialog& d, const Document& doc, const fs::path& folder) {
    d.error.clear();
    const fs::path file = fs::path(d.path).filename();
    d.folder = folder;
    d.path = (namesFile(d.task) ? folder / file : folder).string();
    list(d, doc);
}

// What the dialog works on; all must outlive the edits that it defers.
struct Parts {
    FileDialog& files;
    Document& doc;
    Edits& edits;
    Messages& messages;
    BackgroundWork& work;
    Thumbnails& thumbnails;
    std::function<void()> adopt;  // after the document holds another project
};

// What is typed as metres; nothing: all that grow.
Result<GlbOptions> exportOptions(const std::string& within) {
    GlbOptions options;
    if (within.empty()) return options;
    char* end = nullptr;
    options.bladesWithin = std::strtod(within.c_str(), &end);
    if (*end != 0 || !(*options.bladesWithin >= 0) || !std::isfinite(*options.bladesWithin))
        return usage("\"" + within + "\" is no distance", "write metres, such as 20, or nothing for all that grow");
    return options;
}

Status startExport(const Parts& parts, const fs::path& target) {
    const Result<GlbOptions> options = exportOptions(parts.files.bladesWithin);
    if (!options) return options.error();
    if (!fs::is_directory(target.parent_path()))
        return usage("there is no such folder").at(target.parent_path().string());
    Result<SceneExport> started = startExport(parts.doc, *options, target);
    if (!started) return started.error();
    parts.work.exporting = std::move(*started);
    return {};
}

// The project that the wish describes, made on another thread, and read from its folder.
Result<Project> makeWished(const Tables& tables, const fs::path& target, const ProjectTemplate* from,
                           const NewProject& wish, JobControl& control) {
    if (!from) return newProject(target, tables.components);
    const Status made = makeProject(tables, target, *from, wish);
    return made ? loadProject(target, tables.components, control) : Result<Project>(made.error());
}
void create(const Parts& parts, const fs::path& target, WaitedEnd then) {
    const ProjectTemplate* found = findTemplate(parts.files.templates, parts.files.wish.name);
    const std::optional<ProjectTemplate> from = found ? std::optional(*found) : std::nullopt;
    waitFor(
        parts.work.waiting, "Making " + target.filename().string(),
        [&doc = parts.doc, tables = parts.doc.tables(), target, from,
         wish = parts.files.wish](JobControl& c) -> Result<Taking> {
            Result<Project> made = makeWished(tables, target, from ? &*from : nullptr, wish, c);
            if (!made) return made.error();
            const auto project = std::make_shared<Project>(std::move(*made));
            return Taking([&doc, project] { return doc.show(std::move(*project)); });
        },
        std::move(then));
}

// The map's file is written from a copy of the project.
void writeMapFile(const Parts& parts, const fs::path& target, WaitedEnd then) {
    const auto rows = parts.doc.tables().components;
    const auto copy = std::make_shared<const Project>(snapshot(parts.doc.project(), rows));
    waitFor(
        parts.work.waiting, "Exporting " + target.filename().string(),
        [copy, rows, field = parts.files.field, target](JobControl&) -> Result<Taking> {
            const Status written = exportMap(*copy, rows, field, target);
            return Taking([written] { return written; });
        },
        std::move(then));
}

void perform(const Parts& parts, const fs::path& target, const WaitedEnd& then) {
    Document& doc = parts.doc;
    switch (parts.files.task) {
        case FileTask::Open:
            return openBeside(parts.work.waiting, doc, target, then);
        case FileTask::New:
            return create(parts, target, then);
        case FileTask::SaveAs:
            return saveBeside(parts.work.waiting, doc, target,
                              [then](const auto& written) { then(written ? Status{} : Status{written.error()}); });
        case FileTask::Export:
            return then(startExport(parts, target));
        case FileTask::Recording:
            return then(parts.files.write(target));
        case FileTask::ExportMap:
            return writeMapFile(parts, target, then);
        case FileTask::ChooseFile:
            return editBeside(
                parts.work.waiting, doc, "Reading " + target.filename().string(),
                [field = parts.files.field, target](Document& d, JobControl&) { return chooseFile(d, field, target); },
                then);
        case FileTask::None:
            break;
    }
}

// The dialog closes, or says what was wrong; it comes back for that if something was waited for.
void acted(const Parts& parts, const fs::path& target, const Status& status) {
    FileDialog& d = parts.files;
    if (!status) {
        d.error = status.error().text();
        d.opening = true;
        logWarning(d.error);
        return;
    }
    say(parts.messages, fmt::format("{} {}", wordsOf(d.task).done, target.string()));
    if (d.task == FileTask::Open || d.task == FileTask::New) parts.adopt();
    parts.messages.notice.clear();
    d.task = FileTask::None;
}

void act(const Parts& parts) {
    FileDialog& d = parts.files;
    std::error_code error;
    const fs::path target = fs::absolute(d.path, error).lexically_normal();
    if (d.path.empty())
        return acted(
            parts, target,
            usage(namesFile(d.task) ? "no file is named" : "no folder is named", "type one or choose one above"));
    perform(parts, target, [parts, target](const Status& status) { acted(parts, target, status); });
}

// Those that the task can take, as pictures; a second click is the button below.
void files(const Parts& parts) {
    FileDialog& d = parts.files;
    const float side = ImGui::GetFontSize() * 6;
    const ui::TileSize size{side, side * 0.75f};
    for (const std::string& name : d.files) {
        ui::nextTile(size, &name == &d.files.front());
        const bool seen = ImGui::IsRectVisible({size.width, size.height});
        const Thumbnail* picture = seen ? &fileThumbnail(parts.thumbnails, d.folder, name) : nullptr;
        const fs::path whole = d.folder / name;
        bool twice = false;
        if (ui::tile(name, name, picture ? shownOf(*picture) : ui::Shown{}, size, d.path == whole.string(), &twice))
            d.path = whole.string();
        ui::tooltip(picture && !picture->error.empty() ? name + "\n" + picture->error : name);
        if (twice) parts.edits.deferred.push_back([parts] { act(parts); });
    }
}

void folders(const Parts& parts) {
    FileDialog& d = parts.files;
    const float footer = ImGui::GetFrameHeightWithSpacing() * (d.task == FileTask::Export ? 3 : 2) +
                         ImGui::GetTextLineHeightWithSpacing() * 2 + 8;
    ImGui::BeginChild("folders", {0, -footer}, true);
    for (const auto& [name, project] : d.entries) {
        bool twice = false;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float size = ImGui::GetTextLineHeight();
        ImGui::Indent(size + 6);
        const bool pressed = ui::selectable(name, d.path == (d.folder / name).string(), &twice);
        ImGui::Unindent(size + 6);
        const ImU32 color = project ? ui::kAccent : ui::kDimText;
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        draw.AddRectFilled({at.x + 1, at.y + size * 0.3f}, {at.x + size, at.y + size * 0.9f}, color, 2);
        draw.AddRectFilled({at.x + 1, at.y + size * 0.18f}, {at.x + size * 0.5f, at.y + size * 0.4f}, color, 1);
        if (project) {
            ImGui::SameLine();
            ui::coloredText(ui::kDimText, "  project");
        }
        if (pressed && !namesFile(d.task)) d.path = (d.folder / name).string();
        if (!twice) continue;
        const fs::path folder = d.folder / name;
        if (project && d.task == FileTask::Open)
            parts.edits.deferred.push_back([parts] { act(parts); });
        else
            parts.edits.deferred.push_back([parts, folder] { enter(parts.files, parts.doc, folder); });
    }
    if (d.entries.empty()) ImGui::TextDisabled("No folders here.");
    files(parts);
    ImGui::EndChild();
}

void body(const Parts& parts) {
    FileDialog& d = parts.files;
    if (d.task == FileTask::New && !d.templates.empty()) drawNewProject(d, parts.thumbnails);
    if (ui::button("Up"))
        parts.edits.deferred.push_back([parts] { enter(parts.files, parts.doc, parts.files.folder.parent_path()); });
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(d.folder.c_str());
    ui::record("Folder", ui::Kind::Label, d.folder.string());
    folders(parts);
    ImGui::SetNextItemWidth(-1);
    bool entered = false;
    ui::input("Path", d.path, wordsOf(d.task).named, &entered);
    if (d.task == FileTask::Export) {
        ImGui::SetNextItemWidth(ImGui::GetFontSize() * 16);
        ui::input("Blades Within", d.bladesWithin, "all that grow");
        ImGui::SameLine();
        ImGui::TextDisabled("metres of grass around the first camera");
        ui::tooltip("Only grass and flowers within so many metres of the first camera; nothing: all of them.");
    }
    ImGui::PushTextWrapPos(0);
    ui::coloredText(ui::kErrorText, d.error.empty() ? " " : d.error.c_str());
    ImGui::PopTextWrapPos();
    if (!d.error.empty()) ui::record("Error", ui::Kind::Label, d.error);
    const float width = ImGui::GetFontSize() * 6;
    ImGui::SetCursorPos({ImGui::GetWindowContentRegionMax().x - 2 * width - 8,
                         ImGui::GetWindowContentRegionMax().y - ImGui::GetFrameHeight()});
    const bool cancelled = ui::button("Cancel", width) || (ui::escapePressed() && !ImGui::IsAnyItemActive());
    ImGui::SameLine(0, 8);
    const bool pressed = ui::button(wordsOf(d.task).action, width, true);
    if (pressed || entered) parts.edits.deferred.push_back([parts] { act(parts); });
    if (cancelled) d.task = FileTask::None;
}

}  // namespace

void drawFileDialog(FileDialog& d, Document& doc, Edits& edits, Messages& messages, BackgroundWork& work,
                    Thumbnails& thumbnails, const std::function<void()>& adopt) {
    if (d.task == FileTask::None) return;
    if (std::exchange(d.opening, false) && !ImGui::IsPopupOpen("###files")) {
        ImGui::OpenPopup("###files");
        std::error_code error;
        if (!fs::is_directory(d.folder, error)) d.folder = fs::current_path(error);
        list(d, doc);
    }
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowSize(
        {std::min(screen.x * 0.9f, ImGui::GetFontSize() * 44), std::min(screen.y * 0.85f, ImGui::GetFontSize() * 32)});
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    const std::string title = std::string(wordsOf(d.task).title) + "###files";
    if (!ImGui::BeginPopupModal(title.c_str(), nullptr,
                                ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
        return;
    body({d, doc, edits, messages, work, thumbnails, adopt});
    if (d.task == FileTask::None) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace sward
