// The editor's session as a Lua script that repeats it: strokes with their points, edits as calls of docs/scripting.md,
// undo and redo. The script begins and ends by holding the project's hash against the recorded one, so that a run says
// itself whether it repeated everything; what no call does is named in a comment, and the last hash is then left out.
// Does not: record the view, play, saving, or what is chosen: they change no project.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "model/document.h"
#include "model/document_listener.h"

namespace sward {

class Recorder : public DocumentListener {
  public:
    ~Recorder() override { stop(); }
    // From the project as it is on disk. Failed while it records already, without an open project, while it is played,
    // or with unsaved work, which a script could not begin with. The document must outlive the recording.
    Status start(Document& document);
    bool recording() const { return document_ != nullptr; }
    // How many calls there are, and what could not be recorded, in words.
    size_t calls() const { return calls_; }
    const std::vector<std::string>& left() const { return left_; }
    // The script up to now; reads every texel of the project.
    std::string script() const;
    // Forgets what was recorded.
    void stop();
    // A line of the console is about to run, and has run: it stands in the script as it was typed, and what it changes
    // is not recorded again. One that only asks is left out; one that failed, too, and is named if it changed
    // something.
    void beginLine();
    void endLine(const std::string& lua, bool ran);

    void madeStep(const UndoStep& step, const StrokeNews* stroke) override;
    void wentBack() override;
    void wentForward() override;
    void tookOther() override;

  private:
    void write(const std::string& line) { text_ += line + "\n"; }
    void call(const std::string& lua);
    void leave(const std::string& what);
    void writeStroke(const UndoStep& step, const StrokeNews& stroke);
    bool writeCalls(const UndoStep& step);
    void went(const char* lua, bool known);

    Document* document_ = nullptr;
    std::string name_, text_, brush_;  // brush_: the last brush.select
    uint64_t before_ = 0;              // the project's hash at the start
    size_t calls_ = 0;
    std::vector<std::string> left_;
    std::vector<bool> steps_;  // since the start, undone ones included: whether the script has a step for it
    size_t done_ = 0;          // of them
    size_t earlier_ = 0;       // steps from before the start that were taken back
    bool muted_ = false, touched_ = false;
};

// The script to a file that ends in .lua (usage error else), whole or not at all. What could not be recorded is logged
// as a warning.
Status writeRecording(const Recorder& recorder, const std::filesystem::path& file);

}  // namespace sward
