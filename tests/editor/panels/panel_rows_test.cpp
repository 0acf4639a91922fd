// The table of panels, and that it alone hands the editor's parts out.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "panels/panels.h"
#include "support.h"

namespace sward {
namespace {

namespace fs = std::filesystem;

TEST(PanelRows, NamesAreOnesOwnAndTheBottomsTabsAreThere) {
    std::set<std::string> names, bottom;
    for (const PanelRow& row : panelRows()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_TRUE(row.draw) << row.name;
        if (row.dock == Dock::Bottom) bottom.insert(row.name);
    }
    EXPECT_EQ(bottom, std::set<std::string>(std::begin(kBottomPanels), std::end(kBottomPanels)));
}

// Who includes the whole editor can reach all of it.
TEST(PanelRows, OnlyTablesLoopAndDriverKnowTheWholeEditor) {
    const std::set<std::string> may{"app/app.cpp",   "app/commands.cpp",      "app/edit_main.cpp",
                                    "ui/driver.cpp", "panels/panel_rows.cpp", "ui/driver.h"};
    std::set<std::string> does;
    const fs::path root = fs::path(SWARD_SOURCE_DIR) / "editor";
    for (const auto& entry : fs::recursive_directory_iterator(root))
        if (const fs::path ext = entry.path().extension(); ext == ".h" || ext == ".cpp")
            if (test::readText(entry.path()).find("#include \"app/app.h\"") != std::string::npos)
                does.insert(entry.path().lexically_relative(root).string());
    for (const std::string& file : does) EXPECT_TRUE(may.contains(file)) << file << " gets more than it uses";
    EXPECT_TRUE(does.contains("panels/panel_rows.cpp")) << "the test reads nothing";
}

}  // namespace
}  // namespace sward
