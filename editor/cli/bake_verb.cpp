#include <chrono>

#include "cli/cli.h"
#include "cli/interrupt.h"
#include "model/bakes.h"
#include "techniques.h"

namespace sward {
namespace {

bool wanted(const BakeCommand& o, const BakeRow& row) {
    return o.only.empty() || std::find(o.only.begin(), o.only.end(), row.flag) != o.only.end();
}

Status bakeRowsOf(Document& document, const BakeCommand& o) {
    for (const BakeRow& row : bakeRows()) {
        if (!wanted(o, row)) continue;
        const auto start = std::chrono::steady_clock::now();
        const Result<std::string> made = row.run(document, {o.samples, o.size}, progressLine(row.name));
        if (!made) return made.error();
        std::fprintf(stderr, "%s: %s (%.1f s)\n", row.name, made->c_str(),
                     std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return {};
}

}  // namespace

int bakeVerb(const BakeCommand& o) {
    if (Status s = checkBakeSettings({o.samples, o.size}); !s) return report(s.error());
    Document document(tables());
    if (Status s = document.open(o.project); !s) return report(s.error());
    const Interruptible here;
    const Status made = bakeRowsOf(document, o);
    if (!made) return interrupted() ? static_cast<int>(ExitCode::Interrupted) : report(made.error());
    if (!document.dirty()) return 0;
    const auto written = document.save();
    if (!written) return report(written.error());
    for (const std::string& f : *written) std::printf("%s\n", (std::filesystem::path(o.project) / f).string().c_str());
    return 0;
}

}  // namespace sward
