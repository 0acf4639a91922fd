// A brush stroke in progress: points become stamps, stamps wait in a queue and are worked off tile by tile.
// Does not: know undo; Document keeps the map as it was before.
#pragma once
#include <deque>
#include <glm/glm.hpp>
#include <optional>

#include "brushes/brush.h"
#include "scene/project.h"

namespace sward {

// How metres on the terrain become texels of a map. A map with a tiling factor repeats over the terrain
// (scene/tiling.h): every point falls into its one repeat, where a stroke over the edge goes on at the other; or, of
// heights, turns back as in a mirror.
struct MapScale {
    double width = 1, depth = 1;  // metres that the map covers once
    bool repeats = false, mirrored = false;
    float factor = 1;       // its tiling ...
    float tiling = 0;       // ... as shaders take it
    glm::dvec2 terrain{0};  // metres of the whole terrain, about whose middle strokes are mirrored
};
// Of the terrain that the map's entity has, or the first terrain by name. Fails if there is none.
Result<MapScale> mapScale(const Project& p, const ConstFieldRef& map);

// Where a hand is heading after `metres` more towards (x, z): a vector mean that forgets what lies `reach` behind, so
// that the pointer's whole pixels do not show. Starts at (0, 0): nowhere yet; turning back passes through it.
glm::dvec2 headingAfter(const glm::dvec2& before, double x, double z, double metres, double reach);

class Stroke {
  public:
    // Settings must have passed checkBrush; `firstTurn` is where the numbers of the stamps begin.
    Stroke(const BrushRow& row, const BrushSettings& settings, const MapScale& scale, const MapInfo& info,
           uint32_t firstTurn);

    void moveTo(double x, double z);  // metres; queues stamps
    void end();                       // a stroke that went nowhere paints what it has without a heading
    // All stamps so far are painted.
    bool idle() const { return queue_.empty() && tiles_.count() == 0; }
    // It has painted, or will, on the map. False: all of it lay beside the map.
    bool reached() const { return reached_; }
    // Texels of an integer map went to the end of its range, low or high, and so perhaps less far than they should.
    // Looked for on heights alone.
    bool hitLow() const { return hitLow_; }
    bool hitHigh() const { return hitHigh_; }
    // Paints queued stamps into the map for at most budgetMs, at least one batch of tiles; 0: all of them.
    void pump(Map& map, double budgetMs);

  private:
    void queueStamp(double x, double z, const glm::dvec2& heading);
    void queueMirrored(const Stamp& stamp);
    void queueRepeats(Stamp stamp);
    void queueSpan(const glm::dvec2& first, const glm::dvec2& last, uint32_t turn);
    void queueSpans();
    double shapeAngle(const glm::dvec2& heading) const;
    void queue(const Stamp& stamp);
    double heightAt(const Map& map, const glm::dvec2& texel) const;
    void takeHeights(const Map& map);
    void beginStamp(const Map& map);
    void paintTiles(Map& map, size_t count);
    void paintWhole(Map& map);
    void endStamp(const Map& map);

    const BrushRow* row_;
    BrushSettings settings_;
    MapScale scale_;
    MapInfo info_;
    uint32_t turn_;
    double step_, carry_ = 0;
    glm::dvec2 heading_{0};                          // at the last point
    bool follows_ = false;                           // stamps need a heading
    bool headless_ = false;                          // the first stamp waits until the stroke goes somewhere
    std::vector<std::pair<double, double>> points_;  // the last one, from which the line goes on
    std::optional<glm::dvec2> first_;                // point of the stroke
    std::optional<double> startHeight_;              // there, before the stroke; once it was asked for
    bool reached_ = false, hitLow_ = false, hitHigh_ = false;
    std::deque<Stamp> queue_;
    Map before_;  // as it was before the stamp that is being painted; empty between pumps that left nothing
    Stamp stamp_{};
    TileRange tiles_;  // of the stamp that is being painted; none: between stamps
    size_t nextTile_ = 0;
};

// A brush like this one for each species that grows where its map lies, by the density maps' PATHs: painting with all
// of them at once takes every kind of grass away. Of a map that is no field's: of the first field by name.
std::vector<BrushSettings> speciesBrushes(const Project& p, std::span<const ComponentRow> rows,
                                          const BrushSettings& like);

// The brush as it paints heights of this range: metres at a texel of 0 and of 1 (world/ground.h, heightScale; floats 0
// and 1).
void paintHeights(BrushSettings& brush, const std::pair<double, double>& scale);

// Usage error if a setting is not finite or out of its range, or the mode is no brush.
Status checkBrush(const BrushSettings& brush);

}  // namespace sward
