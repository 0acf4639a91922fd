// The table of techniques: what a row says, and that nothing else names one.
#include "scene/technique.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>

#include "fields.h"
#include "sources.h"
#include "support.h"

namespace sward::test {
namespace {
namespace fs = std::filesystem;

TEST(TechniqueTable, NamesLabelsAndColoursAreEachRowsOwn) {
    std::set<std::string> names, labels;
    std::set<uint32_t> colors;
    for (const TechniqueRow& row : tables().techniques) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_TRUE(labels.insert(row.label).second) << row.label;
        EXPECT_TRUE(colors.insert(row.color).second) << row.name;
        EXPECT_EQ(findTechnique(tables().techniques, row.name), &row);
        EXPECT_TRUE(row.features && row.tiers && std::string(row.help).size() > 10) << row.name;
        for (const char* settings : row.settings)
            EXPECT_TRUE(findComponent(tables().components, settings)) << row.name << " reads " << settings;
        for (const KnobRow& knob : row.knobs) EXPECT_LE(knob.least, knob.most) << row.name << ", " << knob.name;
        EXPECT_EQ(row.knobs.empty(), row.turned == nullptr) << row.name;
    }
    EXPECT_EQ(findTechnique(tables().techniques, "felt"), nullptr);
    EXPECT_EQ(techniqueColor(tables().techniques, "felt"), "#808080");
}

TEST(TechniqueTable, EveryTurnOfItsKnobsIsASettingThatCanBeSet) {
    EXPECT_EQ(samplesTurned(1), "msaa=4");
    EXPECT_EQ(samplesTurned(0.7), "msaa=2");
    EXPECT_EQ(samplesTurned(0.25), "msaa=1");
    for (const TechniqueRow& row : tables().techniques) {
        if (!row.turned) continue;
        FlatField f;
        f.technique = row.name;
        for (const double turn : {-1.0, 0.0, 1.0}) {
            std::vector<double> knobs;
            for (const KnobRow& k : row.knobs)
                knobs.push_back(std::clamp(k.factor ? k.start * std::exp2(turn) : k.start + turn, k.least, k.most));
            for (const std::string& value : row.turned(f.asField(), knobs))
                EXPECT_LT(value.find('='), value.size() - 1) << row.name << ": " << value;
        }
    }
}

TEST(TechniqueTable, ItsRowsAskForWhatEffectsDraw) {
    if (tables().effects.empty()) GTEST_SKIP() << "a program that draws nothing";
    for (const TechniqueRow& row : tables().techniques) {
        FlatField f;
        f.technique = row.name;
        const FeatureSet asked = row.features(f.asField());
        EXPECT_TRUE(asked.any()) << row.name;
        EXPECT_TRUE(std::any_of(tables().effects.begin(), tables().effects.end(), [&](const EffectRow& e) {
            return (e.needs & asked).any();
        })) << row.name;
    }
}

TEST(TechniqueTable, AFieldOfATechniqueThatIsNotThereDrawsNothing) {
    FlatField f;
    f.technique = "felt";
    const FieldTiers tiers = tiersOf(tables().techniques, f.asField(), kPixelsPerMetre);
    EXPECT_EQ(tiers.blades.max, 0);
    EXPECT_LT(tiers.slicesFrom, 0);
    EXPECT_LT(tiers.flatFrom, 0);
}

// Texts in double quotes that are a technique's name, of one line.
std::vector<std::string> namedIn(const std::string& line) {
    static const std::regex text(R"re("([a-z]+)")re");
    std::vector<std::string> out;
    for (std::sregex_iterator it(line.begin(), line.end(), text), end; it != end; ++it)
        if (findTechnique(tables().techniques, (*it)[1].str())) out.push_back((*it)[1]);
    return out;
}

TEST(TechniqueTable, NoSourceOutsideTheStemsListsOrAsksForTechniques) {
    const fs::path root(SWARD_SOURCE_DIR);
    // A branch on a name; or a name where no field, file or tier is called so as well.
    static const std::regex branch(R"((technique|name) *[=!]= *"|technique\.compare|case Technique)");
    size_t files = 0, stems = 0;
    for (const fs::path& file : sources(root, {"engine", "editor"})) {
        ++files;
        const std::string text = readText(root / file);
        const auto says = [&](const char* words) { return text.find(words) != std::string::npos; };
        if (says("TechniqueRow kRows[]") || (says("TechniqueRow") && says(".label = "))) {
            ++stems;
            continue;
        }
        std::set<std::string> inFile;
        for (const std::string& line : linesOf(root / file)) {
            if (line.find("enumNames<") != std::string::npos) continue;  // the values of a field
            const std::vector<std::string> named = namedIn(line.substr(0, line.find("//")));
            inFile.insert(named.begin(), named.end());
            if (!named.empty()) EXPECT_FALSE(std::regex_search(line, branch)) << file << ": " << line;
        }
        EXPECT_LT(inFile.size(), 2u) << file << " lists techniques";
    }
    EXPECT_GT(files, 200u);
    EXPECT_EQ(stems, 3u) << "files of rows";
}

}  // namespace
}  // namespace sward::test
