#include "core/error.h"

#include <cstdio>
#include <cstdlib>

namespace sward {

std::string Error::text() const {
    std::string out = file;
    if (line > 0) out += fmt::format(":{}", line);
    if (line > 0 && column > 0) out += fmt::format(":{}", column);
    if (!out.empty()) out += ": ";
    out += message;
    if (!remedy.empty()) out += " (" + remedy + ")";
    return out;
}

void checkFailed(const char* file, int line, const std::string& what) {
    std::fprintf(stderr, "%s:%d: check failed: %s\n", file, line, what.c_str());
    std::abort();
}

}  // namespace sward
