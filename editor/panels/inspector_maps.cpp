#include "panels/inspector_maps.h"

#include <fmt/format.h>
#include <imgui.h>

#include "app/file_tasks.h"
#include "app/image_tasks.h"
#include "app/thumbnails.h"
#include "app/waiting.h"
#include "model/layer_edits.h"
#include "model/whole_map.h"
#include "tools/brush_book.h"
#include "ui/theme.h"

namespace sward {
namespace {

ui::TileSize pictureSize() { return {ImGui::GetFrameHeight() * 2, ImGui::GetFrameHeight() * 2}; }

std::string sizeText(const Project& p, const ConstFieldRef& f, const MapField& m) {
    const size_t layers = layersOver(p, f.path).size();
    const std::string over = layers == 0 ? "" : fmt::format(", {} layer{} over it", layers, layers > 1 ? "s" : "");
    if (!m.present()) return "none" + over;
    const MapInfo& i = m.map.info();
    const char* type = i.type == PixelType::U8 ? "8 bit" : i.type == PixelType::U16 ? "16 bit" : "float";
    if (f.row->map->role == MapRole::Density && unpainted(m.map))
        return layers ? "nothing painted" + over : "nothing painted yet";
    return fmt::format("{} x {}, {}", i.width, i.height, type);
}

bool smallButton(const std::string& path, const char* name, const char* help) {
    const bool pressed = ImGui::SmallButton((std::string(name) + "##" + path).c_str());
    ui::record(path + "/" + name, ui::Kind::Button);
    ui::tooltip(help);
    return pressed;
}

void ask(const FieldParts& parts, FileTask task, const std::string& path) {
    parts.edits.deferred.push_back(
        [&files = *parts.files, &doc = parts.doc, task, path] { requestFieldTask(files, doc, task, path); });
}

// As the menu Brush does with the map that is painted.
void fill(const FieldParts& parts, const std::string& path) {
    const BrushBook& book = *parts.brushes;
    BrushSettings brush = book.map == path ? currentBrush(*parts.brushes) : BrushSettings{};
    brush.map = path;
    if (const auto color = book.colors.find(path); color != book.colors.end()) brush.color = color->second;
    parts.edits.deferred.push_back([&doc = parts.doc, &waiting = *parts.waiting, &messages = parts.messages, brush] {
        editBeside(
            waiting, doc, "Filling " + brush.map, [brush](Document& d, JobControl&) { return fillMap(d, brush); },
            [&messages](const Status& done) { accept(messages, done); });
    });
}

bool canFill(MapKind kind) { return kind != MapKind::Heights && kind != MapKind::Forces; }

void mapButtons(const FieldParts& parts, const ConstFieldRef& f, bool present) {
    if (smallButton(f.path, "Import", "Reads an image file into this map."))
        parts.edits.deferred.push_back([&images = *parts.images, &doc = parts.doc, path = f.path] {
            requestImage(images, doc, ImageTask::Map, path);
        });
    if (canFill(f.row->map->kind)) {
        ImGui::SameLine(0, 2);
        if (smallButton(f.path, "Fill",
                        "Fills all of the map with what the brush lays on it: amounts with 1, unless it "
                        "is set otherwise."))
            fill(parts, f.path);
    }
    if (!present) return;
    ImGui::SameLine(0, 2);
    if (smallButton(f.path, "Export", "Writes this map to an image file, as its layers leave it."))
        ask(parts, FileTask::ExportMap, f.path);
}

}  // namespace

void drawMapField(const FieldParts& parts, const ConstFieldRef& f) {
    const MapField& m = *static_cast<const MapField*>(f.value);
    const std::string text = sizeText(parts.doc.project(), f, m);
    if (parts.thumbnails && m.present()) {
        ui::picture(f.path + "/Picture", shownOf(mapThumbnail(*parts.thumbnails, f.path, m.map, f.row->map->kind)),
                    pictureSize());
        ui::tooltip(m.file);
        ImGui::SameLine(0, 6);
    }
    ImGui::BeginGroup();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text.c_str());
    ui::record(f.path, ui::Kind::Label, m.present() ? m.file : "");
    ui::record(f.path + "/Texels", ui::Kind::Label, text);
    if (m.present()) ui::tooltip(m.file);
    if (parts.files && parts.images && parts.brushes && parts.waiting) {
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {3, ImGui::GetStyle().FramePadding.y});
        mapButtons(parts, f, m.present());
        ImGui::PopStyleVar();
    }
    ImGui::EndGroup();
}

void drawFileField(const FieldParts& parts, const ConstFieldRef& f) {
    const std::string& name = *static_cast<const std::string*>(f.value);
    if (!name.empty()) {
        const Thumbnail& picture = fileThumbnail(*parts.thumbnails, parts.doc.project().dir, name);
        ui::picture(f.path + "/Picture", shownOf(picture), pictureSize());
        ui::tooltip(picture.error.empty() ? name : picture.error);
        ImGui::SameLine(0, 6);
    }
    ImGui::BeginGroup();
    ImGui::SetNextItemWidth(-1);
    if (const auto typed = ui::textField(f.path, name)) setField(parts, f.path, *typed, "Inspector/" + f.path);
    if (smallButton(f.path, "Browse", "Chooses a file; one from elsewhere is copied into the project."))
        ask(parts, FileTask::ChooseFile, f.path);
    ImGui::EndGroup();
}

}  // namespace sward
