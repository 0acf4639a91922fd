// The budget of memory: how it is written, and that what goes beyond it fails.
#include "core/memory_budget.h"

#include <gtest/gtest.h>

#include <memory>
#include <new>

#include "child.h"

namespace sward {
namespace {

constexpr uint64_t kGiB = uint64_t(1) << 30;

const test::ChildFunctionRow kAllocate("allocate", [](const std::vector<std::string>& args) -> std::string {
    if (!boundMemory(std::stoull(args.at(0)))) return "not bounded";
    try {
        const auto bytes = std::make_unique<char[]>(std::stoull(args.at(1)));
        return bytes[0] == 0 ? "there" : "not empty";
    } catch (const std::bad_alloc&) {
        return "refused";
    }
});

std::string allocates(uint64_t budget, uint64_t bytes) {
    return test::runChild("allocate", {std::to_string(budget), std::to_string(bytes)});
}

TEST(MemoryBudget, IsAShareOfTheMachineOrWhatIsAsked) {
    EXPECT_EQ(*memoryBudget("", 10 * kGiB), 8 * kGiB);
    EXPECT_EQ(*memoryBudget("50%", 10 * kGiB), 5 * kGiB);
    EXPECT_EQ(*memoryBudget("1.5G", 1), kGiB * 3 / 2);
    EXPECT_EQ(*memoryBudget("800M", 1), uint64_t(800) << 20);
    for (const char* bad : {"G", "12", "12 G", "0G", "-1G", "10M", "nan%", "inf%", "1e300G", "60%%"})
        EXPECT_FALSE(memoryBudget(bad, 10 * kGiB)) << bad;
    EXPECT_GT(machineMemory(), kGiB / 2);
}

TEST(MemoryBudget, WhatGoesBeyondItFailsAndIsTold) {
    EXPECT_EQ(allocates(kGiB, kGiB / 4), "there");
    EXPECT_EQ(allocates(kGiB, 2 * kGiB), "refused");
    const Error e = outOfMemory(3 * kGiB);
    EXPECT_NE(e.text().find("3 GB"), std::string::npos) << e.text();
    EXPECT_NE(e.text().find("SWARD_MEMORY"), std::string::npos) << e.text();
}

}  // namespace
}  // namespace sward
