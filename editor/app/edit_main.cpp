#include "app/edit_main.h"

#include "app/app.h"
#include "model/bakes.h"
#include "model/scene_export.h"
#include "playtest/playtest.h"
#include "script/script.h"
#include "techniques.h"
#include "ui/driver.h"
#include "ui/window.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr double kSaveWaitSeconds = 2;  // the window stands still meanwhile

int exitOf(const Error& error) {
    logError(error.text());
    return static_cast<int>(error.code);
}

}  // namespace

int editMain(const std::filesystem::path& project) {
    auto window = ui::openWindow(1440, 900, "Sward");
    if (!window) return exitOf(window.error());
    ui::Surface& surface = **window;
    auto gpu = adoptCurrentGpu();
    if (!gpu) return exitOf(gpu.error());
    Document document(tables());
    document.setSaveWait(kSaveWaitSeconds);
    if (!project.empty())
        if (const Status opened = document.open(project); !opened) return exitOf(opened.error());
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
    runUntilQuit(app);
    return 0;
}

}  // namespace sward
