// Starts sward: see cli/cli.h.
#include <csignal>

#include "cli/cli.h"

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes becomes an error that is told
    return sward::runCommandLine(argc, argv);
}
