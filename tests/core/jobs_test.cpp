#include "core/jobs.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>

namespace sward {
namespace {

template <class T>
bool waitFor(const Job<T>& job) {
    for (int i = 0; i < 5000 && !job.finished(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return job.finished();
}

TEST(Jobs, ParallelForVisitsEveryIndexOnce) {
    for (const size_t count : {size_t(0), size_t(1), size_t(2), size_t(7), size_t(10000)}) {
        std::vector<std::atomic<int>> visits(count);
        parallelFor(count, [&](size_t i) { ++visits[i]; });
        for (const auto& v : visits) EXPECT_EQ(v.load(), 1);
    }
}

TEST(Jobs, ParallelForMayBeNestedAndCalledFromSeveralThreads) {
    std::atomic<int> sum{0};
    const auto outer = [&] { parallelFor(20, [&](size_t) { parallelFor(50, [&](size_t) { ++sum; }); }); };
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) threads.emplace_back(outer);
    for (std::thread& t : threads) t.join();
    EXPECT_EQ(sum.load(), 4 * 20 * 50);
}

TEST(Jobs, ParallelForRethrowsAndStillVisitsAll) {
    std::atomic<int> visits{0};
    EXPECT_THROW(parallelFor(100,
                             [&](size_t i) {
                                 ++visits;
                                 if (i == 13) throw std::runtime_error("thirteen");
                             }),
                 std::runtime_error);
    EXPECT_EQ(visits.load(), 100);
}

TEST(Jobs, ResultIsTakenOnceAndCarriesProgress) {
    Job<int> job("double", 7, [](JobControl& c) -> Result<int> {
        c.setProgress(2.0);  // clamped
        return 42;
    });
    ASSERT_TRUE(waitFor(job));
    EXPECT_EQ(job.progress(), 1.0);
    const auto value = job.take(7);
    ASSERT_TRUE(value && *value);
    EXPECT_EQ(**value, 42);
    EXPECT_FALSE(job.active());
    EXPECT_FALSE(job.take(7).has_value());
}

TEST(Jobs, StaleResultIsDropped) {
    Job<int> job("stale", 7, [](JobControl&) -> Result<int> { return 1; });
    ASSERT_TRUE(waitFor(job));
    EXPECT_FALSE(job.take(8).has_value());
    EXPECT_FALSE(job.active());
}

TEST(Jobs, CancelReachesTheWorkAndDropsTheResult) {
    std::atomic<bool> started{false};
    Job<int> job("long", 1, [&](JobControl& c) -> Result<int> {
        started = true;
        while (!c.cancelled()) std::this_thread::yield();
        return 5;
    });
    while (!started) std::this_thread::yield();
    EXPECT_FALSE(job.finished());
    job.cancel();
    ASSERT_TRUE(waitFor(job));
    EXPECT_FALSE(job.take(1).has_value());
}

TEST(Jobs, JobCancelledBeforeItsTurnIsNotRun) {
    std::atomic<bool> release{false}, ran{false};
    Job<int> first("first", 0, [&](JobControl&) -> Result<int> {
        while (!release) std::this_thread::yield();
        return 0;
    });
    Job<int> second("second", 0, [&](JobControl&) -> Result<int> {
        ran = true;
        return 0;
    });
    second.cancel();
    release = true;
    ASSERT_TRUE(waitFor(second));
    EXPECT_FALSE(ran.load());
}

TEST(Jobs, ExceptionOfTheWorkBecomesAnError) {
    Job<int> job("throws", 0, [](JobControl&) -> Result<int> { throw std::runtime_error("no luck"); });
    ASSERT_TRUE(waitFor(job));
    const auto value = job.take(0);
    ASSERT_TRUE(value.has_value());
    ASSERT_FALSE(*value);
    EXPECT_EQ(value->error().message, "no luck");
}

}  // namespace
}  // namespace sward
