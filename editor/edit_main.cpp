#include "edit_main.h"

#include "app.h"
#include "techniques.h"
#include "ui/window.h"

namespace sward {
namespace {

int failed(const Error& error) {
    logError(error.text());
    return static_cast<int>(error.code);
}

}  // namespace

int editMain(const std::filesystem::path& project) {
    auto window = ui::openWindow(1440, 900, "Sward");
    if (!window) return failed(window.error());
    ui::Surface& surface = **window;
    auto gpu = adoptCurrentGpu();
    if (!gpu) return failed(gpu.error());
    Document document(tables());
    if (!project.empty())
        if (const Status opened = document.open(project); !opened) return failed(opened.error());
    EditorApp app(document, **gpu, std::move(*window), true);
    ui::installClipboard(surface);
    runUntilQuit(app);
    return 0;
}

}  // namespace sward
