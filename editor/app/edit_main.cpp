#include "app/edit_main.h"

#include <future>

#include "app/app.h"
#include "core/file.h"
#include "core/log.h"
#include "model/bakes.h"
#include "model/scene_export.h"
#include "playtest/playtest.h"
#include "project/project_files.h"
#include "script/script.h"
#include "techniques.h"
#include "ui/driver.h"
#include "ui/widget_list.h"
#include "ui/window.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr double kSaveWaitSeconds = 2;  // the window stands still meanwhile

int exitOf(const Error& error) {
    logError(error.text());
    return static_cast<int>(error.code);
}

void tellWidgets(const std::filesystem::path& file, const ui::WidgetBook& book) {
    if (const Status written = writeFileAtomic(file, ui::widgetList(book)); !written)
        logWarning(written.error().text());
}

// While the window opens, its project is read.
std::future<Result<Project>> readBeside(const std::filesystem::path& project) {
    if (project.empty()) return {};
    return std::async(std::launch::async, [project] { return loadProject(project, tables().components); });
}
Status showRead(Document& document, Result<Project> read) {
    return read ? document.show(std::move(*read)) : Status(read.error());
}

}  // namespace

int editMain(const std::filesystem::path& project, const std::filesystem::path& widgets) {
    std::future<Result<Project>> reading = readBeside(project);
    auto window = ui::openWindow(1440, 900, "Sward");
    if (!window) return exitOf(window.error());
    ui::Surface& surface = **window;
    auto gpu = adoptCurrentGpu();
    if (!gpu) return exitOf(gpu.error());
    Document document(tables());
    document.setSaveWait(kSaveWaitSeconds);
    if (reading.valid())
        if (const Status opened = showRead(document, reading.get()); !opened) return exitOf(opened.error());
    EditorApp app(document, **gpu, std::move(*window), true);
    app.autosave.on = true;
    ui::installClipboard(surface);
    const std::unique_ptr<UiDriver> driver = makeUiDriver(app);
    ScriptHost host{document, driver.get()};
    host.print = [](const std::string& line) { logInfo(line); };
    host.useCamera = [&](const std::string& name) { goToCamera(document, name, app.view.camera); };
    host.playStart = [&app] { return PlayStart{viewOf(app.view.camera), 0, true}; };
    offerBakes(host);
    offerExport(host);
    offerFilms(host, [&app]() -> Result<Gpu*> { return &app.gpu; });
    ScriptConsole console(host);
    app.console.runLua = [&console, &app](const std::string& line) {
        app.recorder.beginLine();
        const Status ran = console.run(line);
        app.recorder.endLine(line, static_cast<bool>(ran));
        return ran;
    };
    app.console.completions = [&console](const std::string& word) { return console.completions(word); };
    if (!widgets.empty()) app.afterFrame = [&widgets](const ui::WidgetBook& book) { tellWidgets(widgets, book); };
    runUntilQuit(app);
    return 0;
}

}  // namespace sward
