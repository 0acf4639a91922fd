// The transition meter of the editor: walks a camera's path of the open project and finds what pops. Pictures are drawn
// one a frame, on a snapshot and with a renderer of its own; then rays trace the same, a job each, so that other work
// beside has its turn (cost/transitions.h).
// Does not: draw widgets (panels/transitions.h), nor move the view.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "cost/transitions.h"

namespace sward {

class Document;
struct FrameClock;
struct Messages;

struct TransitionMeter {
    TransitionPlan plan;  // what the next walk is asked for
    std::shared_ptr<TransitionWalk> walk;
    std::unique_ptr<Renderer> renderer;  // while it draws
    Job<bool> job;                       // traces the next view
    std::optional<Transitions> result;
    std::string error;
    uint64_t revision = 0;      // of the document when the walk began
    std::filesystem::path dir;  // of that project
    double share = 0;           // of the tracing that is done
    int shown = -1;             // the step that the view was taken to
};
// Walks the plan's path from its beginning; what was measured before goes. What cannot be is said in `error`.
void startTransitions(TransitionMeter& meter, const Document& document);
// Once a frame, before its widgets: draws the next picture, or has the next traced; judges at the end. What belongs to
// another project is dropped. `wait`: for all that is traced beside, as scripts do.
void followTransitions(TransitionMeter& meter, const Document& document, Gpu& gpu, FrameClock& clock,
                       Messages& messages, bool wait);
// What is under way is dropped; a result stays.
void stopTransitions(TransitionMeter& meter);
bool walking(const TransitionMeter& meter);
// Share of a walk that is done, and what of it goes on: "drawing 3 of 25", "tracing 40 %".
double shareOf(const TransitionMeter& meter);
std::string newsOf(const TransitionMeter& meter);

}  // namespace sward
