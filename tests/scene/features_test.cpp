// Names of the features.
#include "scene/features.h"

#include <gtest/gtest.h>

#include <cctype>
#include <set>
#include <string>

namespace sward {
namespace {

TEST(Features, HaveNamesForPeopleAndForShaders) {
    std::set<std::string> names;
    for (size_t i = 0; i < size_t(Feature::Count); ++i) {
        std::string name = featureName(Feature(i));
        EXPECT_TRUE(names.insert(name).second);
        for (char& c : name) c = c == '-' ? '_' : char(std::toupper(c));
        EXPECT_EQ(name, featureConstant(Feature(i)));
    }
}

}  // namespace
}  // namespace sward
