// UTF-8, the one encoding of text in the files that Sward reads and writes.
// Does not: convert from other encodings, nor normalise.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sward {

// Where the first byte stands that is not of well-formed UTF-8 (no surrogates, no overlong forms, nothing cut short);
// nothing if all is. About 1 ns a byte.
std::optional<size_t> notUtf8At(std::string_view text);
// The text with U+FFFD for each byte that is not of it: for names of files, which are any bytes.
std::string utf8Text(std::string_view bytes);

}  // namespace sward
