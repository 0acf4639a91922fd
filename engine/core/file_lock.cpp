#include "core/file_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <utility>

#include "core/file.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

constexpr uint64_t kMaxNote = 512;

LockTry tryDescriptor(int fd, LockKind kind) {
    int done = 0;
    do done = ::flock(fd, (kind == LockKind::Shared ? LOCK_SH : LOCK_EX) | LOCK_NB);
    while (done != 0 && errno == EINTR);
    if (done == 0) return LockTry::Taken;
    return errno == EWOULDBLOCK ? LockTry::Busy : LockTry::Absent;
}

std::string holderText(long pid, const std::string& host) {
    if (pid <= 0) return "another program";
    return fmt::format("process {}{}{}", pid, host.empty() ? "" : " on ", host);
}

// A note that cannot be written names nobody; the lock is no worse for it.
void noteHolder(int fd) {
    const std::string note = fmt::format("{} {}\n", getpid(), hostName());
    if (::ftruncate(fd, 0) == 0 && ::pwrite(fd, note.data(), note.size(), 0) != static_cast<ssize_t>(note.size()))
        static_cast<void>(::ftruncate(fd, 0));
}

// The file may have been removed, and made anew, between the opening and the locking: such a lock locks nothing.
bool isStillNamed(int fd, const fs::path& file) {
    struct stat open {
    }, named{};
    return ::fstat(fd, &open) == 0 && ::stat(file.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
           open.st_ino == named.st_ino;
}

// Lines such as "1: FLOCK  ADVISORY  WRITE 1234 08:01:5678 0 EOF": the process, and device and number of the file.
long systemHolder(const fs::path& locked) {
    struct stat info {};
    if (::stat(locked.c_str(), &info) != 0) return 0;
    const std::string wanted =
        fmt::format("{:02x}:{:02x}:{}", major(info.st_dev), minor(info.st_dev), static_cast<uint64_t>(info.st_ino));
    std::ifstream locks("/proc/locks");
    for (std::string line; std::getline(locks, line);) {
        std::istringstream words(line);
        std::string number, form, manner, access, file;
        long pid = 0;
        words >> number >> form >> manner >> access >> pid >> file;
        if (form == "FLOCK" && file == wanted) return pid;
    }
    return 0;
}

}  // namespace

std::string hostName() {
    char name[256] = {};
    return ::gethostname(name, sizeof name - 1) == 0 ? name : "";
}

FileLock::FileLock(FileLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
FileLock& FileLock::operator=(FileLock&& other) noexcept {
    if (this == &other) return *this;
    release();
    fd_ = std::exchange(other.fd_, -1);
    return *this;
}

void FileLock::release() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
}

LockTry FileLock::tryFolder(const fs::path& folder, LockKind kind) {
    release();
    fd_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd_ < 0) return LockTry::Absent;
    const LockTry done = tryDescriptor(fd_, kind);
    if (done != LockTry::Taken) release();
    return done;
}

LockTry FileLock::tryFile(const fs::path& file) {
    for (;;) {
        release();
        fd_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
        if (fd_ < 0) return LockTry::Absent;
        const LockTry done = tryDescriptor(fd_, LockKind::Exclusive);
        if (done != LockTry::Taken) {
            release();
            return done;
        }
        if (!isStillNamed(fd_, file)) continue;
        noteHolder(fd_);
        return done;
    }
}

std::string lockHolder(const fs::path& locked) {
    std::error_code ignored;
    if (fs::is_regular_file(locked, ignored))
        if (const Result<std::string> note = readFile(locked, kMaxNote)) {
            std::istringstream words(*note);
            long pid = 0;
            std::string host;
            if (words >> pid) {
                words >> host;
                return holderText(pid, host);
            }
        }
    return holderText(systemHolder(locked), hostName());
}

}  // namespace sward
