// The document: play · edits · undo and redo; its files: document_files.cpp, its strokes: document_strokes.cpp.
#include "model/document.h"

#include "model/document_impl.h"
#include "model/field_walk.h"
#include "model/new_map.h"
#include "scene/map_layers.h"

namespace sward {

Document::Document(const Tables& tables, size_t undoBytes) : impl_(std::make_unique<Impl>(tables, undoBytes)) {}
Document::~Document() = default;

void Document::setSaveWait(double seconds) { impl_->saveWaitSeconds = seconds; }

bool Document::isOpen() const { return impl_->project.has_value(); }

bool Document::dirty() const {
    if (!isOpen()) return false;
    auto& known = impl_->dirtyAt;
    if (known.revision != impl_->revision) {
        const Project& p = *impl_->project;
        known = {impl_->revision, !p.repairedMaps.empty() || !sameProject(p, impl_->saved, impl_->rows())};
    }
    return known.value;
}

const Project& Document::project() const {
    CHECK(isOpen());
    return *impl_->project;
}
const Project& Document::visibleProject() const {
    auto& visible = impl_->visible;
    if (visible.revision != impl_->revision) visible = {impl_->revision, withoutHidden(project(), impl_->rows())};
    return visible.project ? *visible.project : project();
}
const Project& Document::standing() const { return impl_->standing.of(project(), impl_->revision, impl_->rows()); }
void Document::standBeside() { impl_->standing.patient = false; }
bool Document::followStanding() { return impl_->standing.follow(); }
Ground Document::ground() const { return findGround(standing()); }
const Tables& Document::tables() const { return impl_->tables; }
uint64_t Document::revision() const { return impl_->revision; }

// --- play --------------------------------------------------------------------------------------------------------

Status Document::startPlay(const PlayStart& start) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    if (impl_->groupDepth > 0) return failed("play cannot start while a value is being changed", "let go of it first");
    impl_->finishStroke();
    Result<std::unique_ptr<Playtest>> play = Playtest::start(standing(), impl_->rows(), start);
    if (!play) return play.error();
    impl_->play = std::move(*play);
    return {};
}

void Document::stopPlay() { impl_->play.reset(); }
Playtest* Document::play() { return impl_->play.get(); }
const Playtest* Document::play() const { return impl_->play.get(); }

// --- edits -------------------------------------------------------------------------------------------------------

void Document::Impl::push(UndoStep step, const StrokeNews* of) {
    dropEmptyChanges(step.changes);
    if (step.changes.empty()) return;
    // What was saved on a branch that could be redone is gone with it.
    if (savedAt && *savedAt > history.position()) savedAt.reset();
    if (listener) listener->madeStep(step, of);
    history.push(std::move(step));
}

void Document::Impl::record(const std::string& label, std::vector<Change> changes, const StrokeNews* of) {
    if (!of) ++revision;  // a stroke's stamps did, and its end changes nothing more that is drawn
    if (groupDepth > 0) {
        for (Change& c : changes) mergeChange(group.changes, std::move(c));
        return;
    }
    push({label, std::move(changes), {}}, of);
}

// Edits the component that the field belongs to; the edit must leave it alone if it fails.
Status Document::Impl::changeField(const std::string& label, const FieldRef& field,
                                   const std::function<Status()>& edit) {
    Change change{field.entity, field.component, stateOf(field.entity, *field.component), nullptr};
    if (Status done = edit(); !done) return done;
    change.after = stateOf(change.entity, *change.row);
    record(label, {std::move(change)});
    return {};
}

// The maps that the entity's layers lie over, null where one is not there.
std::vector<const void*> Document::Impl::layeredMaps(const std::string& entity) const {
    std::vector<const void*> maps;
    if (const MapLayers* of = project->registry.get<MapLayers>(findEntity(*project, entity)))
        for (const MapLayer& layer : of->layers) {
            const auto map = findField(std::as_const(*project), rows(), layeredPath(entity, layer));
            maps.push_back(map ? map->value : nullptr);
        }
    return maps;
}

// Layers name their map by its PATH; where an edit has changed that, they go along.
void Document::Impl::followMaps(const std::string& entity, const std::vector<const void*>& maps) {
    const std::vector<const void*> now = layeredMaps(entity);
    if (now == maps) return;
    MapLayers& of = *project->registry.get<MapLayers>(findEntity(*project, entity));
    const ComponentRow& row =
        *std::find_if(rows().begin(), rows().end(), [](const ComponentRow& r) { return isRowOf<MapLayers>(r); });
    std::shared_ptr<void> before = stateOf(entity, row);
    for (const ConstFieldRef& map : allMaps(std::as_const(*project), rows(), true))
        for (size_t i = 0; i < maps.size(); ++i)
            if (maps[i] == map.value && now[i] != map.value) of.layers[i].map = map.path.substr(entity.size() + 1);
    record("", {{entity, &row, std::move(before), stateOf(entity, row)}});
}

Status Document::setField(const std::string& path, const std::string& text) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    impl_->finishStroke();
    const Result<FieldRef> field = findField(*impl_->project, impl_->rows(), path);
    if (!field) return field.error();
    const std::string label = "set " + field->path;
    const auto edit = [&] { return setFieldText(*field, text); };
    const std::vector<const void*> layered =
        field->row->type == FieldType::String ? impl_->layeredMaps(field->entity) : std::vector<const void*>();
    if (layered.empty()) return impl_->changeField(label, *field, edit);
    beginGroup(label);
    const Status done = impl_->changeField(label, *field, edit);
    if (done) impl_->followMaps(field->entity, layered);
    endGroup();
    return done;
}

Status Document::addEntity(const std::string& name) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    impl_->finishStroke();
    const Result<Entity> made = sward::addEntity(*impl_->project, name);
    if (!made) return made.error();
    impl_->record("add " + name, {{name, nullptr, nullptr, std::make_shared<bool>(true)}});
    return {};
}

Status Document::removeEntity(const std::string& name) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    impl_->finishStroke();
    if (!impl_->project->entities.contains(name)) return usage(fmt::format("there is no entity \"{}\"", name));
    std::vector<Change> changes;
    for (const ComponentRow& row : impl_->rows())
        if (auto before = impl_->stateOf(name, row)) changes.push_back({name, &row, std::move(before), nullptr});
    changes.push_back({name, nullptr, std::make_shared<bool>(true), nullptr});
    sward::removeEntity(*impl_->project, name);
    impl_->record("remove " + name, std::move(changes));
    return {};
}

Status Document::addComponent(const std::string& entity, const std::string& component) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    impl_->finishStroke();
    const ComponentRow* row = findComponent(impl_->rows(), component);
    if (!row) return usage(fmt::format("there is no component \"{}\"", component));
    if (!impl_->project->entities.contains(entity)) return usage(fmt::format("there is no entity \"{}\"", entity));
    if (impl_->stateOf(entity, *row)) return usage(fmt::format("\"{}\" has a {} already", entity, component));
    row->assign(impl_->project->registry, findEntity(*impl_->project, entity), nullptr);
    impl_->record(fmt::format("add {}.{}", entity, component), {{entity, row, nullptr, impl_->stateOf(entity, *row)}});
    return {};
}

Status Document::assignComponent(const std::string& entity, const ComponentRow& row, const void* value) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    impl_->finishStroke();
    const Entity e = findEntity(*impl_->project, entity);
    if (e == kNoEntity) return usage(fmt::format("there is no entity \"{}\"", entity));
    auto before = impl_->stateOf(entity, row), after = row.clone(value);
    row.assign(impl_->project->registry, e, after.get());
    impl_->record(fmt::format("set {}.{}", entity, row.name), {{entity, &row, std::move(before), std::move(after)}});
    return {};
}

Status Document::removeComponent(const std::string& entity, const std::string& component) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    impl_->finishStroke();
    const ComponentRow* row = findComponent(impl_->rows(), component);
    auto before = row ? impl_->stateOf(entity, *row) : nullptr;
    if (!before) return usage(fmt::format("\"{}\" has no component \"{}\"", entity, component));
    row->remove(impl_->project->registry, findEntity(*impl_->project, entity));
    impl_->record(fmt::format("remove {}.{}", entity, component), {{entity, row, std::move(before), nullptr}});
    return {};
}

// The new element has the defaults of its kind, and a name that no other has.
Status Document::addListElement(const std::string& listPath) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    impl_->finishStroke();
    const Result<FieldRef> field = findField(*impl_->project, impl_->rows(), listPath);
    if (!field) return field.error();
    if (field->row->type != FieldType::List) return usage(field->path + " is not a list");
    const ListRow& list = *field->row->list;
    return impl_->changeField("add to " + field->path, *field, [&]() -> Status {
        const std::vector<std::string> taken = elementSelectors(list, field->value);
        const size_t n = list.size(field->value);
        list.resize(field->value, n + 1);
        void* made = list.editAt(field->value, n);
        copyFields(list.fields, made, list.defaults());
        auto& name = *reinterpret_cast<std::string*>(static_cast<std::byte*>(made) + list.fields[0].offset);
        const std::string stem = name;
        for (int i = 2; std::find(taken.begin(), taken.end(), name) != taken.end(); ++i)
            name = stem + std::to_string(i);
        return {};
    });
}

namespace {

// An element of a list, by its PATH.
struct ListElement {
    FieldRef list;
    size_t index;
};
Result<ListElement> findListElement(Project& p, std::span<const ComponentRow> rows, const std::string& path) {
    const size_t open = path.rfind('[');
    if (open == std::string::npos || !path.ends_with("]"))
        return usage(path + " names no element of a list", "write entity.Component.list[name]");
    Result<FieldRef> field = findField(p, rows, path.substr(0, open));
    if (!field) return field.error();
    if (field->row->type != FieldType::List) return usage(field->path + " is not a list");
    const Result<size_t> index = findElement(*field, path.substr(open + 1, path.size() - open - 2));
    if (!index) return index.error();
    return ListElement{*field, *index};
}

}  // namespace

Status Document::removeListElement(const std::string& elementPath) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    impl_->finishStroke();
    const Result<ListElement> element = findListElement(*impl_->project, impl_->rows(), elementPath);
    if (!element) return element.error();
    const FieldRef& field = element->list;
    const ListRow& list = *field.row->list;
    return impl_->changeField("remove " + elementPath, field, [&]() -> Status {
        const size_t n = list.size(field.value);
        for (size_t i = element->index; i + 1 < n; ++i)
            copyFields(list.fields, list.editAt(field.value, i), list.at(field.value, i + 1));
        list.resize(field.value, n - 1);
        return {};
    });
}

Status Document::moveListElement(const std::string& elementPath, size_t to) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    impl_->finishStroke();
    const Result<ListElement> element = findListElement(*impl_->project, impl_->rows(), elementPath);
    if (!element) return element.error();
    const FieldRef& field = element->list;
    const ListRow& list = *field.row->list;
    const size_t n = list.size(field.value), from = element->index;
    if (to >= n) return usage(fmt::format("{}: there is no place {} in a list of {}", elementPath, to, n));
    return impl_->changeField("move " + elementPath, field, [&]() -> Status {
        list.resize(field.value, n + 1);  // room for the one that moves
        copyFields(list.fields, list.editAt(field.value, n), list.at(field.value, from));
        for (size_t i = from; i != to; i = i < to ? i + 1 : i - 1)
            copyFields(list.fields, list.editAt(field.value, i), list.at(field.value, i < to ? i + 1 : i - 1));
        copyFields(list.fields, list.editAt(field.value, to), list.at(field.value, n));
        list.resize(field.value, n);
        return {};
    });
}

Status Document::setMap(const std::string& mapPath, Map map, const std::string& label) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    impl_->finishStroke();
    const Result<FieldRef> field = findMap(*impl_->project, impl_->rows(), mapPath);
    if (!field) return field.error();
    if (map.empty()) return usage(field->path + ": an empty map", "set the field to \"\" to remove the map");
    if (map.info().channels != field->row->map->channels)
        return usage(fmt::format("{}: a map of {} channels, where {} are wanted", field->path, map.info().channels,
                                 field->row->map->channels));
    if (field->row->map->kind == MapKind::Heights && map.info().type == PixelType::U8)
        return usage(field->path + ": heights of 8 bits", "use 16 bits or floats");
    return impl_->changeField(label, *field, [&]() -> Status {
        auto& target = *static_cast<MapField*>(field->value);
        target.file = mapFileFor(*field, map.info());
        target.map = std::move(map);
        return {};
    });
}

Status Document::createMap(const std::string& mapPath) {
    if (Status ready = impl_->ready(); !ready) return ready.error();
    const Result<FieldRef> field = findField(*impl_->project, impl_->rows(), mapPath);
    if (!field) return field.error();
    if (field->row->type != FieldType::Map) return usage(field->path + " is not a map");
    if (static_cast<const MapField*>(field->value)->present()) return {};
    return setMap(field->path, newMap(*impl_->project, *field), "new map " + field->path);
}

void Document::rememberImport(const std::string& mapPath, const MapImport& import) {
    CHECK(isOpen());
    impl_->project->imports[mapPath] = import;
}

void Document::beginGroup(const std::string& label) {
    impl_->finishStroke();
    if (impl_->groupDepth++ == 0) impl_->group = {label, {}, {}};
}

void Document::endGroup() {
    impl_->finishStroke();
    if (impl_->groupDepth == 0) return;  // opening another project ends every group
    if (--impl_->groupDepth > 0) return;
    UndoStep done = std::move(impl_->group);
    impl_->group = {};
    impl_->push(std::move(done), nullptr);
}

void Document::describe(const std::string& call) {
    if (impl_->groupDepth == 1) impl_->group.script = call;
}
void Document::listen(DocumentListener* listener) { impl_->listener = listener; }

void Document::cancelGroup() {
    impl_->finishStroke();
    if (impl_->groupDepth == 0) return;
    if (isOpen()) applyChanges(*impl_->project, impl_->group.changes, false);
    impl_->group.changes.clear();
    --impl_->groupDepth;
    ++impl_->revision;
}

// --- undo and redo -----------------------------------------------------------------------------------------------

bool Document::Impl::step(bool forward) {
    finishStroke();
    const UndoStep* next = project && !play && groupDepth == 0 ? history.next(forward) : nullptr;
    if (!next) return false;
    applyChanges(*project, next->changes, forward);
    history.moved(forward);
    ++revision;
    if (listener) forward ? listener->wentForward() : listener->wentBack();
    return true;
}

bool Document::canUndo() const {
    return !impl_->play && impl_->groupDepth == 0 && (impl_->stroke || impl_->history.next(false));
}
bool Document::canRedo() const {
    return !impl_->play && impl_->groupDepth == 0 && !impl_->stroke && impl_->history.next(true);
}
std::string Document::undoLabel() const {
    if (impl_->stroke) return impl_->stroke->told();
    const UndoStep* next = impl_->history.next(false);
    return next ? next->label : "";
}
std::string Document::redoLabel() const {
    const UndoStep* next = impl_->history.next(true);
    return next ? next->label : "";
}
std::vector<std::string> Document::stepLabels() const { return impl_->history.labels(); }
size_t Document::stepsDone() const { return impl_->history.done(); }
std::optional<size_t> Document::savedStep() const {
    const uint32_t forgotten = impl_->history.position() - static_cast<uint32_t>(impl_->history.done());
    const bool known = isOpen() && impl_->project->repairedMaps.empty() && impl_->savedAt;
    if (!known || *impl_->savedAt < forgotten) return {};
    return *impl_->savedAt - forgotten;
}

bool Document::jumpTo(size_t wanted) {
    impl_->finishStroke();
    while (impl_->history.done() != wanted)
        if (!impl_->step(impl_->history.done() < wanted)) return false;
    return true;
}
bool Document::undo() { return impl_->step(false); }
bool Document::redo() { return impl_->step(true); }

}  // namespace sward
