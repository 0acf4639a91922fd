// Folders and files that come with the program: shaders, sample projects, held tables. They lie in the checkout that
// the program was built in, or in share/sward beside the bin/ in which it is installed. Does not: read them; or look
// elsewhere than beside the program, but for the source tree that it was built from.
#pragma once
#include <filesystem>
#include <string>

namespace sward {

// "shaders", "projects", "tests/data/hard-cases-expected.json": where it lies, also if it is there no more.
std::filesystem::path resource(const std::string& name);
// The same for a program that lies at `program`; `source` is the tree that it was built from.
std::filesystem::path resourceOf(const std::filesystem::path& program, const std::filesystem::path& source,
                                 const std::string& name);

}  // namespace sward
