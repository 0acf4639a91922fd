#include "app/edit_main.h"
#include "cli/cli.h"

namespace sward {

int editVerb(const std::string& project, const std::string& widgets) { return editMain(project, widgets); }

}  // namespace sward
