#include "bakes.h"
#include "cli/cli.h"
#include "core/log.h"
#include "techniques.h"

namespace sward {
namespace {

// A line on standard error that is written over, where a person looks; elsewhere nothing.
BakeProgress progressLine(const std::string& name) {
    return [name, last = -1](double share) mutable {
        const int percent = static_cast<int>(share * 100);
        if (percent != last && isatty(STDERR_FILENO)) std::fprintf(stderr, "\r%s %3d %%%s", name.c_str(), percent, percent == 100 ? "\n" : "");
        last = percent;
        return true;
    };
}

bool wanted(const BakeCommand& o, const BakeRow& row) { return o.only.empty() || std::find(o.only.begin(), o.only.end(), row.flag) != o.only.end(); }

}  // namespace

int bakeVerb(const BakeCommand& o) {
    const BakeSettings settings{o.samples, o.size};
    if (Status s = checkBakeSettings(settings); !s) return report(s.error());
    Document document(tables());
    if (Status s = document.open(o.project); !s) return report(s.error());
    for (const BakeRow& row : bakeRows()) {
        if (!wanted(o, row)) continue;
        const auto start = std::chrono::steady_clock::now();
        if (Status s = row.run(document, settings, progressLine(row.name)); !s) return report(s.error());
        logInfo(fmt::format("{}: {:.1f} s", row.name, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()));
    }
    const auto written = document.save();
    if (!written) return report(written.error());
    for (const std::string& f : *written) std::printf("%s\n", (std::filesystem::path(o.project) / f).string().c_str());
    return 0;
}

}  // namespace sward
