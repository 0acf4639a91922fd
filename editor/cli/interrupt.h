// Ctrl+C, or another polite signal to end, while a verb works long: the work is cancelled, so that no file is left
// half-written; and how far it is.
#pragma once
#include <chrono>
#include <functional>
#include <string>
#include <thread>

#include "core/jobs.h"

namespace sward {

// While one lives, Ctrl+C, SIGTERM and SIGHUP are noted instead of ending the program; the second of them ends it.
class Interruptible {
  public:
    Interruptible();
    ~Interruptible();
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;

  private:
    void (*before_[3])(int);
};
// Whether it was pressed since the last Interruptible was made.
bool interrupted();

// How long a task still takes, with what would make it shorter, once 5 seconds tell that it takes half a minute or
// more; else empty.
std::string longTaskText(const std::string& name, double share, double seconds, const std::string& remedy);

// A line on standard error that is written over, where a person looks, with the time left; elsewhere longTaskText,
// once. False once interrupted.
std::function<bool(double)> progressLine(const std::string& name, const std::string& remedy = {});

// Waits for a job, telling how far it is. Interrupted error once Ctrl+C was pressed. remedy: what makes it shorter.
template <class T>
Result<T> waitFor(Job<T>& job, uint64_t inputHash, const std::string& remedy = {}) {
    const auto tell = progressLine(job.label(), remedy);
    while (!job.finished()) {
        if (!tell(job.progress())) {
            job.cancel();
            while (!job.finished())
                std::this_thread::sleep_for(std::chrono::milliseconds(5));  // it may read what the caller holds
            return interruption("interrupted; nothing was written");
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    tell(1);
    auto made = job.take(inputHash);
    if (!made) return failed("cancelled");
    return std::move(*made);
}

}  // namespace sward
