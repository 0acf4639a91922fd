#include "core/file.h"

#include <fcntl.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace fs = std::filesystem;

namespace sward {
namespace {

// A file descriptor that closes itself.
struct Descriptor {
    int fd;
    explicit Descriptor(int f) : fd(f) {}
    ~Descriptor() {
        if (fd >= 0) ::close(fd);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
};

// 0, or the errno of what failed.
int writeAll(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(fd, bytes.data(), std::min(bytes.size(), size_t(1) << 30));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return n < 0 ? errno : EIO;
        bytes.remove_prefix(static_cast<size_t>(n));
    }
    return 0;
}

Error unreadable(const fs::path& file, int errorNumber) {
    Error e = fileError("cannot be read", file, errorNumber);
    e.code = ExitCode::Unsound;
    return e;
}

const char* kindOf(mode_t mode) {
    if (S_ISDIR(mode)) return "a folder";
    if (S_ISFIFO(mode)) return "a FIFO (a named pipe)";
    if (S_ISSOCK(mode)) return "a socket";
    return "a device";
}

fs::path homeDir() {
    if (const char* home = std::getenv("HOME"); home && home[0] == '/') return home;
    const passwd* user = getpwuid(getuid());
    return user && user->pw_dir && user->pw_dir[0] == '/' && ::access(user->pw_dir, W_OK) == 0 ? user->pw_dir : "";
}

fs::path userDir(const char* variable, const char* underHome, const char* kind) {
    if (const char* xdg = std::getenv(variable); xdg && xdg[0] == '/') return fs::path(xdg) / "sward";
    if (const fs::path home = homeDir(); !home.empty()) return home / underHome / "sward";
    std::error_code ignored;
    fs::path temp = fs::temp_directory_path(ignored);
    if (temp.empty()) temp = "/tmp";
    return temp / fmt::format("sward-{}-{}", kind, getuid());
}

}  // namespace

Error fileError(const std::string& verb, const fs::path& file, int errorNumber) {
    std::string remedy;
    if (errorNumber == ENOSPC || errorNumber == EDQUOT) remedy = "free some space and try again";
    if (errorNumber == EFBIG) remedy = "the system's limit on file sizes is too small";
    if (errorNumber == EACCES || errorNumber == EPERM) remedy = "check who may read and write it";
    if (errorNumber == EROFS) remedy = "the file system is read-only; save somewhere else";
    if (errorNumber == ENOENT) remedy = "check the path";
    return failed(fmt::format("{}: {}", verb, std::generic_category().message(errorNumber)), remedy).at(file);
}

Status checkRegular(const fs::path& file) {
    struct stat info {};
    if (::stat(file.c_str(), &info) != 0) return unreadable(file, errno);
    if (S_ISREG(info.st_mode)) return {};
    return unsound(fmt::format("is {}, not a file", kindOf(info.st_mode)), "name a file").at(file);
}

Status checkLength(uint64_t bytes, uint64_t limit) {
    if (bytes <= limit) return {};
    return unsound(fmt::format("has {} bytes; the limit is {}", bytes, limit), "make it smaller");
}

Result<std::string> readFile(const fs::path& file, uint64_t limit) {
    const auto refuse = [&](int number) { return unreadable(file, number); };
    if (Status s = checkRegular(file); !s) return s.error();                       // opening a device may do something
    const Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));  // a FIFO must not hang the program
    if (in.fd < 0) return refuse(errno);
    struct stat info {};
    if (::fstat(in.fd, &info) != 0) return refuse(errno);
    if (!S_ISREG(info.st_mode)) return unsound(fmt::format("is {}, not a file", kindOf(info.st_mode))).at(file);
    const auto size = static_cast<uint64_t>(info.st_size);
    if (Status s = checkLength(size, limit); !s) return s.error().at(file);
    std::string bytes(size, '\0');
    size_t have = 0;
    while (have < bytes.size()) {
        const ssize_t n = ::read(in.fd, bytes.data() + have, bytes.size() - have);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return refuse(errno);
        if (n == 0) break;  // it shrank meanwhile
        have += static_cast<size_t>(n);
    }
    bytes.resize(have);
    return bytes;
}

FileStamp stampOf(const fs::path& file) {
    struct stat info {};
    if (::stat(file.c_str(), &info) != 0) return {};
    return {static_cast<uint64_t>(info.st_ino), static_cast<uint64_t>(info.st_size),
            static_cast<int64_t>(info.st_mtim.tv_sec) * 1'000'000'000 + info.st_mtim.tv_nsec};
}

Status writeFileSynced(const fs::path& file, std::string_view bytes) {
    int fault = 0;
    {
        const Descriptor out(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
        if (out.fd < 0) return fileError("cannot be written", file, errno);
        fault = writeAll(out.fd, bytes);
        if (fault == 0 && ::fsync(out.fd) != 0) fault = errno;
    }
    if (fault == 0) return {};
    struct stat info {};
    if (::lstat(file.c_str(), &info) == 0 && S_ISREG(info.st_mode)) ::unlink(file.c_str());  // never a device
    return fileError("cannot be written", file, fault);
}

Status makeFolderOf(const fs::path& file) {
    if (!file.has_parent_path()) return {};
    std::error_code fault;
    fs::create_directories(file.parent_path(), fault);
    if (fault) return fileError("cannot be made", file.parent_path(), fault.value());
    return {};
}

Status writeFileAtomic(const fs::path& file, std::string_view bytes) {
    const fs::path part = partPath(file);
    if (Status s = writeFileSynced(part, bytes); !s) {
        Error e = s.error();
        e.file = file.string();
        return e;
    }
    if (::rename(part.c_str(), file.c_str()) != 0) {
        const int fault = errno;
        ::unlink(part.c_str());
        return fileError("cannot be written", file, fault);
    }
    return syncPath(file.has_parent_path() ? file.parent_path() : fs::path("."));
}

Status syncPath(const fs::path& path) {
    const Descriptor fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (fd.fd < 0) return fileError("cannot be flushed to the disk", path, errno);
    if (::fsync(fd.fd) != 0 && errno != EINVAL && errno != EROFS)  // some file systems cannot flush folders
        return fileError("cannot be flushed to the disk", path, errno);
    return {};
}

fs::path partPath(const fs::path& file) {
    static std::atomic<unsigned> next{0};
    return file.parent_path() / fmt::format(".{}.{}-{}.part", file.filename().string(), getpid(), next++);
}

fs::path cacheDir() { return userDir("XDG_CACHE_HOME", ".cache", "cache"); }
fs::path stateDir() { return userDir("XDG_STATE_HOME", ".local/state", "state"); }

namespace {
constexpr const char* kStayInside = "name a file inside the project's folder";
}  // namespace

Status checkInside(const std::string& relative) {
    const fs::path given(relative);
    if (relative.empty() || relative.find('\0') != std::string::npos)
        return unsound("the path of a file is empty or not a path", kStayInside);
    if (given.is_absolute()) return unsound(fmt::format("\"{}\" is an absolute path", relative), kStayInside);
    for (const fs::path& part : given)
        if (part == "..") return unsound(fmt::format("\"{}\" leaves the project", relative), kStayInside);
    return {};
}

Result<fs::path> resolveInside(const fs::path& root, const std::string& relative) {
    if (Status s = checkInside(relative); !s) return s.error().at(root);
    const fs::path given(relative);
    std::error_code fault;
    fs::path base = fs::weakly_canonical(root.empty() ? fs::path(".") : root, fault);
    if (!base.has_filename()) base = base.parent_path();  // "folder/": its empty last part would match nothing
    if (fault) return unsound(fmt::format("cannot be resolved: {}", fault.message())).at(root);
    const fs::path full = fs::weakly_canonical(base / given, fault);
    if (fault) return unsound(fmt::format("\"{}\" cannot be resolved: {}", relative, fault.message())).at(root);
    const auto [end, ignored] = std::mismatch(base.begin(), base.end(), full.begin(), full.end());
    if (end != base.end())
        return unsound(fmt::format("\"{}\" leaves the project over a symbolic link", relative), kStayInside).at(root);
    return root / given;
}

}  // namespace sward
