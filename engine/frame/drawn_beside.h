// The project as it is drawn (world/drawn_project.h), made on another thread where that takes long: layers over maps of
// 4096 x 4096 texels take seconds. What was shown before is shown until then.
// Does not: ask for another picture once it is there; `news` tells. Cost: a copy of all components more than
// DrawnProject, where layers or paths change something.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/jobs.h"
#include "world/drawn_project.h"

namespace sward {

class DrawnBeside {
  public:
    // As DrawnProject::of, however long it takes.
    const Project& now(const Project& p, std::span<const ComponentRow> rows);
    // The same if it is there soon, within some 30 ms; else what was shown last of this project, or `p` as painted.
    const Project& soon(const Project& p, std::span<const ComponentRow> rows);
    // Of what was shown last.
    const std::vector<LayerNote>& layerNotes() const { return notes_; }
    // What is being made, if anything is.
    void news(std::vector<JobNews>& out) const;

  private:
    // Shared with the thread that works on it.
    struct Maker {
        DrawnProject drawn;
        Project of;  // a copy of what was asked for
        const Project* made = nullptr;
    };
    void take(std::span<const ComponentRow> rows);
    void begin(const Project& p, std::span<const ComponentRow> rows);

    std::shared_ptr<Maker> maker_ = std::make_shared<Maker>();
    Job<bool> job_;
    std::optional<Project> shown_;
    std::vector<LayerNote> notes_;
};

}  // namespace sward
