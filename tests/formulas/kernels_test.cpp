// What formulas cost, on the CPU: which forms are there, how far they are from double, and the tables. Never how long
// they take.
#include "formulas/kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace sward {
namespace {

const ExpectedValues& values() {
    static const ExpectedValues loaded = [] {
        auto read = loadExpectedValues(expectedValuesFile());
        EXPECT_TRUE(bool(read));
        return read ? *read : ExpectedValues{};
    }();
    return loaded;
}
const std::vector<Kernel>& all() {
    static const std::vector<Kernel> made = kernels(values());
    return made;
}
const Kernel& named(const std::string& part) {
    for (const Kernel& k : all())
        if (k.row.name.find(part) != std::string::npos) return k;
    ADD_FAILURE() << part;
    return all().front();
}
KernelError errorOf(const Kernel& k, const std::string& form) {
    for (const KernelForm& f : k.forms)
        if (f.name == form) return kernelError(k, runSingle(k.row, f.body, k.samples));
    ADD_FAILURE() << form;
    return {};
}
KernelRun smallRun() {
    auto run = measureKernels({1, "light weights, eqs"}, nullptr, [](const std::string&, double) { return true; });
    EXPECT_TRUE(bool(run));
    return run ? *run : KernelRun{};
}

TEST(Kernels, EveryFormulaWithMoreThanOneFormAppears) {
    std::set<decltype(FormulaBody::single)> there;
    for (const Kernel& k : all()) {
        EXPECT_GE(k.forms.size(), 2u) << k.row.name;
        std::set<std::string> names;
        for (const KernelForm& f : k.forms) there.insert(f.body.single), names.insert(f.name);
        EXPECT_EQ(names.size(), k.forms.size()) << k.row.name;
    }
    int several = 0;
    for (const FormulaRow& row : formulaRows()) {
        if (!row.published) continue;
        ++several;
        EXPECT_TRUE(there.count(row.ours.single)) << row.name;
        EXPECT_TRUE(there.count(row.published.single)) << row.name;
    }
    EXPECT_GT(several, 50);
    EXPECT_EQ(named("light weights, eqs 8-13").forms.size(), 10u);
}

TEST(Kernels, OursHoldTheirTolerancesOverTheWholeDomain) {
    for (const Kernel& k : all())
        for (const KernelForm& f : k.forms) {
            if (std::isinf(f.tolerance)) continue;
            const KernelError e = kernelError(k, runSingle(k.row, f.body, k.samples));
            EXPECT_LE(e.largest, f.tolerance) << k.row.name << ", " << f.name << " at " << (e.at.empty() ? 0 : e.at[0]);
            EXPECT_EQ(e.notFinite, 0) << k.row.name << ", " << f.name;
        }
}

TEST(Kernels, PublishedFormsFailWhereTheHardCasesSay) {
    for (const char* name :
         {"light weights, eqs 8-13", "light weights near quadrant planes", "level-of-detail weights", "opacity, eq 5",
          "frame of a blade, upright", "way out of the shadow mask's cylinder", "offsets of tilted slices",
          "first hit of a ray", "frame of a blade between two splines", "point light seen"})
        EXPECT_GT(errorOf(named(name), "published").notFinite, 0) << name;
    EXPECT_GT(errorOf(named("opacity correction, 8 bits"), "published").largest, 0.3);
}

TEST(Kernels, FormsOfLightWeightsAreAsAccurateAsTheirTableSays) {
    const Kernel& k = named("light weights, eqs 8-13");
    EXPECT_GT(k.samples.count, 4000);
    const std::vector<const char*> order = {
        "three atan", "degree 13", "degree 9", "degree 7", "degree 5", "degree 3", "normalised components", "squares"};
    for (size_t i = 1; i < order.size(); ++i)
        EXPECT_LT(errorOf(k, order[i - 1]).largest, errorOf(k, order[i]).largest) << order[i];
    EXPECT_GT(errorOf(k, "published").largest, 1e-4);
    EXPECT_EQ(errorOf(k, "published").fails.size(), 3u);
}

TEST(Kernels, ContinuousFormulasAreTriedOnThousandsOfInputs) {
    int dense = 0;
    for (const Kernel& k : all()) {
        EXPECT_GT(k.samples.count, 0) << k.row.name;
        EXPECT_EQ(k.samples.want.size(), size_t(k.samples.count) * size_t(k.row.outputs)) << k.row.name;
        EXPECT_EQ(k.samples.scale.size(), k.samples.want.size()) << k.row.name;
        dense += k.samples.count >= 4000;
    }
    EXPECT_GE(dense, 20);
}

TEST(Kernels, AnInputWithoutAFiniteAnswerIsCountedAndInNoError) {
    Kernel k;
    k.row.inputs = k.row.outputs = 1;
    k.samples.add({1}, {1});
    k.samples.add({2}, {5});
    k.samples.add({3}, {7});
    const double inf = std::numeric_limits<double>::infinity();
    const KernelError e = kernelError(k, {1.5, inf, 7});
    EXPECT_EQ(e.largest, 0.5);
    EXPECT_EQ(e.at, std::vector<double>{1});
    EXPECT_EQ(e.notFinite, 1);
    EXPECT_EQ(e.fails, std::vector<double>{2});
    EXPECT_TRUE(std::isnan(kernelError(k, {inf, inf, std::nan("")}).largest));
}

TEST(Kernels, ErrorsAreTheSameInEveryRun) {
    const KernelRun a = smallRun(), b = smallRun();
    ASSERT_EQ(a.rows.size(), 10u);
    ASSERT_EQ(b.rows.size(), a.rows.size());
    for (size_t i = 0; i < a.rows.size(); ++i) {
        EXPECT_EQ(a.rows[i].form, b.rows[i].form);
        EXPECT_EQ(a.rows[i].cpu.largest, b.rows[i].cpu.largest);
        EXPECT_EQ(a.rows[i].cpu.notFinite, b.rows[i].cpu.notFinite);
        EXPECT_EQ(a.rows[i].cpu.at, b.rows[i].cpu.at);
        EXPECT_FALSE(std::isnan(a.rows[i].cpuTime.ns));
        EXPECT_TRUE(std::isnan(a.rows[i].shaderTime.ns));
    }
}

// Fields of a line of CSV.
std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> out(1);
    bool inside = false;
    for (const char c : line) {
        if (c == '"')
            inside = !inside;
        else if (c == ',' && !inside)
            out.emplace_back();
        else
            out.back() += c;
    }
    return out;
}

TEST(Kernels, TablesParseAndAgree) {
    const KernelRun run = smallRun();
    const auto json = nlohmann::json::parse(writeJson(kernelJson(run)));
    EXPECT_TRUE(json.at("renderer").is_null());
    ASSERT_EQ(json.at("rows").size(), run.rows.size());
    std::istringstream csv(kernelCsv(run));
    std::string line;
    std::getline(csv, line);
    const std::vector<std::string> columns = fields(line);
    for (size_t i = 0; i < run.rows.size(); ++i) {
        const auto& j = json["rows"][i];
        ASSERT_TRUE(std::getline(csv, line));
        const std::vector<std::string> cells = fields(line);
        ASSERT_EQ(cells.size(), columns.size());
        for (size_t c = 0; c < columns.size(); ++c) {
            ASSERT_TRUE(j.contains(columns[c])) << columns[c];
            const auto& value = j[columns[c]];
            if (value.is_number()) EXPECT_EQ(value.get<double>(), std::stod(cells[c])) << columns[c];
            if (value.is_string()) EXPECT_EQ(value.get<std::string>(), cells[c]);
            if (value.is_null()) EXPECT_EQ(cells[c], "") << columns[c];
        }
        EXPECT_TRUE(j["ns_shader"].is_null());
        EXPECT_GT(j["inputs"].get<int>(), 4000);
    }
    EXPECT_FALSE(std::getline(csv, line));
}

TEST(Kernels, TextHasALineAFormAndSaysThatThereIsNoContext) {
    const KernelRun run = smallRun();
    const std::string text = kernelText(run);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), ptrdiff_t(run.rows.size()) + 4);
    EXPECT_NE(text.find("no OpenGL context"), std::string::npos);
    EXPECT_NE(text.find("light weights, eqs 8-13, "), std::string::npos);
}

TEST(Kernels, StopsWhenToldTo) {
    const auto run = measureKernels({1, ""}, nullptr, [](const std::string&, double) { return false; });
    ASSERT_FALSE(bool(run));
    EXPECT_EQ(run.error().code, ExitCode::Interrupted);
}

}  // namespace
}  // namespace sward
