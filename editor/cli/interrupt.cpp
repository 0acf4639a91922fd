#include "cli/interrupt.h"

#include <unistd.h>

#include <csignal>

namespace sward {
namespace {

volatile std::sig_atomic_t pressed = 0;
void press(int) { pressed = 1; }

}  // namespace

Interruptible::Interruptible() {
    pressed = 0;
    before_ = std::signal(SIGINT, press);
}
Interruptible::~Interruptible() { std::signal(SIGINT, before_); }
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
