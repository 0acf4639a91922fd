// The document's strokes: begun, painted in pieces, told of, and one undo step each.
#include "core/log.h"
#include "model/document_impl.h"
#include "model/field_walk.h"
#include "model/new_map.h"
#include "scene/map_fields.h"

namespace sward {
namespace {

Status checkTarget(const ConstFieldRef& field, const BrushSettings& brush, bool create) {
    const auto& target = *static_cast<const MapField*>(field.value);
    if (!target.present() && !create)
        return usage(field.path + ": there is no map to paint on", "create or import one first");
    const MapKind kind = field.row->map->kind;
    if (!paints(*findBrush(brush.mode, kind), kind))
        return usage(fmt::format("{}: the brush \"{}\" does not paint {}", field.path, brush.mode, kindName(kind)),
                     "use " + brushesFor(kind));
    return {};
}

// Metres at 0 and 1 of a map of heights, present or to be made.
std::pair<double, double> heightScaleOf(const ConstFieldRef& field) {
    const auto& target = *static_cast<const MapField*>(field.value);
    if (!target.present() || target.map.info().type == PixelType::F32) return {0.0, 1.0};
    const auto range = *static_cast<const glm::dvec2*>(fieldBeside(field, *field.row->map->heightRange).value);
    return {range.x, range.y - range.x};
}

// The brush as it paints this map: its limits, and what is known of its texels.
Result<BrushSettings> settingsFor(const ConstFieldRef& field, const BrushSettings& brush) {
    BrushSettings settings = brush;
    settings.low = 0, settings.high = 1;
    const MapKind kind = field.row->map->kind;
    settings.colours = kind == MapKind::Colours;
    if (kind != MapKind::Heights) return settings;
    const auto scale = heightScaleOf(field);
    if (!(std::abs(scale.second) > 1e-9))
        return usage(fmt::format("{}: its heightRange spans nothing, from {} to {} m", field.path, scale.first,
                                 scale.first + scale.second),
                     "widen the terrain's heightRange");
    paintHeights(settings, scale);
    if (findBrush(brush.mode)->onHeights) settings.fromStart = false;  // set: to the value
    return settings;
}

// What a person must know of a stroke that is done.
void tellOf(const ConstFieldRef& field, const Stroke& work) {
    if (!work.reached()) logWarning(field.path + ": the stroke lay beside the terrain and painted nothing");
    if (!work.hitLow() && !work.hitHigh()) return;
    const auto [low, span] = heightScaleOf(field);
    logWarning(
        fmt::format("{}: the stroke reached the end of heightRange, {:.6g} m, where ground {}; a wider range "
                    "stretches the hills that are there, heights as floats (menu Edit, Heights as Floats) have no end",
                    field.path, work.hitHigh() ? low + span : low,
                    work.hitHigh() == (span > 0) ? "cannot rise higher" : "cannot sink lower"));
}

}  // namespace

Result<Document::Impl::StrokePart> Document::Impl::strokePart(const BrushSettings& brush, bool create, uint32_t turn) {
    if (Status sound = checkBrush(brush); !sound) return sound.error();
    const Result<ConstFieldRef> field = findMap(std::as_const(*project), rows(), brush.map);
    if (!field) return field.error();
    if (Status fits = checkTarget(*field, brush, create); !fits) return fits.error();
    const Result<MapScale> scale = mapScale(*project, *field);
    if (!scale) return scale.error();
    const auto& target = *static_cast<const MapField*>(field->value);
    const MapInfo info = target.present() ? target.map.info() : newMapInfo(*project, *field);
    const Result<BrushSettings> settings = settingsFor(*field, brush);
    if (!settings) return settings.error();
    const BrushRow& row = *findBrush(brush.mode, field->row->map->kind);
    return StrokePart{field->path, Stroke(row, *settings, *scale, info, turn)};
}

Status Document::beginStroke(const BrushSettings& brush, double x, double z) {
    return beginStrokes({&brush, 1}, x, z, false);
}

Status Document::beginStrokes(std::span<const BrushSettings> brushes, double x, double z, bool create,
                              std::optional<uint32_t> turn) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    impl_->finishStroke();
    Impl::ActiveStroke stroke;
    stroke.news = {{brushes.begin(), brushes.end()}, create, turn.value_or(impl_->history.position()), {}};
    for (const BrushSettings& brush : brushes) {
        Result<Impl::StrokePart> part = impl_->strokePart(brush, create, stroke.news.turn);
        if (!part) return part.error();
        stroke.parts.push_back(std::move(*part));
    }
    if (stroke.parts.empty()) return usage("a stroke of no brush");
    stroke.label = fmt::format("{} {}", findBrush(brushes[0].mode)->label, stroke.parts[0].path);
    if (stroke.parts.size() > 1) stroke.label += fmt::format(" and {} more", stroke.parts.size() - 1);
    stroke.last = {x, z};
    std::map<std::string, Map> before;
    for (Impl::StrokePart& part : stroke.parts) {
        const Result<FieldRef> field = findField(*impl_->project, impl_->rows(), part.path);
        mergeChange(stroke.changes,
                    {field->entity, field->component, impl_->stateOf(field->entity, *field->component), nullptr});
        auto& target = *static_cast<MapField*>(field->value);
        before[part.path] = target.map;
        if (target.present()) continue;
        target.map = newMap(*impl_->project, *field);
        target.file = mapFileFor(*field, target.map.info());
    }
    impl_->stroke = std::move(stroke);
    impl_->lastStroke = {std::move(before), ++impl_->revision};
    strokeTo(x, z);
    return {};
}

void Document::strokeTo(double x, double z) {
    if (!impl_->stroke || impl_->stroke->ended) return;
    const double metres = glm::length(glm::dvec2(x, z) - impl_->stroke->last);
    if (std::isfinite(metres)) impl_->stroke->metres += metres, impl_->stroke->last = {x, z};
    if (impl_->listener) impl_->stroke->news.points.push_back({x, z});
    for (Impl::StrokePart& part : impl_->stroke->parts) part.work.moveTo(x, z);
}

void Document::Impl::pump(double budgetMs) {
    if (!stroke) return;
    for (StrokePart& part : stroke->parts) {
        if (part.work.idle()) continue;
        const Result<FieldRef> field = findField(*project, rows(), part.path);
        CHECK(bool(field));  // nothing else is edited while a stroke is on
        part.work.pump(static_cast<MapField*>(field->value)->map, budgetMs / static_cast<double>(stroke->parts.size()));
        ++revision;
    }
    if (stroke->ended && stroke->idle()) {
        for (const StrokePart& part : stroke->parts)
            tellOf(*findField(std::as_const(*project), rows(), part.path), part.work);
        std::vector<Change> done = std::move(stroke->changes);
        const std::string label = stroke->told();
        const StrokeNews news = std::move(stroke->news);
        stroke.reset();
        for (Change& c : done) c.after = stateOf(c.entity, *c.row);
        record(label, std::move(done), &news);
    }
    lastStroke.revision = revision;
}

void Document::Impl::letGo() {
    if (!stroke) return;
    for (StrokePart& part : stroke->parts) part.work.end();
    stroke->ended = true;
}

void Document::Impl::finishStroke() {
    letGo();
    pump(0);
}

bool Document::pumpStroke(double budgetMs) {
    impl_->pump(budgetMs);
    return impl_->stroke && !impl_->stroke->idle();
}

void Document::endStroke() {
    if (!impl_->stroke) return;
    impl_->letGo();
    if (impl_->stroke->idle()) impl_->pump(0);
}

bool Document::stroking() const { return impl_->stroke.has_value(); }

const std::map<std::string, Map>* Document::strokeBefore() const {
    const auto& last = impl_->lastStroke;
    return !last.before.empty() && last.revision == impl_->revision ? &last.before : nullptr;
}

}  // namespace sward
