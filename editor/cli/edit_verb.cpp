#include "app/edit_main.h"
#include "cli/cli.h"

namespace sward {

int editVerb(const std::string& project) { return editMain(project); }

}  // namespace sward
