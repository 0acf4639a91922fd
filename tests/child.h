// Work that needs a process of its own: to be killed, to lose privileges, to hit limits. A process with threads must
// not go on after a fork, so the executable is started anew with `--child NAME ARGS...`; its main calls childMain
// first.
#pragma once
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sward::test {

// What a child does; what it returns is written to its standard output.
using ChildFunction = std::function<std::string(const std::vector<std::string>& args)>;

inline std::map<std::string, ChildFunction>& childFunctions() {
    static std::map<std::string, ChildFunction> functions;
    return functions;
}
// At namespace scope: `const ChildFunctionRow row("name", [](const auto& args) { ... });`
struct ChildFunctionRow {
    ChildFunctionRow(const std::string& name, ChildFunction f) { childFunctions()[name] = std::move(f); }
};

// The exit code, if this process was started to be a child.
inline std::optional<int> childMain(int argc, char** argv) {
    if (argc < 3 || std::string(argv[1]) != "--child") return {};
    const auto it = childFunctions().find(argv[2]);
    if (it == childFunctions().end()) return 2;
    const std::string said = it->second({argv + 3, argv + argc});
    return write(STDOUT_FILENO, said.data(), said.size()) == static_cast<ssize_t>(said.size()) ? 0 : 1;
}

struct Child {
    pid_t pid = -1;
    int output = -1;  // what it writes to standard output
};
inline Child startChild(const std::string& name, const std::vector<std::string>& args) {
    int ends[2];
    if (pipe(ends) != 0) return {};
    std::vector<std::string> own{"/proc/self/exe", "--child", name};  // execv wants texts that it could write to
    own.insert(own.end(), args.begin(), args.end());
    std::vector<char*> argv;
    for (std::string& a : own) argv.push_back(a.data());
    argv.push_back(nullptr);
    const pid_t pid = fork();
    if (pid == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);  // no child outlives a test that was interrupted
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        close(ends[1]);
        execv(argv[0], argv.data());
        _exit(127);
    }
    close(ends[1]);
    return {pid, ends[0]};
}
// Waits for the child; what it wrote, or "the child crashed".
inline std::string finishChild(const Child& child) {
    std::string said;
    char buffer[4096];
    for (ssize_t n; (n = read(child.output, buffer, sizeof buffer)) > 0;) said.append(buffer, static_cast<size_t>(n));
    close(child.output);
    int status = 0;
    waitpid(child.pid, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? said : "the child crashed";
}
inline std::string runChild(const std::string& name, const std::vector<std::string>& args) {
    return finishChild(startChild(name, args));
}

}  // namespace sward::test
