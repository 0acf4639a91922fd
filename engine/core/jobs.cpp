#include "core/jobs.h"

#include <condition_variable>
#include <deque>
#include <thread>

namespace sward {
namespace {

// One loop: its helpers share it with the caller, and one that comes too late finds nothing left to do.
struct Loop {
    const std::function<void(size_t)>* body = nullptr;
    size_t count = 0;
    std::atomic<size_t> next{0};
    std::mutex mutex;
    std::condition_variable allDone;
    size_t done = 0;
    std::exception_ptr error;

    void work() {
        size_t mine = 0;
        std::exception_ptr thrown;
        for (size_t i = next.fetch_add(1); i < count; i = next.fetch_add(1), ++mine) {
            try {
                (*body)(i);
            } catch (...) {
                thrown = std::current_exception();
            }
        }
        std::lock_guard lock(mutex);
        if (thrown && !error) error = thrown;
        done += mine;
        if (done == count) allDone.notify_all();
    }
    void wait() {
        std::unique_lock lock(mutex);
        allDone.wait(lock, [this] { return done == count; });
    }
};

// Threads that take tasks from one queue until the destructor; tasks still waiting then are dropped.
class Threads {
  public:
    explicit Threads(int count) {
        for (int i = 0; i < count; ++i) threads_.emplace_back([this] { run(); });
    }
    ~Threads() { stop(); }
    void add(std::function<void()> task) {
        {
            std::lock_guard lock(mutex_);
            queue_.push_back(std::move(task));
        }
        wake_.notify_one();
    }
    void stop() {
        {
            std::lock_guard lock(mutex_);
            stopping_ = true;
        }
        wake_.notify_all();
        for (std::thread& t : threads_) t.join();
        threads_.clear();
    }

  private:
    void run() {
        for (;;) {
            std::function<void()> task;
            {
                std::unique_lock lock(mutex_);
                wake_.wait(lock, [this] { return stopping_ || !queue_.empty(); });
                if (stopping_) return;
                task = std::move(queue_.front());
                queue_.pop_front();
            }
            task();
        }
    }
    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<std::function<void()>> queue_;
    bool stopping_ = false;
    std::vector<std::thread> threads_;
};

Threads& pool() {
    static Threads instance(workerCount() - 1);
    return instance;
}

// A lane's thread, and the job that it runs: cancelled at exit, so that the program need not wait for its end.
struct Background {
    std::mutex mutex;
    std::shared_ptr<JobControl> running;
    Threads thread{1};
    ~Background() {
        {
            std::lock_guard lock(mutex);
            if (running) running->cancel();
        }
        thread.stop();
    }
};
Background& background(Lane lane) {
    pool();  // made first, so that it outlives the lanes, whose jobs use it
    static Background lanes[2];
    return lanes[static_cast<size_t>(lane)];
}

}  // namespace

int workerCount() {
    static const int count = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 64);
    return count;
}

void parallelFor(size_t count, const std::function<void(size_t)>& body) {
    const size_t helpers = std::min<size_t>(static_cast<size_t>(workerCount()), count);
    const auto loop = std::make_shared<Loop>();
    loop->body = &body;
    loop->count = count;
    for (size_t i = 1; i < helpers; ++i) pool().add([loop] { loop->work(); });
    loop->work();
    loop->wait();
    if (loop->error) std::rethrow_exception(loop->error);
}

void runInBackground(std::shared_ptr<JobControl> control, std::function<void()> work) {
    runInLane(Lane::Beside, std::move(control), std::move(work));
}

void runInLane(Lane lane, std::shared_ptr<JobControl> control, std::function<void()> work) {
    Background& b = background(lane);
    b.thread.add([&b, control = std::move(control), work = std::move(work)] {
        {
            std::lock_guard lock(b.mutex);
            b.running = control;
        }
        if (!control->cancelled()) work();
        {
            std::lock_guard lock(b.mutex);
            b.running = nullptr;
        }
        control->finished_.store(true);
    });
}

}  // namespace sward
