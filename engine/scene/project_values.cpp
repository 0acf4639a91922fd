// The values of fields as text, and the rules that hold between the fields of a component.
#include <charconv>

#include "core/file.h"
#include "core/json.h"
#include "core/utf8.h"
#include "scene/project.h"

namespace sward {
namespace {

Error refused(const ConstFieldRef& f, const std::string& message, std::string remedy = {}) {
    return usage(f.path + ": " + message, std::move(remedy));
}

std::string rangeText(const FieldRow& row) {
    const std::string inf = row.allowInf ? ", or inf" : "";
    const std::string unit = row.unit[0] ? std::string(" ") + row.unit : "";
    return fmt::format("from {} to {}{}{}", shortestText(row.hardMin), shortestText(row.hardMax), unit, inf);
}

std::string trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

bool parseNumber(const std::string& text, double& value) {
    const char* begin = text.data() + (text.starts_with("+") ? 1 : 0);
    const auto end = std::from_chars(begin, text.data() + text.size(), value);
    return end.ec == std::errc() && end.ptr == text.data() + text.size();
}

// "[1, 2]", "1, 2" or "1 2".
std::vector<std::string> splitNumbers(std::string text) {
    for (char& c : text)
        if (c == '[' || c == ']' || c == ',') c = ' ';
    std::vector<std::string> out;
    for (size_t i = 0; (i = text.find_first_not_of(" \t", i)) != std::string::npos;) {
        const size_t end = std::min(text.find_first_of(" \t", i), text.size());
        out.push_back(text.substr(i, end - i));
        i = end;
    }
    return out;
}

Result<double> numberIn(const ConstFieldRef& f, const std::string& text) {
    double value = 0;
    if (!parseNumber(text, value))
        return refused(f, fmt::format("\"{}\" is not a number", text), "it takes numbers " + rangeText(*f.row));
    const bool never = f.row->allowInf && value > 0 && std::isinf(value);
    if (!never && !(value >= f.row->hardMin && value <= f.row->hardMax))
        return refused(f, fmt::format("{} is out of range", text), "it takes numbers " + rangeText(*f.row));
    return value;
}

template <class V, class T>
Status setVector(const FieldRef& f, const std::string& text) {
    const std::vector<std::string> parts = splitNumbers(text);
    V value{};
    if (parts.size() != size_t(value.length()))
        return refused(f, fmt::format("\"{}\" is not {} numbers", text, value.length()), "write them as [1, 2]");
    for (int i = 0; i < value.length(); ++i) {
        const Result<double> number = numberIn(f, parts[size_t(i)]);
        if (!number) return number.error();
        value[i] = static_cast<T>(*number);
    }
    *static_cast<V*>(f.value) = value;
    return {};
}

Status setInt(const FieldRef& f, const std::string& text) {
    const Result<double> number = numberIn(f, text);
    if (!number) return number.error();
    if (*number != std::floor(*number)) return refused(f, fmt::format("{} is not a whole number", text));
    *static_cast<int*>(f.value) = static_cast<int>(*number);
    return {};
}

// Calls set(number) for the option that the text names.
template <class Set>
Status setOption(const FieldRef& f, const std::string& text, Set&& set) {
    std::string names;
    for (size_t i = 0; i < f.row->options.size(); ++i) {
        if (text == f.row->options[i]) {
            set(i);
            return {};
        }
        names += fmt::format("{}{}", i ? ", " : "", f.row->options[i]);
    }
    return refused(f, fmt::format("\"{}\" is none of its values", text), "it takes: " + names);
}

Status setBool(const FieldRef& f, const std::string& text) {
    if (text != "true" && text != "false") return refused(f, fmt::format("\"{}\" is neither true nor false", text));
    *static_cast<bool*>(f.value) = text == "true";
    return {};
}

Status setString(const FieldRef& f, const std::string& text) {
    if (const auto at = notUtf8At(text))
        return refused(f, fmt::format("\"{}\" is not UTF-8 from byte {} on", utf8Text(text), *at + 1),
                       "write it in UTF-8, or give the file another name");
    if (f.row->isFile && !text.empty())
        if (const Status inside = checkInside(text); !inside)
            return refused(f, inside.error().message, inside.error().remedy);
    *static_cast<std::string*>(f.value) = text;
    return {};
}

template <class V>
std::string vectorText(const V& v) {
    std::string out = "[";
    for (int i = 0; i < v.length(); ++i) out += (i ? ", " : "") + shortestText(v[i]);
    return out + "]";
}

std::string listText(const ConstFieldRef& f) {
    return fmt::format("{} element{}", f.row->list->size(f.value), f.row->list->size(f.value) == 1 ? "" : "s");
}

}  // namespace

std::string fieldText(const ConstFieldRef& f) {
    switch (f.row->type) {
        case FieldType::Bool:
            return *static_cast<const bool*>(f.value) ? "true" : "false";
        case FieldType::Int:
            return std::to_string(*static_cast<const int*>(f.value));
        case FieldType::Float:
            return shortestText(*static_cast<const float*>(f.value));
        case FieldType::Vec2:
            return vectorText(*static_cast<const glm::dvec2*>(f.value));
        case FieldType::Vec3:
            return vectorText(*static_cast<const glm::dvec3*>(f.value));
        case FieldType::Color:
            return vectorText(*static_cast<const glm::vec3*>(f.value));
        case FieldType::String:
        case FieldType::Name:
            return *static_cast<const std::string*>(f.value);
        case FieldType::Enum:
            return f.row->options[static_cast<size_t>(enumIndex(f.value))];
        case FieldType::Map:
            return static_cast<const MapField*>(f.value)->file;
        case FieldType::List:
            return listText(f);
    }
    return {};
}

Status setFieldText(const FieldRef& f, const std::string& given) {
    const std::string text = trimmed(given);
    switch (f.row->type) {
        case FieldType::Bool:
            return setBool(f, text);
        case FieldType::Int:
            return setInt(f, text);
        case FieldType::Float: {
            const Result<double> number = numberIn(f, text);
            if (!number) return number.error();
            *static_cast<float*>(f.value) = static_cast<float>(*number);
            return {};
        }
        case FieldType::Vec2:
            return setVector<glm::dvec2, double>(f, text);
        case FieldType::Vec3:
            return setVector<glm::dvec3, double>(f, text);
        case FieldType::Color:
            return setVector<glm::vec3, float>(f, text);
        case FieldType::String:
            return setString(f, given);
        case FieldType::Enum:
            return setOption(f, text, [&](size_t i) { setEnumIndex(f.value, static_cast<int>(i)); });
        case FieldType::Name:
            return setOption(f, text, [&](size_t i) { *static_cast<std::string*>(f.value) = f.row->options[i]; });
        case FieldType::Map:
            if (!text.empty()) return refused(f, "a map cannot be set by text", "import a file into it");
            *static_cast<MapField*>(f.value) = {};
            return {};
        case FieldType::List:
            return refused(f, "a list cannot be set by text", "set the fields of its elements");
    }
    return {};
}

std::vector<std::string> repairComponent(const ComponentRow& row, void* component) {
    return row.repair ? row.repair(component) : std::vector<std::string>{};
}

}  // namespace sward
