// What pops along a camera's path: the same moments are drawn and ray-traced, and each step from one to the next is
// judged by metrics/popping.h, beside the same of other blades of the field, and of other trees of a forest, which is
// the floor to hold it against.
// Time stands still: what changes is the camera alone, so that a step above the floor is a transition that shows.
// Drawing needs a GPU, tracing does not: both go a picture at a time, so that others have their turn between. Does not:
// follow blades, nor say which tier it was. Cost: a frame a picture, then some 0.1 to 1 s of rays each at the usual
// size.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/jobs.h"
#include "frame/renderer.h"
#include "metrics/popping.h"
#include "scene/rows.h"
#include "world/view_camera.h"

namespace sward {

inline constexpr int kMostTransitionPictures = 400;
struct TransitionPlan {
    std::string path;   // the entity whose CameraPath is walked
    int pictures = 25;  // evenly from `from` to `to`; 2 to kMostTransitionPictures
    int width = 160, height = 120;
    int samples = 4;  // rays a pixel of the truth, and of a picture's edges
    double time = 0;  // scene seconds
    // Seconds of the path; 0: to its end. Far apart, pictures differ by all their blades and little else shows.
    double from = 0, to = 0;
};

struct WalkTruth;  // what rays have found so far
// A walk: what it is of, and how far it is drawn and traced.
struct TransitionWalk {
    TransitionPlan plan;
    Project project;  // as it was when it began
    std::vector<double> seconds;
    std::vector<ViewCamera> views;
    std::vector<Picture> drawn;  // of the first views
    std::shared_ptr<WalkTruth> truth;
};
// A snapshot and the views. Usage error: a path that is none or has no length, and pictures, sizes, samples or
// seconds out of range.
Result<std::shared_ptr<TransitionWalk>> beginWalk(const Project& project, const Tables& tables,
                                                  const TransitionPlan& plan);
// Draws the next view as the project draws itself, and waits for what that needs. Nothing once all are.
Status drawNextOf(TransitionWalk& walk, Renderer& renderer);
bool isDrawn(const TransitionWalk& walk);

// Makes a scene, or traces the next view in it: first of the project, then of other blades. From any thread, one at a
// time. Failed once the control is cancelled, or by what the truth fails with. Nothing once all are.
Status traceNextOf(TransitionWalk& walk, const Tables& tables, JobControl& control);
bool isTraced(const TransitionWalk& walk);
// Share of the tracing that is done; not while it goes on.
double tracedShare(const TransitionWalk& walk);

struct Transitions {
    TransitionPlan plan;
    std::vector<double> seconds;    // of the pictures
    std::vector<ViewCamera> views;  // theirs
    Popping drawn, floor;           // of the steps between
    size_t blind = 0;               // pictures in which the truth has no grass: steps to and from them count 0
};
// Of a walk that is drawn and traced.
Result<Transitions> judgeWalk(const TransitionWalk& walk);
// Steps that pop more than other blades would do.
size_t stepsAboveFloor(const Transitions& t);

// "popping 0.0123, mean of 24 steps; at worst ...", and the steps above the floor; for people.
std::string transitionsText(const Transitions& t);
// {"path", "pictures", "popping", "popping_floor", "change", "worst_step", "steps": [{"from", "to", "popping",
// "floor"},
// ...]}. change: how much pictures change as a share of what the truth does, null where that does not.
std::string transitionsJson(const Transitions& t);

}  // namespace sward
