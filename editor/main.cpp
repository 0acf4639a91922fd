// Starts sward: see cli/cli.h.
#include "cli/cli.h"

int main(int argc, char** argv) { return sward::runCommandLine(argc, argv); }
