// JSON: what the reader refuses and where, what the writer's one form is.
#include "core/json.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "tests/support.h"

using namespace sward;

namespace {
Json parsed(const std::string& text) {
    Result<Json> j = parseJson(text, "f.json");
    EXPECT_TRUE(j) << (j ? "" : j.error().text());
    return j ? *j : Json();
}
Error faultOf(const std::string& text) {
    const Result<Json> j = parseJson(text, "f.json");
    EXPECT_FALSE(j) << text.substr(0, 100);
    return j ? Error{} : j.error();
}
}  // namespace

TEST(Json, ValuesKnowWhereTheyStand) {
    const Json j = parsed("{\n  \"a\": [1,\n    2.5],\n  \"b\": {\"c\": \"x\"},\n \"d\" :true}");
    EXPECT_EQ(j.find("a")->line, 2);
    EXPECT_EQ(j.find("a")->column, 8);
    EXPECT_EQ(j.find("a")->array[0].column, 9);
    EXPECT_EQ(j.find("a")->array[1].line, 3);
    EXPECT_EQ(j.find("a")->array[1].column, 5);
    EXPECT_EQ(j.find("b")->find("c")->line, 4);
    EXPECT_EQ(j.find("b")->find("c")->column, 14);
    EXPECT_EQ(j.find("b")->find("c")->keyColumn, 9);
    EXPECT_EQ(j.find("d")->column, 7);
    EXPECT_EQ(j.find("d")->keyLine, 5);
    EXPECT_EQ(j.find("none"), nullptr);
}

TEST(Json, EveryTypeIsRead) {
    const Json j = parsed(R"([null, true, false, -3, 18446744073709551615, 1.5e-3, "a\"\u00e9\n", {}, []])");
    ASSERT_EQ(j.array.size(), 9u);
    EXPECT_TRUE(j.array[0].isNull());
    EXPECT_TRUE(j.array[1].boolean);
    EXPECT_EQ(j.array[3].number, -3);
    EXPECT_EQ(j.array[4].text, "18446744073709551615");
    EXPECT_EQ(j.array[5].number, 1.5e-3);
    EXPECT_EQ(j.array[6].text, "a\"\xc3\xa9\n");
    EXPECT_TRUE(j.array[7].isObject());
    EXPECT_TRUE(j.array[8].isArray());
}

TEST(Json, FaultsNameFileLineAndColumn) {
    struct Case {
        const char* text;
        int line, column;
        const char* part;
    };
    const Case cases[] = {
        {"{\"a\": 1,\n \"b\": 2,\n \"a\": 3}", 3, 2, "duplicate key \"a\""},
        {"[1,\n 1e400]", 2, 0, "too large"},
        {"[1,\n -1e400]", 2, 0, "too large"},
        {"[1 2]", 1, 4, "syntax error"},
        {"{\"a\": inf}", 1, 7, "invalid literal"},
        {"[1,]", 1, 4, "syntax error"},
        {"// note\n1", 1, 0, "syntax error"},
        {"1\n\n x", 3, 2, "syntax error"},
        {"\"abc", 1, 0, "missing closing quote"},
        {"", 1, 1, "unexpected end of input"},
        {"[01]", 1, 3, "syntax error"},
    };
    for (const Case& c : cases) {
        const Error e = faultOf(c.text);
        EXPECT_EQ(e.code, ExitCode::Unsound);
        EXPECT_EQ(e.file, "f.json");
        EXPECT_EQ(e.line, c.line) << c.text << "\n" << e.text();
        if (c.column > 0) {
            EXPECT_EQ(e.column, c.column) << c.text << "\n" << e.text();
        }
        EXPECT_NE(e.message.find(c.part), std::string::npos) << e.text();
        EXPECT_EQ(e.message.find("json.exception"), std::string::npos) << "not the library's words";
    }
}

TEST(Json, ANulByteIsRefusedAtItsPlaceWhereverItStands) {
    const std::string nul(1, '\0');
    struct Case {
        std::string text;
        int line, column;
    };
    const Case cases[] = {{"{\"a\": 1}\n" + nul + "{\"b\": 2}", 2, 1},
                          {"{\"a\": 1}" + nul, 1, 9},
                          {"{\n \"a" + nul + "\": 1}", 2, 4},
                          {nul, 1, 1},
                          {"[1," + nul + " 2]", 1, 4}};
    for (const Case& c : cases) {
        const Error e = faultOf(c.text);
        EXPECT_EQ(e.message, "holds a NUL byte");
        EXPECT_EQ(e.code, ExitCode::Unsound);
        EXPECT_EQ(e.line, c.line);
        EXPECT_EQ(e.column, c.column);
        EXPECT_FALSE(e.remedy.empty());
    }
    EXPECT_EQ(parsed("\"a\\u0000b\"").text, std::string("a\0b", 3)) << "written out it is a character as others";
}

TEST(Json, DepthAndSizeAreLimited) {
    parsed(std::string(kMaxJsonDepth, '[') + std::string(kMaxJsonDepth, ']'));
    EXPECT_NE(
        faultOf(std::string(kMaxJsonDepth + 1, '[') + std::string(kMaxJsonDepth + 1, ']')).message.find("64 levels"),
        std::string::npos);
    EXPECT_EQ(faultOf(std::string(200000, '[')).column, kMaxJsonDepth + 1);
    std::string objects;
    for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
    EXPECT_NE(faultOf(objects).message.find("64 levels"), std::string::npos);
    EXPECT_NE(faultOf(std::string(kMaxJsonBytes + 1, ' ')).message.find("limit"), std::string::npos);
}

TEST(Json, RandomBytesNeverCrash) {
    std::mt19937 random(11);
    const std::string alphabet = "{}[]\",:0123456789.eE+-truefalsn \n\\u\x01\xff";
    int sound = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text;
        for (size_t n = random() % 24; n > 0; --n) text += alphabet[random() % alphabet.size()];
        const Result<Json> j = parseJson(text, "f.json");
        if (j)
            ++sound;
        else
            EXPECT_GT(j.error().line, 0) << text;
    }
    EXPECT_GT(sound, 20);
}
