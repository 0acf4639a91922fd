#include <csignal>

#include "bakes.h"
#include "cli/cli.h"
#include "techniques.h"

namespace sward {
namespace {

// Ctrl+C cancels what is baked, so that no file is left half-written.
volatile std::sig_atomic_t interrupted = 0;
void interrupt(int) { interrupted = 1; }

// A line on standard error that is written over, where a person looks; elsewhere nothing. False once interrupted.
BakeProgress progressLine(const std::string& name) {
    return [name, last = -1](double share) mutable {
        const int percent = static_cast<int>(share * 100);
        if (percent != last && isatty(STDERR_FILENO)) std::fprintf(stderr, "\r%s %3d %%%s", name.c_str(), percent, percent == 100 ? "\n" : "");
        last = percent;
        return interrupted == 0;
    };
}

bool wanted(const BakeCommand& o, const BakeRow& row) { return o.only.empty() || std::find(o.only.begin(), o.only.end(), row.flag) != o.only.end(); }

Status bakeRowsOf(Document& document, const BakeCommand& o) {
    for (const BakeRow& row : bakeRows()) {
        if (!wanted(o, row)) continue;
        const auto start = std::chrono::steady_clock::now();
        const Result<std::string> made = row.run(document, {o.samples, o.size}, progressLine(row.name));
        if (!made) return made.error();
        std::fprintf(stderr, "%s: %s (%.1f s)\n", row.name, made->c_str(), std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return {};
}

}  // namespace

int bakeVerb(const BakeCommand& o) {
    if (Status s = checkBakeSettings({o.samples, o.size}); !s) return report(s.error());
    Document document(tables());
    if (Status s = document.open(o.project); !s) return report(s.error());
    interrupted = 0;
    const auto before = std::signal(SIGINT, interrupt);
    const Status made = bakeRowsOf(document, o);
    std::signal(SIGINT, before);
    if (!made) return interrupted ? static_cast<int>(ExitCode::Interrupted) : report(made.error());
    if (!document.dirty()) return 0;
    const auto written = document.save();
    if (!written) return report(written.error());
    for (const std::string& f : *written) std::printf("%s\n", (std::filesystem::path(o.project) / f).string().c_str());
    return 0;
}

}  // namespace sward
