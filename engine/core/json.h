// JSON: a light value with the place it stood at, a strict reader, and a writer with one form for equal values.
// Reading refuses: more than kMaxJsonDepth levels, kMaxJsonBytes or kMaxJsonValues, NUL bytes, other text than UTF-8,
// duplicate keys, numbers that overflow, anything after the value; every fault has file, line and column.
// Writing: sorted keys, two-space indent, one value a line, arrays of at most four numbers on one line, the shortest
// digits that read back as the same number, "inf" (a string) for infinity.
// Does not: know any schema. Costs about 60 ns a byte to read.
#pragma once
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace sward {

inline constexpr int kMaxJsonDepth = 64;
// A lamp with its place takes about 360 bytes as a project writes it, in 14 values: 100,000 of them are 36 MB. So many
// bytes hold about 180,000, which load in three seconds with 1 GB of memory.
inline constexpr size_t kMaxJsonBytes = size_t(64) << 20;
// A value takes 150 to 300 bytes of memory, and "[0,0," two of a file: this bounds what a small file may ask for.
inline constexpr size_t kMaxJsonValues = 4'000'000;

struct Json {
    enum class Type { Null, Bool, Number, String, Array, Object };
    using Array = std::vector<Json>;
    using Object = std::map<std::string, Json>;

    Type type = Type::Null;
    bool boolean = false;
    double number = 0;
    std::string text;  // String: its value; Number: its digits as read or as they will be written
    Array array;
    Object object;
    int line = 0, column = 0;        // 1-based, of its first character; 0: not read from a file
    int keyLine = 0, keyColumn = 0;  // of the key before it, if any

    Json() = default;
    Json(bool value) : type(Type::Bool), boolean(value) {}
    Json(float value);   // shortest digits that give the same float
    Json(double value);  // shortest digits that give the same double
    template <std::integral I>
    requires(!std::same_as<I, bool>) Json(I value)
        : type(Type::Number), number(static_cast<double>(value)), text(std::to_string(value)) {}
    Json(std::string value) : type(Type::String), text(std::move(value)) {}
    Json(std::string_view value) : type(Type::String), text(value) {}
    Json(const char* value) : type(Type::String), text(value) {}
    Json(Array values) : type(Type::Array), array(std::move(values)) {}
    // Array without elements: Json(Array{}) by name.
    static Json makeArray() { return Json(Array{}); }
    // Object without members.
    static Json makeObject() {
        Json j;
        j.type = Type::Object;
        return j;
    }

    // What kind of value it is; exactly one of these is true.
    bool isNull() const { return type == Type::Null; }
    bool isBool() const { return type == Type::Bool; }
    bool isNumber() const { return type == Type::Number; }
    bool isString() const { return type == Type::String; }
    bool isArray() const { return type == Type::Array; }
    bool isObject() const { return type == Type::Object; }

    // The member named so, or null; null also if this is no object.
    const Json* find(std::string_view key) const;
    // The member, made if absent; what is null becomes an object.
    Json& operator[](const std::string& key);
    // Appends; what is null becomes an array.
    void push(Json value);
};

// "object", "number" and so on, for messages.
const char* jsonTypeName(Json::Type type);

// Unsound error with the place if `text` is not one sound JSON value. `file` names it in messages.
Result<Json> parseJson(std::string_view text, const std::string& file);
// Reads and parses; also refuses what cannot be read.
Result<Json> readJson(const std::filesystem::path& file);
// Ends with a line feed. Not-a-number is written as "nan" (a string).
std::string writeJson(const Json& value);

// The shortest digits that read back as the same number: 0.1, 20000, 1e30; "inf", "-inf", "nan"; "0" for both zeros.
std::string shortestText(float value);
std::string shortestText(double value);

}  // namespace sward
