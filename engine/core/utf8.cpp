#include "core/utf8.h"

#include <cstdint>

namespace sward {
namespace {

// How many bytes follow a first byte, what its own bits say, and the least code that needs so many.
struct Lead {
    size_t more;
    uint32_t bits, least;
};
std::optional<Lead> leadOf(unsigned char c) {
    if (c < 0x80) return Lead{0, c, 0};
    if (c >= 0xc2 && c < 0xe0) return Lead{1, c & 0x1fu, 0x80};
    if (c >= 0xe0 && c < 0xf0) return Lead{2, c & 0x0fu, 0x800};
    if (c >= 0xf0 && c < 0xf5) return Lead{3, c & 0x07u, 0x10000};
    return std::nullopt;
}

// Bytes of the character at the beginning; 0: it is none.
size_t characterBytes(std::string_view text) {
    const std::optional<Lead> lead = leadOf(static_cast<unsigned char>(text[0]));
    if (!lead || text.size() <= lead->more) return 0;
    uint32_t code = lead->bits;
    for (size_t i = 1; i <= lead->more; ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        if ((c & 0xc0) != 0x80) return 0;
        code = code << 6 | (c & 0x3fu);
    }
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    return code < lead->least || code > 0x10ffff || surrogate ? 0 : lead->more + 1;
}

}  // namespace

std::optional<size_t> notUtf8At(std::string_view text) {
    for (size_t at = 0; at < text.size();) {
        if (static_cast<unsigned char>(text[at]) < 0x80) {
            ++at;  // most are
            continue;
        }
        const size_t bytes = characterBytes(text.substr(at));
        if (bytes == 0) return at;
        at += bytes;
    }
    return std::nullopt;
}

std::string utf8Text(std::string_view bytes) {
    std::string text;
    while (const std::optional<size_t> at = notUtf8At(bytes)) {
        text.append(bytes.substr(0, *at)).append("\xef\xbf\xbd");
        bytes.remove_prefix(*at + 1);
    }
    return text.append(bytes);
}

}  // namespace sward
