#include "cli/cli.h"
#include "edit_main.h"

namespace sward {

int editVerb(const std::string& project) { return editMain(project); }

}  // namespace sward
