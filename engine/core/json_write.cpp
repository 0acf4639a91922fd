#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/json.h"

namespace sward {
namespace {

// Plain digits for ordinary sizes; "1e+05" would be shorter but nobody writes that. Exponents without "+" and zeros.
template <class T>
std::string shortest(T value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    if (value == 0) return "0";
    const T size = std::abs(value);
    const bool plain = size >= T(1e-5) && size < T(1e15);
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value,
                                   plain ? std::chars_format::fixed : std::chars_format::scientific);
    std::string text(buffer, end.ptr);
    const size_t e = text.find('e');
    if (e == std::string::npos) return text;
    std::string digits = text.substr(e + 1);
    const std::string sign = digits[0] == '-' ? "-" : "";
    digits.erase(0, digits.find_first_not_of("+-0"));
    return text.substr(0, e + 1) + sign + digits;
}

void appendString(std::string& out, std::string_view text) {
    out += '"';
    for (const char c : text) {
        switch (c) {
            case '"':
                out += "\\\"";
                break;
            case '\\':
                out += "\\\\";
                break;
            case '\n':
                out += "\\n";
                break;
            case '\t':
                out += "\\t";
                break;
            case '\r':
                out += "\\r";
                break;
            case '\b':
                out += "\\b";
                break;
            case '\f':
                out += "\\f";
                break;
            default:
                if (static_cast<unsigned char>(c) < 0x20)
                    out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
                else
                    out += c;
        }
    }
    out += '"';
}

void appendNumber(std::string& out, const Json& j) {
    if (std::isfinite(j.number))
        out += j.text.empty() ? shortest(j.number) : j.text;
    else
        appendString(out, shortest(j.number));
}

bool onOneLine(const Json::Array& values) {
    return values.size() <= 4 && std::all_of(values.begin(), values.end(), [](const Json& v) { return v.isNumber(); });
}

void append(std::string& out, const Json& j, int depth);

void appendArray(std::string& out, const Json::Array& values, int depth) {
    const bool flat = onOneLine(values);
    const std::string gap = flat ? " " : "\n" + std::string(size_t(depth + 1) * 2, ' ');
    out += '[';
    for (size_t i = 0; i < values.size(); ++i) {
        if (i > 0) out += ',';
        if (i > 0 || !flat) out += gap;
        append(out, values[i], depth + 1);
    }
    if (!flat) out += "\n" + std::string(size_t(depth) * 2, ' ');
    out += ']';
}

void appendObject(std::string& out, const Json::Object& members, int depth) {
    const std::string indent(size_t(depth + 1) * 2, ' ');
    out += '{';
    bool first = true;
    for (const auto& [key, value] : members) {
        out += first ? "\n" : ",\n";
        first = false;
        out += indent;
        appendString(out, key);
        out += ": ";
        append(out, value, depth + 1);
    }
    if (!members.empty()) out += "\n" + std::string(size_t(depth) * 2, ' ');
    out += '}';
}

void append(std::string& out, const Json& j, int depth) {
    switch (j.type) {
        case Json::Type::Null:
            out += "null";
            break;
        case Json::Type::Bool:
            out += j.boolean ? "true" : "false";
            break;
        case Json::Type::Number:
            appendNumber(out, j);
            break;
        case Json::Type::String:
            appendString(out, j.text);
            break;
        case Json::Type::Array:
            appendArray(out, j.array, depth);
            break;
        case Json::Type::Object:
            appendObject(out, j.object, depth);
            break;
    }
}

}  // namespace

std::string shortestText(float value) { return shortest(value); }
std::string shortestText(double value) { return shortest(value); }

Json::Json(float value) : type(Type::Number), number(value), text(shortest(value)) {}
Json::Json(double value) : type(Type::Number), number(value), text(shortest(value)) {}

const Json* Json::find(std::string_view key) const {
    const auto it = object.find(std::string(key));
    return it == object.end() ? nullptr : &it->second;
}

Json& Json::operator[](const std::string& key) {
    if (type == Type::Null) type = Type::Object;
    CHECK(type == Type::Object);
    return object[key];
}

void Json::push(Json value) {
    if (type == Type::Null) type = Type::Array;
    CHECK(type == Type::Array);
    array.push_back(std::move(value));
}

const char* jsonTypeName(Json::Type type) {
    constexpr const char* kNames[] = {"null", "true or false", "a number", "a string", "a list", "an object"};
    return kNames[static_cast<size_t>(type)];
}

std::string writeJson(const Json& value) {
    std::string out;
    append(out, value, 0);
    out += '\n';
    return out;
}

}  // namespace sward
