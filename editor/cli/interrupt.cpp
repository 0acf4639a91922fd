#include "cli/interrupt.h"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>

#include "app/time_left.h"

namespace sward {
namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t pressed = 0;
void press(int which) {
    if (pressed) {
        std::signal(which, SIG_DFL);
        std::raise(which);
    }
    pressed = 1;
}

}  // namespace

Interruptible::Interruptible() {
    pressed = 0;
    for (size_t i = 0; i < std::size(kSignals); ++i) {
        before_[i] = std::signal(kSignals[i], press);
        if (before_[i] == SIG_IGN) std::signal(kSignals[i], SIG_IGN);  // as under nohup
    }
}
Interruptible::~Interruptible() {
    for (size_t i = 0; i < std::size(kSignals); ++i) std::signal(kSignals[i], before_[i]);
}
bool interrupted() { return pressed != 0; }

std::string longTaskText(const std::string& name, double share, double seconds, const std::string& remedy) {
    constexpr double kTelling = 5, kLong = 30;
    if (!(seconds >= kTelling) || !(share > 0) || !(seconds * (1 - share) / share >= kLong)) return {};
    const std::string left = timeLeft(share, seconds);
    if (left.empty()) return {};
    return fmt::format("{}: {}; Ctrl+C ends it{}{}", name, left, remedy.empty() ? "" : "; ", remedy);
}

std::function<bool(double)> progressLine(const std::string& name, const std::string& remedy) {
    const bool person = isatty(STDERR_FILENO);
    return [=, last = -1, told = false, begun = std::chrono::steady_clock::now()](double share) mutable {
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        const int percent = static_cast<int>(share * 100);
        if (const std::string text = told ? "" : longTaskText(name, share, seconds, remedy); !text.empty()) {
            std::fprintf(stderr, "%ssward: %s\n", person ? "\r" : "", text.c_str());
            told = true;
        }
        if (percent != last && person)
            std::fprintf(stderr, "\r%s %3d %%  %-14s%s", name.c_str(), percent, timeLeft(share, seconds).c_str(),
                         percent == 100 ? "\n" : "");
        last = percent;
        return !interrupted();
    };
}

}  // namespace sward
