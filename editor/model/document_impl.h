// What a Document keeps: for its own sources alone (document.cpp, document_strokes.cpp).
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

#include "model/document.h"
#include "model/document_listener.h"
#include "model/field_walk.h"
#include "model/history.h"
#include "model/standing.h"
#include "playtest/playtest.h"
#include "project/project_files.h"
#include "tools/stroke.h"

namespace sward {

struct Document::Impl {
    Tables tables;
    History history;
    std::optional<Project> project;
    Project saved;                    // as it is on disk
    std::optional<uint32_t> savedAt;  // History::position of that state; nothing: no step leads there
    uint64_t revision = 1;
    std::unique_ptr<Playtest> play;
    struct {
        uint64_t revision = 0;
        bool value = false;
    } dirtyAt;
    struct {
        uint64_t revision = 0;
        std::optional<Project> project;  // none: nothing is hidden
    } visible;
    Standing standing;

    uint64_t copyOf = 0;  // of a copy to work on: the revision that it was made of
    double saveWaitSeconds = kLockWaitSeconds;
    int groupDepth = 0;
    UndoStep group;
    DocumentListener* listener = nullptr;

    struct StrokePart {
        std::string path;  // canonical
        Stroke work;
    };
    struct ActiveStroke {
        std::vector<StrokePart> parts;  // one a map
        std::vector<Change> changes;    // one a component; `after` is filled in at the end
        std::string label;              // "Comb lawn.GrassField.orientation"
        glm::dvec2 last{0};             // point
        double metres = 0;              // that it went
        bool ended = false;
        StrokeNews news;
        // "Comb lawn.GrassField.orientation, 42 m"
        std::string told() const { return metres > 0 ? fmt::format("{}, {:.3g} m", label, metres) : label; }
        bool idle() const {
            return std::all_of(parts.begin(), parts.end(), [](const StrokePart& p) { return p.work.idle(); });
        }
    };
    std::optional<ActiveStroke> stroke;
    struct {
        std::map<std::string, Map> before;  // what it paints, as it was, by PATH
        uint64_t revision = 0;              // that it left
    } lastStroke;

    Impl(const Tables& t, size_t undoBytes) : tables(t), history(undoBytes) {}
    std::span<const ComponentRow> rows() const { return tables.components; }

    std::shared_ptr<void> stateOf(const std::string& entity, const ComponentRow& row) const {
        const void* value = componentOf(*project, entity, row);
        return value ? row.clone(value) : nullptr;
    }
    Status notPlayed() const;
    Status ready() const;  // open, and not played
    void show(Project p);
    void noteSaved();  // the project is as on disk
    void push(UndoStep step);
    void become(const Project& other, const std::string& label);  // in one undo step
    void record(const std::string& label, std::vector<Change> changes, const StrokeNews* stroke = nullptr);
    void push(UndoStep step, const StrokeNews* stroke);
    Status changeField(const std::string& label, const FieldRef& field, const std::function<Status()>& edit);
    std::vector<const void*> layeredMaps(const std::string& entity) const;
    void followMaps(const std::string& entity, const std::vector<const void*>& maps);
    Result<StrokePart> strokePart(const BrushSettings& brush, bool create, uint32_t turn);
    void pump(double budgetMs);
    void letGo();  // no more points
    void finishStroke();
    bool step(bool forward);
};

}  // namespace sward
