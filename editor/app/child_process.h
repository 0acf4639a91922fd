// A program that works beside the editor, in a process group of its own: a crash, its memory and its load are not the
// editor's. Does not: read what it writes; that goes to files.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"

namespace sward {

class ChildProcess {
  public:
    ChildProcess() = default;
    // args[0] is the program. Failed: it cannot be started. It is killed when the thread that starts it ends.
    static Result<ChildProcess> start(const std::vector<std::string>& args, const std::filesystem::path& output,
                                      const std::filesystem::path& errors);
    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&& other) noexcept;
    ~ChildProcess();  // stop()

    // Until poll has told its end, or it was stopped.
    bool running() const { return pid_ > 0; }
    // Its exit code, once, when it has ended; 128 + the signal that killed it. Nothing while it runs.
    std::optional<int> poll();
    void stop();  // kills its whole group and waits for it

  private:
    int pid_ = -1;
};

}  // namespace sward
