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

Error Error::at(std::string where, int atLine, int atColumn) const {
    return {code, message, std::move(where), atLine, atColumn, remedy};
}

Error failed(std::string message, std::string remedy) {
    return {ExitCode::Failed, std::move(message), {}, 0, 0, std::move(remedy)};
}
Error usage(std::string message, std::string remedy) {
    return {ExitCode::Usage, std::move(message), {}, 0, 0, std::move(remedy)};
}
Error unsound(std::string message, std::string remedy) {
    return {ExitCode::Unsound, std::move(message), {}, 0, 0, std::move(remedy)};
}
Error noContext(std::string message, std::string remedy) {
    return {ExitCode::NoContext, std::move(message), {}, 0, 0, std::move(remedy)};
}
Error interruption(std::string message, std::string remedy) {
    return {ExitCode::Interrupted, std::move(message), {}, 0, 0, std::move(remedy)};
}

void checkFailed(const char* file, int line, const std::string& what) {
    std::fprintf(stderr, "%s:%d: check failed: %s\n", file, line, what.c_str());
    std::abort();
}

}  // namespace sward
