// Reading. The one file that includes nlohmann/json, for its header takes four seconds to compile. Its SAX interface
// neither recurses nor builds a tree; it gives no places, so they are found from how far its iterator has come.
#include "core/json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>

#include "core/file.h"
#include "core/utf8.h"

namespace sward {
namespace {

struct Place {
    int line = 0, column = 0;
};
// 1-based; a column counts bytes.
Place placeOf(std::string_view text, size_t offset) {
    offset = std::min(offset, text.size());
    const std::string_view before = text.substr(0, offset);
    const size_t lineStart = before.rfind('\n');
    return {1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
            1 + static_cast<int>(lineStart == std::string_view::npos ? offset : offset - lineStart - 1)};
}

// An iterator over the text that tells where the parser has come to.
struct CountingIterator {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;
    const char* at = nullptr;
    const char** furthest = nullptr;

    reference operator*() const { return *at; }
    CountingIterator& operator++() {
        ++at;
        if (furthest) *furthest = at;
        return *this;
    }
    CountingIterator operator++(int) {
        CountingIterator old = *this;
        ++*this;
        return old;
    }
    bool operator==(const CountingIterator& other) const { return at == other.at; }
};

// Builds the tree. Every callback returns false to stop, with `error` set.
class Builder {
  public:
    using number_integer_t = nlohmann::json::number_integer_t;
    using number_unsigned_t = nlohmann::json::number_unsigned_t;
    using number_float_t = nlohmann::json::number_float_t;
    using string_t = nlohmann::json::string_t;
    using binary_t = nlohmann::json::binary_t;

    Builder(std::string_view text, const std::string& file)
        : furthest(text.data()), text_(text), file_(file), done_(text.data()) {}

    const char* furthest;  // just behind the last character that the parser took
    Json root;
    Error error;

    bool null() { return put(Json()); }
    bool boolean(bool value) { return put(Json(value)); }
    bool number_integer(number_integer_t value) { return put(Json(value)); }
    bool number_unsigned(number_unsigned_t value) { return put(Json(value)); }
    bool number_float(number_float_t value, const string_t& digits) {
        Json j(value);
        j.text = digits;
        return put(std::move(j));
    }
    bool string(string_t& value) { return put(Json(std::move(value))); }
    bool binary(binary_t&) { return fail("binary data"); }
    bool start_object(size_t) { return open(Json::makeObject()); }
    bool start_array(size_t) { return open(Json::makeArray()); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool key(string_t& name) {
        keyPlace_ = nextPlace();
        if (stack_.back()->object.contains(name))
            return fail(fmt::format("duplicate key \"{}\"", name), keyPlace_, "remove one of the two");
        key_ = name;
        done_ = furthest;
        return true;
    }
    bool parse_error(size_t position, const std::string&, const nlohmann::json::exception& e) {
        return fail(tidy(e.what()), placeOf(text_, position > 0 ? position - 1 : 0));
    }

  private:
    // The token that was just read begins at the first character since the last one that can begin a value or key.
    Place nextPlace() {
        const char* p = done_;
        while (p < furthest && std::strchr(" \t\r\n,:]}", *p)) ++p;
        scanLines(p);
        return {line_, 1 + static_cast<int>(p - lineStart_)};
    }
    // Lines are counted as the text is read, so that a large file is walked once.
    void scanLines(const char* to) {
        if (!scanned_) scanned_ = lineStart_ = text_.data();
        for (; scanned_ < to; ++scanned_)
            if (*scanned_ == '\n') {
                ++line_;
                lineStart_ = scanned_ + 1;
            }
    }
    bool fail(std::string message, Place place = {}, std::string remedy = {}) {
        if (place.line == 0) place = nextPlace();
        error = unsound(std::move(message), std::move(remedy)).at(file_, place.line, place.column);
        return false;
    }
    Json* put_(Json value) {
        const Place place = nextPlace();
        value.line = place.line;
        value.column = place.column;
        done_ = furthest;
        if (stack_.empty()) return &(root = std::move(value));
        Json& parent = *stack_.back();
        if (parent.isArray()) {
            parent.array.push_back(std::move(value));
            return &parent.array.back();
        }
        value.keyLine = keyPlace_.line;
        value.keyColumn = keyPlace_.column;
        return &(parent.object[key_] = std::move(value));
    }
    bool isOneTooMany() { return ++values_ > kMaxJsonValues; }
    bool failTooMany() { return fail(fmt::format("more than {} values", kMaxJsonValues), {}, "make it smaller"); }
    bool put(Json value) {
        if (isOneTooMany()) return failTooMany();
        put_(std::move(value));
        return true;
    }
    bool open(Json value) {
        if (isOneTooMany()) return failTooMany();
        if (stack_.size() >= size_t(kMaxJsonDepth))
            return fail(fmt::format("more than {} levels of nesting", kMaxJsonDepth));
        stack_.push_back(put_(std::move(value)));
        return true;
    }
    bool close() {
        stack_.pop_back();
        done_ = furthest;
        return true;
    }
    // "[json.exception.parse_error.101] parse error at line 2, column 3: syntax error while ... - what" -> the end of
    // it
    static std::string tidy(std::string what) {
        if (what.find("out_of_range") != std::string::npos) return "a number that is too large to hold";
        const size_t place = what.find("column ");
        const size_t colon = place == std::string::npos ? place : what.find(": ", place);
        if (colon != std::string::npos) what = what.substr(colon + 2);
        return what;
    }

    std::string_view text_;
    std::string file_;
    const char* done_;  // everything before has been used
    const char* scanned_ = nullptr;
    const char* lineStart_ = nullptr;
    int line_ = 1;
    size_t values_ = 0;
    std::vector<Json*> stack_;  // open objects and arrays; a parent does not grow while a child is open
    std::string key_;
    Place keyPlace_;
};

// The parser takes a NUL byte for the end of the text, and would leave what follows unread.
Status checkBytes(std::string_view text, const std::string& file) {
    const auto refuse = [&](const char* what, size_t offset, const char* remedy) {
        const Place place = placeOf(text, offset);
        return unsound(what, remedy).at(file, place.line, place.column);
    };
    if (const size_t nul = text.find('\0'); nul != std::string_view::npos)
        return refuse("holds a NUL byte", nul, "remove it, or take the file from a copy");
    if (const auto foreign = notUtf8At(text))
        return refuse("holds a byte that is not UTF-8", *foreign, "save the file in UTF-8");
    return {};
}

}  // namespace

Result<Json> parseJson(std::string_view text, const std::string& file) {
    if (Status s = checkLength(text.size(), kMaxJsonBytes); !s) return s.error().at(file);
    if (Status s = checkBytes(text, file); !s) return s.error();
    if (text.empty()) return unsound("unexpected end of input").at(file, 1, 1);  // libraries' words for it differ
    Builder builder(text, file);
    const CountingIterator begin{text.data(), &builder.furthest}, end{text.data() + text.size(), nullptr};
    if (!nlohmann::json::sax_parse(begin, end, &builder)) return builder.error;
    return std::move(builder.root);
}

Result<Json> readJson(const std::filesystem::path& file) {
    Result<std::string> text = readFile(file, kMaxJsonBytes);
    if (!text) return text.error();
    return parseJson(*text, file.string());
}

}  // namespace sward
