#include "model/recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "brushes/shape.h"
#include "core/file.h"
#include "core/hash.h"
#include "core/log.h"
#include "model/step_script.h"
#include "project/project_files.h"

namespace sward {
namespace {

constexpr size_t kLineWidth = 110;

std::string hashNow(const Document& doc) { return hashHex(projectHash(doc.project(), doc.tables().components)); }

std::string number(float v) { return fmt::format("{}", v); }

// What brush.select reads of shapes, mirrors and imprints; nothing where it is what a brush begins with.
std::string shapeText(const BrushSettings& b) {
    static constexpr const char* turns[] = {"fixed", "random", "along"};
    static constexpr const char* blends[] = {"add", "maximum", "minimum", "replace"};
    std::string out;
    if (b.shape)
        out += fmt::format(", shape = {}, shapeTurn = \"{}\", shapeAngle = {}", luaText(b.shape->name),
                           turns[static_cast<int>(b.shapeTurn)], number(b.shapeAngleDeg));
    if (b.mirrorX || b.mirrorZ) out += fmt::format(", mirror = \"{}{}\"", b.mirrorX ? "x" : "", b.mirrorZ ? "z" : "");
    if (b.mode == "imprint") out += fmt::format(", blend = \"{}\"", blends[static_cast<int>(b.blend)]);
    if (b.mode == "imprint" && !b.fromStart) out += fmt::format(", base = {}", number(b.base));
    return out;
}

// As brush.select reads it: without a value flatten goes to where the stroke begins.
std::string selectCall(const BrushSettings& b) {
    const BrushRow* row = findBrush(b.mode);
    const bool fromStart = row && row->levels && b.fromStart;
    return fmt::format(
        "brush.select {{ map = {}, mode = {}, radius = {}, strength = {}, {}falloff = {}, spacing = {}, seed = {}, "
        "angle = {},\n               color = {{ {}, {}, {} }}, bumpSize = {}, talus = {}, water = {}{} }}",
        luaText(b.map), luaText(b.mode), number(b.radius), number(b.strength),
        fromStart ? "" : fmt::format("value = {}, ", number(b.value)), number(b.falloff), number(b.spacing), b.seed,
        number(b.angleDeg), number(b.color.x), number(b.color.y), number(b.color.z), number(b.bumpSize),
        number(b.talusDeg), number(b.water), shapeText(b));
}

std::string pointsText(const std::vector<glm::dvec2>& points) {
    std::string out, line = "    ";
    for (const glm::dvec2& p : points) {
        const std::string point = fmt::format("{{ {}, {} }}, ", p.x, p.y);
        if (line.size() + point.size() > kLineWidth) out += line + "\n", line = "    ";
        line += point;
    }
    return out + line;
}

std::string mapsText(const std::vector<BrushSettings>& brushes) {
    std::string out;
    for (const BrushSettings& b : brushes) out += (out.empty() ? "" : ", ") + luaText(b.map);
    return "{ " + out + " }";
}

// The same brush on several maps.
bool likeEach(const std::vector<BrushSettings>& brushes) {
    return std::all_of(brushes.begin(), brushes.end(), [&](BrushSettings b) {
        b.map = brushes[0].map;
        return selectCall(b) == selectCall(brushes[0]);
    });
}

}  // namespace

Status Recorder::start(Document& document) {
    if (recording()) return failed("a session is recorded already", "stop that first");
    if (!document.isOpen()) return failed("no project is open", "open or create one first");
    if (document.play()) return failed("nothing is recorded while the project is played", "stop first: F5");
    if (document.dirty())
        return failed("there is unsaved work, which a script could not begin with", "save first, then record");
    stop();
    document_ = &document;
    name_ = document.project().name;
    before_ = projectHash(document.project(), document.tables().components);
    document.listen(this);
    return {};
}

void Recorder::stop() {
    if (document_) document_->listen(nullptr);
    document_ = nullptr;
    text_.clear(), brush_.clear(), left_.clear(), steps_.clear();
    calls_ = done_ = earlier_ = 0;
    muted_ = touched_ = false;
}

std::string Recorder::script() const {
    std::string out = fmt::format(
        "-- Recorded in Sward {} on the project {}. On a copy: sward script THIS.lua --project COPY\n"
        "expect.equal(project.hash(), \"{}\")  -- it begins with that project, as it was\n\n",
        SWARD_VERSION, name_, hashHex(before_));
    out += text_;
    if (left_.empty())
        return out + fmt::format("\nexpect.equal(project.hash(), \"{}\")  -- and ends so\n", hashNow(*document_));
    out += "\n-- Not recorded, so that the project ends otherwise:\n";
    for (const std::string& what : left_) out += "--   " + what + "\n";
    return out;
}

void Recorder::call(const std::string& lua) {
    write(lua);
    ++calls_;
}

void Recorder::leave(const std::string& what) {
    write("-- not recorded: " + what);
    left_.push_back(what);
}

void Recorder::beginLine() {
    muted_ = recording();
    touched_ = false;
}

void Recorder::endLine(const std::string& lua, bool ran) {
    if (!std::exchange(muted_, false)) return;
    const bool names = lua.find('=') != std::string::npos || lua.find("function") != std::string::npos;
    if (!ran && touched_) return leave("what a line of the console changed before it failed: " + lua);
    if (ran && (touched_ || names)) call(lua);
}

void Recorder::writeStroke(const UndoStep& step, const StrokeNews& s) {
    const std::string select = selectCall(s.brushes[0]);
    write("-- " + step.label);
    const ShapePtr& shape = s.brushes[0].shape;
    if (select != brush_ && shape && !builtInShape(shape->name))
        write("-- needs the brush shape " + shape->name + ", where scripts may read it");
    if (select != brush_) call(select);
    brush_ = select;
    call(fmt::format("brush.stroke({{\n{}\n}}, {{ {}create = {}, turn = {} }})", pointsText(s.points),
                     s.brushes.size() > 1 ? "maps = " + mapsText(s.brushes) + ", " : "", s.create, s.turn));
}

// All calls of a step within one step of the script. False if there is none.
bool Recorder::writeCalls(const UndoStep& step) {
    StepScript s = scriptOf(step);
    if (!step.script.empty()) s = {{step.script}, {}, {}};
    for (const std::string& file : s.files) write(fmt::format("-- needs the file {} in the project's folder", file));
    for (const std::string& what : s.left) leave(fmt::format("{} ({})", what, step.label));
    if (s.calls.size() == 1) call(s.calls[0]);
    if (s.calls.size() < 2) return !s.calls.empty();
    write(fmt::format("edit.group({}, function()", luaText(step.label)));
    for (const std::string& one : s.calls) call("    " + one);
    write("end)");
    return true;
}

void Recorder::madeStep(const UndoStep& step, const StrokeNews* stroke) {
    steps_.resize(done_);
    ++done_;
    if (muted_) return touched_ = true, steps_.push_back(true);  // the line stands for it
    if (stroke && likeEach(stroke->brushes))
        writeStroke(step, *stroke), steps_.push_back(true);
    else
        steps_.push_back(writeCalls(step));
}

void Recorder::went(const char* lua, bool known) {
    if (muted_)
        touched_ = true;
    else if (known)
        call(lua);
    else
        leave("an undo or redo of a step that is not in this script");
}

void Recorder::wentBack() {
    if (done_ == 0) return ++earlier_, went("edit.undo()", false);
    went("edit.undo()", steps_[--done_]);
}

void Recorder::wentForward() {
    if (earlier_ > 0) return --earlier_, went("edit.redo()", false);
    went("edit.redo()", steps_[done_++]);
}

void Recorder::tookOther() {
    leave("what was done after another project was opened");
    document_->listen(nullptr);
}

Status writeRecording(const Recorder& r, const std::filesystem::path& file) {
    if (file.extension() != ".lua")
        return usage("a session is written to a .lua", "end the name in .lua").at(file.string());
    for (const std::string& what : r.left()) logWarning("not recorded: " + what);
    return writeFileAtomic(file, r.script());
}

}  // namespace sward
