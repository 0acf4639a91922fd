#include "editor/ui/widget_list.h"

#include <gtest/gtest.h>

namespace sward::ui {
namespace {

TEST(WidgetList, HasALineAWidgetWithItsPlaceStateAndValue) {
    WidgetBook book;
    book.widgets["Brush/Radius"] = {Kind::Slider, 10, 20, 110.4f, 40, "3", true, true, false};
    book.widgets["Menu/File"] = {Kind::Menu, 0, 0, 40, 18, "", true, true, true};
    book.widgets["Status/Message"] = {Kind::Label, 1, 2, 3, 4, "two\nlines\tof text", false, false, false};
    EXPECT_EQ(widgetList(book),
              "Brush/Radius\t10\t20\t110\t40\tve\t3\n"
              "Menu/File\t0\t0\t40\t18\tveo\t\n"
              "Status/Message\t1\t2\t3\t4\t-\ttwo lines of text\n");
    EXPECT_EQ(widgetList({}), "");
}

}  // namespace
}  // namespace sward::ui
