#include "app/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "core/file.h"

namespace sward {
namespace {

int exitCodeOf(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

// After the fork: only calls that are safe beside other threads' locks.
[[noreturn]] void become(char* const* argv, int output, int errors) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    dup2(output, STDOUT_FILENO);
    dup2(errors, STDERR_FILENO);
    execv(argv[0], argv);
    _exit(127);
}

}  // namespace

Result<ChildProcess> ChildProcess::start(const std::vector<std::string>& args, const std::filesystem::path& output,
                                         const std::filesystem::path& errors) {
    std::vector<std::string> own = args;  // execv wants texts that it could write to
    std::vector<char*> argv;
    for (std::string& a : own) argv.push_back(a.data());
    argv.push_back(nullptr);
    const int flags = O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC;
    const int out = open(output.c_str(), flags, 0644), err = open(errors.c_str(), flags, 0644);
    ChildProcess child;
    if (out >= 0 && err >= 0) child.pid_ = fork();
    const int fault = errno;
    if (child.pid_ == 0) become(argv.data(), out, err);
    if (out >= 0) close(out);
    if (err >= 0) close(err);
    if (child.pid_ < 0) return fileError("cannot start, writing to", output, fault);
    setpgid(child.pid_, child.pid_);  // whichever of both comes first
    return child;
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept : pid_(std::exchange(other.pid_, -1)) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
    if (this == &other) return *this;
    stop();
    pid_ = std::exchange(other.pid_, -1);
    return *this;
}

ChildProcess::~ChildProcess() { stop(); }

std::optional<int> ChildProcess::poll() {
    int status = 0;
    if (pid_ <= 0 || waitpid(pid_, &status, WNOHANG) != pid_) return {};
    pid_ = -1;
    return exitCodeOf(status);
}

void ChildProcess::stop() {
    if (pid_ <= 0) return;
    kill(-pid_, SIGKILL);
    while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) continue;
    pid_ = -1;
}

}  // namespace sward
