#include "cli/interrupt.h"

#include <unistd.h>

#include <csignal>

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

std::function<bool(double)> progressLine(const std::string& name) {
    return [name, last = -1](double share) mutable {
        const int percent = static_cast<int>(share * 100);
        if (percent != last && isatty(STDERR_FILENO))
            std::fprintf(stderr, "\r%s %3d %%%s", name.c_str(), percent, percent == 100 ? "\n" : "");
        last = percent;
        return !interrupted();
    };
}

}  // namespace sward
