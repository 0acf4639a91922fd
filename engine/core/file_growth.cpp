#include "core/file_growth.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <limits>

#include "core/file.h"
#include "core/json.h"
#include "core/log.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

constexpr uint64_t kMaxSwitchBytes = 4096;

struct OpenFile {
    explicit OpenFile(const fs::path& file) : fd(::open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW)) {}
    ~OpenFile() {
        if (fd >= 0) ::close(fd);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    int fd;
};

// 0, or the errno of what failed.
int writeAt(int fd, std::string_view bytes, uint64_t at) {
    while (!bytes.empty()) {
        const ssize_t n = ::pwrite(fd, bytes.data(), std::min(bytes.size(), size_t(1) << 30), static_cast<off_t>(at));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return n < 0 ? errno : EIO;
        bytes.remove_prefix(static_cast<size_t>(n)), at += static_cast<uint64_t>(n);
    }
    return 0;
}

// A whole number from 0 to `most` called `key`; Unsound otherwise.
Result<uint64_t> wholeNumber(const Json& json, const char* key, double most, const fs::path& file) {
    const Json* j = json.isObject() ? json.find(key) : nullptr;
    if (!j || !j->isNumber() || !(j->number >= 0) || j->number > most || j->number != std::floor(j->number))
        return unsound(std::string("has no number called ") + key, "it is no file of an interrupted save; remove it")
            .at(file);
    return static_cast<uint64_t>(j->number);
}

}  // namespace

Status writeSwitch(const fs::path& to, const HeadSwitch& s) {
    Json json = Json::makeObject();
    json["at"] = Json(static_cast<double>(s.at));
    json["before"] = Json(static_cast<double>(s.before));
    json["after"] = Json(static_cast<double>(s.after));
    json["size"] = Json(static_cast<double>(s.size));
    return writeFileSynced(to, writeJson(json));
}

Result<HeadSwitch> readSwitch(const fs::path& from) {
    const Result<std::string> text = readFile(from, kMaxSwitchBytes);
    if (!text) return text.error();
    const Result<Json> json = parseJson(*text, from.string());
    if (!json) return json.error();
    constexpr double kMostAt = double(uint64_t(1) << 40), kMost = std::numeric_limits<uint32_t>::max();
    const auto at = wholeNumber(*json, "at", kMostAt, from), before = wholeNumber(*json, "before", kMost, from),
               after = wholeNumber(*json, "after", kMost, from), size = wholeNumber(*json, "size", kMostAt, from);
    for (const auto* number : {&at, &before, &after, &size})
        if (!*number) return number->error();
    return HeadSwitch{*at, static_cast<uint32_t>(*before), static_cast<uint32_t>(*after), *size};
}

Status switchHead(const fs::path& file, const HeadSwitch& s) {
    const OpenFile f(file);
    if (f.fd < 0) return fileError("cannot be written", file, errno);
    uint32_t now = 0;
    const ssize_t n = ::pread(f.fd, &now, sizeof now, static_cast<off_t>(s.at));
    struct stat info {};
    if (n < 0 || ::fstat(f.fd, &info) != 0) return fileError("cannot be read", file, errno);
    if (n == sizeof now && now == s.after) return {};
    if (n != sizeof now || now != s.before) {
        logWarning(file.string() + ": is another file than the one that a save added to, and stays as it is");
        return {};
    }
    if (static_cast<uint64_t>(info.st_size) < s.size)
        return failed("lacks what an interrupted save had added to it",
                      "take it from a copy, or remove the folder .sward-save to open the project as it was before")
            .at(file);
    int fault = writeAt(f.fd, {reinterpret_cast<const char*>(&s.after), sizeof s.after}, s.at);
    if (fault == 0 && ::fsync(f.fd) != 0) fault = errno;
    return fault == 0 ? Status() : fileError("cannot be written", file, fault);
}

bool mayGrow(const fs::path& file) {
    struct stat info {};
    return ::lstat(file.c_str(), &info) == 0 && S_ISREG(info.st_mode) && info.st_nlink == 1 &&
           ::access(file.c_str(), W_OK) == 0;
}

struct FileGrowth::State {
    explicit State(const fs::path& path) : file(path), open(path) {}
    fs::path file;
    OpenFile open;
    struct stat before {};
    uint64_t size = 0;
};

FileGrowth::FileGrowth() = default;
FileGrowth::FileGrowth(FileGrowth&&) noexcept = default;
FileGrowth& FileGrowth::operator=(FileGrowth&&) noexcept = default;
FileGrowth::~FileGrowth() = default;

Result<FileGrowth> FileGrowth::begin(const fs::path& file) {
    FileGrowth growth;
    growth.state_ = std::make_unique<State>(file);
    State& s = *growth.state_;
    if (s.open.fd < 0 || ::fstat(s.open.fd, &s.before) != 0) return fileError("cannot be written", file, errno);
    s.size = static_cast<uint64_t>(s.before.st_size);
    return growth;
}

uint64_t FileGrowth::size() const { return state_->size; }

Status FileGrowth::append(std::string_view bytes) {
    if (const int fault = writeAt(state_->open.fd, bytes, state_->size); fault != 0)
        return fileError("cannot be written", state_->file, fault);
    state_->size += bytes.size();
    return {};
}

Status FileGrowth::flush() const {
    return ::fsync(state_->open.fd) == 0 ? Status() : fileError("cannot be written", state_->file, errno);
}

void FileGrowth::undo() {
    const timespec times[] = {state_->before.st_atim, state_->before.st_mtim};
    if (::ftruncate(state_->open.fd, state_->before.st_size) == 0) ::futimens(state_->open.fd, times);
}

}  // namespace sward
