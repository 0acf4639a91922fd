// The project standing on its ground as layers over its heights leave it (world/height_layers.h), from revision to
// revision: for hands and feet. Where a person looks on, what takes long is made on another thread, and until then the
// ground is as it was last.
// Does not: draw it (frame/drawn_beside.h).
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "core/jobs.h"
#include "world/height_layers.h"

namespace sward {

class Standing {
  public:
    bool patient = true;  // whoever asks waits for the end, however long; not to be set again once it is false
    // Of this revision of the project; `p` itself where no layer over the heights does anything. Valid until the
    // project changes or `follow` finds something new.
    const Project& of(const Project& p, uint64_t revision, std::span<const ComponentRow> rows);
    // Between frames: what was made meanwhile is what `of` gives from now on. True if there is something.
    bool follow();
    // Whether the ground is still as it was before.
    bool making() const { return draft_; }

  private:
    // Shared with the thread that works on it.
    struct Maker {
        HeightLayers layers;
        Project of;
        uint64_t revision = 0;
        std::optional<Map> heights;  // none: no layer does anything
    };
    void begin(const Project& p, uint64_t revision, std::span<const ComponentRow> rows);
    void now(const Project& p, uint64_t revision, std::span<const ComponentRow> rows);
    void soon(const Project& p, uint64_t revision, std::span<const ComponentRow> rows);

    std::shared_ptr<Maker> maker_ = std::make_shared<Maker>();
    Job<bool> job_;
    std::optional<Map> heights_;      // as they were made last, of an older revision perhaps
    uint64_t madeOf_ = 0;             // that revision
    std::optional<Project> project_;  // none: as it is
    uint64_t revision_ = 0;
    bool known_ = false, draft_ = false;
};

}  // namespace sward
