#include "app/image_tasks.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "model/document.h"

namespace sward {
namespace {
namespace fs = std::filesystem;

bool mayBeImage(const fs::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) { return std::tolower(c); });
    for (const char* known : {".png", ".exr", ".tif", ".tiff", ".r16"})
        if (extension == known) return true;
    return false;
}

}  // namespace

void enterFolder(ImageDialog& d, const fs::path& folder) {
    d.folder = folder;
    d.entries.clear();
    std::error_code error;
    for (fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, error), end;
         !error && it != end; it.increment(error)) {
        std::error_code ignored;
        const std::string name = it->path().filename().string();
        const bool isFolder = it->is_directory(ignored);
        if (!name.starts_with('.') && (isFolder || mayBeImage(it->path()))) d.entries.emplace_back(name, isFolder);
    }
    d.error = error ? folder.string() + ": " + error.message() : "";
    std::sort(d.entries.begin(), d.entries.end(),
              [](const auto& a, const auto& b) { return a.second != b.second ? a.second : a.first < b.first; });
}

void requestImage(ImageDialog& d, const Document& document, ImageTask task, const std::string& map) {
    std::error_code error;
    const fs::path project = document.isOpen() ? document.project().dir : fs::path();
    const fs::path folder = fs::is_directory(d.folder, error)  ? d.folder
                            : fs::is_directory(project, error) ? project
                                                               : fs::current_path(error);
    const bool patient = d.patient;
    d = {};
    d.patient = patient;
    d.task = task;
    d.opening = true;
    d.map = map;
    enterFolder(d, folder);
}

void lookAt(ImageDialog& d) {
    const bool known = d.path == d.preview.file, asked = d.reading.active() && d.path == d.readFile;
    if (known && d.reading.active()) d.reading = {};
    if (!known && !asked) {
        d.readFile = d.path;
        d.reading = Job<ImagePreview>(Lane::Waited, "a preview", 0,
                                      [file = d.path](JobControl&) -> Result<ImagePreview> { return previewOf(file); });
    }
    while (d.patient && d.reading.active() && !d.reading.finished())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (const auto read = d.reading.take(0); read && *read) d.preview = std::move(**read);
}

}  // namespace sward
