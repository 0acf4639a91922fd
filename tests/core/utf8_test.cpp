// UTF-8: what is well-formed, and where it is not.
#include "core/utf8.h"

#include <gtest/gtest.h>

using namespace sward;

TEST(Utf8, WellFormedTextOfEveryLengthPasses) {
    for (const char* text : {"", "a", "\x7f", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80",
                             "\xef\xbf\xbf", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf", "Wiese \xc3\xbc\xe2\x82\xac"})
        EXPECT_FALSE(notUtf8At(text)) << text;
}

TEST(Utf8, TheFirstByteThatIsNotOfItIsNamed) {
    struct Case {
        const char* text;
        size_t at;
    };
    const Case cases[] = {{"caf\xe9", 3},          {"\x80", 0},
                          {"ab\xc3", 2},           {"\xc3\x28", 0},
                          {"\xc0\xaf", 0},         {"\xe0\x9f\xbf", 0},
                          {"\xed\xa0\x80", 0},     {"\xf0\x8f\xbf\xbf", 0},
                          {"\xf4\x90\x80\x80", 0}, {"\xf5\x80\x80\x80", 0},
                          {"x\xe2\x82", 1},        {"\xc3\xbc\xff", 2}};
    for (const Case& c : cases) EXPECT_EQ(notUtf8At(c.text), c.at) << c.text;
}

TEST(Utf8, OtherBytesAreReplacedOneByOne) {
    EXPECT_EQ(utf8Text("w\xc3\xbc"), "w\xc3\xbc");
    EXPECT_EQ(utf8Text("caf\xe9 \xff!"), "caf\xef\xbf\xbd \xef\xbf\xbd!");
    EXPECT_EQ(utf8Text(""), "");
}
