// CPU work on other threads: a small persistent pool for loops, and background jobs with progress and cancel.
// A job works on a snapshot that it was given; its result carries the content hash of its inputs and is dropped if
// stale. Does not: touch GL, nor order jobs among each other (each lane runs its own one at a time, in the order in
// which they were started). Cost: a parallelFor over nothing much is 5-20 us.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "core/error.h"

namespace sward {

// Threads that take part in a parallelFor, the calling one included; at least 1.
int workerCount();

// Calls body(i) for each i in [0, count), each exactly once, in any order, on all workers; returns when all are done.
// May be nested and called from several threads. The first exception a body throws is rethrown here after the loop.
void parallelFor(size_t count, const std::function<void(size_t)>& body);

// Which thread runs a job; each runs its own one at a time. Waited: what a person waits for, however much is being made
// beside.
enum class Lane { Beside, Waited };

// What a job and its owner share. All members may be called from any thread.
class JobControl {
  public:
    void setProgress(double share) { progress_.store(share > 1 ? 1 : share >= 0 ? share : 0); }  // clamped to [0,1]
    // Share of the work done, in [0,1], as the work last told.
    double progress() const { return progress_.load(); }
    // Asks the work to end early; it may go on for a while. Never undone.
    void cancel() { cancelled_.store(true); }
    // The work asks this often and returns early (with any error) once it is true.
    bool cancelled() const { return cancelled_.load(); }
    // True once the work has returned, or was dropped because it was cancelled before its turn.
    bool finished() const { return finished_.load(); }

  private:
    friend void runInLane(Lane, std::shared_ptr<JobControl>, std::function<void()>);
    std::atomic<double> progress_{0};
    std::atomic<bool> cancelled_{false}, finished_{false};
};

// Queues work for a lane's thread. A control cancelled before its turn is not run. Programs end cleanly: at exit
// the running job is cancelled and waited for, those that wait are dropped.
void runInLane(Lane lane, std::shared_ptr<JobControl> control, std::function<void()> work);
// The same for the lane Beside.
void runInBackground(std::shared_ptr<JobControl> control, std::function<void()> work);

// What a person waits for, or need not: a job that runs beside.
struct JobNews {
    std::string label;
    double progress = 0;    // share done
    bool finished = false;  // its result is there, and not taken yet
};

// A result that is being made. Destroying it cancels the work; the result is then dropped.
template <class T>
class Job {
  public:
    Job() = default;
    // work runs once in the background, on what it captured by value. inputHash names the content it was given.
    Job(std::string label, uint64_t inputHash, std::function<Result<T>(JobControl&)> work)
        : Job(Lane::Beside, std::move(label), inputHash, std::move(work)) {}
    Job(Lane lane, std::string label, uint64_t inputHash, std::function<Result<T>(JobControl&)> work)
        : label_(std::move(label)), inputHash_(inputHash), slot_(std::make_shared<Slot>()) {
        runInLane(lane, slot_, [slot = slot_, work = std::move(work)] {
            Result<T> value = guarded(*slot, work);
            std::lock_guard lock(slot->mutex);
            slot->value.emplace(std::move(value));
        });
    }
    Job(Job&&) = default;
    Job& operator=(Job&& other) {
        cancel();
        label_ = std::move(other.label_);
        inputHash_ = other.inputHash_;
        slot_ = std::move(other.slot_);
        return *this;
    }
    ~Job() { cancel(); }

    // What a person reads while it runs; empty before a job was started.
    const std::string& label() const { return label_; }
    bool active() const { return slot_ != nullptr; }  // started, and its result not taken
    // Share of the work done, in [0,1]; 0 if none is under way.
    double progress() const { return slot_ ? slot_->progress() : 0; }
    // True when a result waits to be taken.
    bool finished() const { return slot_ && slot_->finished(); }
    // Label, progress and finished together, for lists of what runs beside.
    JobNews news() const { return {label_, progress(), finished()}; }
    // Ends the work early and drops its result; does nothing if none is under way.
    void cancel() {
        if (slot_) slot_->cancel();
    }
    // The result, once and only once: nothing while it is being made, after a cancel, or if currentHash is no longer
    // the hash of the inputs that it was made from (it is dropped then, and the job is no longer active).
    std::optional<Result<T>> take(uint64_t currentHash) {
        if (!finished()) return std::nullopt;
        const std::shared_ptr<Slot> slot = std::move(slot_);
        slot_.reset();
        if (slot->cancelled() || currentHash != inputHash_) return std::nullopt;
        std::lock_guard lock(slot->mutex);
        return std::move(slot->value);
    }

  private:
    struct Slot : JobControl {
        std::mutex mutex;
        std::optional<Result<T>> value;
    };
    static Result<T> guarded(JobControl& control, const std::function<Result<T>(JobControl&)>& work) try {
        return work(control);
    } catch (const std::exception& e) {
        return failed(e.what());
    }
    std::string label_;
    uint64_t inputHash_ = 0;
    std::shared_ptr<Slot> slot_;
};

}  // namespace sward
