// The open project with its undo history: the one door through which inspector, brushes and scripts change a scene.
// Does not: draw, or know any widget.
// An undo step is a list of component values before and after; their maps share tiles, so a step costs what it changed.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brushes/brush.h"
#include "core/error.h"
#include "scene/project.h"
#include "world/ground.h"

namespace sward {

// One component of one entity, before and after; null: it was not there. Entities by name, never by handle.
struct Change {
    std::string entity;
    const ComponentRow* row = nullptr;  // null: the entity itself came or went
    std::shared_ptr<void> before, after;
};
struct UndoStep {
    std::string label;  // "Comb lawn.GrassField.orientation, 42 m", "set lawn.HybridTiers.maxGeom"
    std::vector<Change> changes;
    std::string script;  // the call of a script that does it, where the changes do not say it (Document::describe)
};

class JobControl;
class Playtest;
struct DocumentListener;
struct PlayStart;

// A save under way: of the project as it was when it began.
struct SaveWork {
    Project project, saved;  // as it is to be on disk; as it was there last
    std::span<const ComponentRow> rows;
    double waitSeconds = 0;
    uint32_t position = 0;  // of the history
    Result<std::vector<std::string>> written = std::vector<std::string>();
};
// Writes it, on any thread; `written` says how it ended. `control`: told how far it is; cancelled it fails, with the
// old project on disk, unless that was replaced already.
void writeSave(SaveWork& work, JobControl* control);

class Document {
  public:
    // No project is open yet. The history keeps about `undoBytes` of earlier states.
    explicit Document(const Tables& tables, size_t undoBytes = size_t(512) << 20);
    ~Document();

    // --- files: a failure leaves the document as it was
    Status open(const std::filesystem::path& dir);
    // A new project in a folder that is empty or is not there yet, and opens it.
    Status create(const std::filesystem::path& dir);
    Result<std::vector<std::string>> save();  // the files written
    // How long save waits for another program that saves or reads the project, before it fails; kLockWaitSeconds at
    // first.
    void setSaveWait(double seconds);
    // Into another folder, which the project is in from then on.
    Result<std::vector<std::string>> saveAs(const std::filesystem::path& dir);
    // Makes the open project like the one in another folder, as one undo step; it stays where it is, and unsaved.
    Status takeOver(const std::filesystem::path& dir, const std::string& label);
    // What another program saved in the project's folder since it was opened or saved here, taken over as one undo
    // step: the document then is what is on disk.
    Status takeFromDisk();

    // --- the same in parts, so that what reads and writes runs on another thread meanwhile
    // A loaded project in the place of the open one; and as takeOver and takeFromDisk do with it.
    Status show(Project loaded);
    Status takeOver(const Project& loaded, const std::string& label);
    Status takeFromDisk(const Project& loaded);
    // As save does, or saveAs if a folder is given: what is to be written, to be handed to writeSave and then to
    // endSave, which takes note of what is on disk. What is edited in between stays unsaved.
    Result<SaveWork> beginSave(const std::filesystem::path& as = {});
    Result<std::vector<std::string>> endSave(SaveWork& work);
    // A document of the same project as it is now, without its history, to be edited on another thread; and its steps
    // in this one's history. Fails if anything was edited here meanwhile.
    Result<std::unique_ptr<Document>> copyToWorkOn();
    Status takeFrom(Document& worked);
    // A project is open: project() has one.
    bool isOpen() const;
    bool dirty() const;              // differs from what is on disk
    const Project& project() const;  // changed by the calls below alone
    // The same without what is Hidden: as the viewport shows it. Made anew after a change, while anything is.
    const Project& visibleProject() const;
    // The same as project(), on the ground as layers over its heights leave it (world/height_layers.h): where hands
    // pick and place things, and feet walk. project() itself without such layers; made anew after a change.
    const Project& standing() const;
    // The ground of that.
    Ground ground() const;
    // From now on nobody waits long for layers over the heights: until they are there, standing() is the project on the
    // heights that were there last. followStanding, to be called between frames, takes what is there; true if
    // something was.
    void standBeside();
    bool followStanding();
    // Those that it was made with.
    const Tables& tables() const;
    uint64_t revision() const;  // grows with every change, undo and redo

    // --- play: a copy runs while the project stays as it is; until it stops, files, edits, strokes, undo and redo are
    // refused. A stroke under way is finished first. Fails while a group is open (something is being dragged), while it
    // is played already, and as Playtest::start does.
    Status startPlay(const PlayStart& start);
    // Drops the copy; nothing happens when nothing is played.
    void stopPlay();
    Playtest* play();  // null: not played
    // The same, only to be read.
    const Playtest* play() const;

    // --- edits: each is one undo step, unless within a group
    Status setField(const std::string& path, const std::string& text);
    // Names are letters, digits, "_" and "-", and one's own.
    Status addEntity(const std::string& name);
    // With all its components.
    Status removeEntity(const std::string& name);
    // With its defaults; fails if the entity has one.
    Status addComponent(const std::string& entity, const std::string& component);
    // Gives the entity a component like `value`, which must be of the row's kind and sound: another entity's, say. What
    // it had of the kind is replaced.
    Status assignComponent(const std::string& entity, const ComponentRow& row, const void* value);
    // Fails if the entity has none.
    Status removeComponent(const std::string& entity, const std::string& component);
    // At the end of "lawn.GrassField.species", with its defaults and a name of its own.
    Status addListElement(const std::string& listPath);
    // "lawn.GrassField.species[clover]".
    Status removeListElement(const std::string& elementPath);
    // To another place in its list, counted from 0; the others keep their order. Fails if the list is shorter.
    Status moveListElement(const std::string& elementPath, size_t to);
    // A map that is not there yet, as model/new_map.h makes it; nothing if it is there.
    Status createMap(const std::string& mapPath);
    // Replaces a map's texels (imports, fills). A new map's file name follows the convention
    // "maps/entity.species.map.ext".
    Status setMap(const std::string& mapPath, Map map, const std::string& label);
    // How a map came in, for the next time (Project::imports): beside the undo steps.
    void rememberImport(const std::string& mapPath, const MapImport& import);
    void beginGroup(const std::string& label);  // nests; sliders hold one while dragged
    // Ends one level; the outermost makes the undo step, if anything changed.
    void endGroup();
    // Takes back what the outermost group has changed so far, and ends this level of it: for an edit of several parts
    // of which one failed.
    void cancelGroup();

    // The call of a script that does the same as the group that is open, where its changes do not say it: a map turned
    // round, a rename. Within another group it is not kept.
    void describe(const std::string& call);
    // Who is told of every step, undo and redo from now on, one at a time (model/document_listener.h); null: nobody.
    void listen(DocumentListener* listener);

    // --- strokes: begin, any number of points, end; one undo step. Points in metres on the terrain.
    // Status fails if the map does not exist, is not of a kind that the brush paints, or a setting is not finite or
    // names no brush. What else a person must know is logged as a warning when the stroke is done: that all of it lay
    // beside the terrain, or that integer heights came to the end of their range.
    // Large stamps are spread: strokeTo queues, pumpStroke works them off, tile by tile. Any other edit, undo, redo and
    // save first work off the whole stroke. Points far outside the terrain are pulled to it.
    Status beginStroke(const BrushSettings& brush, double x, double z);
    // The same on several maps at once, a brush for each. `create`: maps that are not there yet are made first
    // (model/new_map.h), within the step. `turn`: with what the rounding of integer maps begins (Stamp); nothing: by
    // the number of steps before.
    Status beginStrokes(std::span<const BrushSettings> brushes, double x, double z, bool create,
                        std::optional<uint32_t> turn = {});
    // The next point of the stroke; nothing without one.
    void strokeTo(double x, double z);
    // Works off queued stamps for at most budgetMs (0: all). True while work is left.
    bool pumpStroke(double budgetMs);
    void endStroke();       // works off the rest on later pumps; the step is complete then
    bool stroking() const;  // from beginStroke until the step is complete
    // The maps that the present or last stroke paints, by PATH, as they were before it (empty: there was none); null
    // once anything else has changed. They last until the next change.
    const std::map<std::string, Map>* strokeBefore() const;

    // --- undo and redo: not while a group is open or it is played (false then). When the history outgrows its bytes
    // the oldest steps go, but never the newest; counted are the tiles that a step alone keeps.
    bool canUndo() const;
    // Likewise for redo.
    bool canRedo() const;
    // What undo would take back, and redo bring again: the step's label; "" if there is none.
    std::string undoLabel() const;
    // Likewise for redo.
    std::string redoLabel() const;
    // Labels of all steps that the history holds, the oldest first, and how many of them the project has behind it.
    std::vector<std::string> stepLabels() const;
    size_t stepsDone() const;
    // How many steps are behind where the project is as on disk; nothing: no step leads there.
    std::optional<size_t> savedStep() const;
    // Takes steps back, or brings them again, until so many are behind. False if it cannot be reached now.
    bool jumpTo(size_t stepsDone);
    // Takes the last step back. False if there is none or it may not be now.
    bool undo();
    // Brings back what was taken back last. False likewise.
    bool redo();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sward
