// Locks on files and folders that the operating system holds (flock): one lasts until it is released or its process
// ends, however it ends, and holds between processes, between threads, and between two locks of one thread alike.
// Does not: keep out who does not ask for the lock; wait.
#pragma once
#include <filesystem>
#include <string>

namespace sward {

enum class LockKind { Shared, Exclusive };
// Taken: it is held. Busy: another holds one that excludes it. Absent: it cannot be opened, or its file system has no
// locks.
enum class LockTry { Taken, Busy, Absent };

class FileLock {
  public:
    FileLock() = default;
    ~FileLock() { release(); }
    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;

    // Locks a folder, which need not be writable. What this held before is released.
    LockTry tryFolder(const std::filesystem::path& folder, LockKind kind);
    // Makes the file if need be, locks it exclusively, and notes in it who holds it, for lockHolder. What this held
    // before is released. The file stays when the lock goes; who holds the lock may remove it.
    LockTry tryFile(const std::filesystem::path& file);
    // Whether a lock is held.
    bool held() const { return fd_ >= 0; }
    // Gives the lock up; nothing to do if none is held.
    void release();

  private:
    int fd_ = -1;
};

// This machine's name in its network, by which notes of locks and tables of times know it; "" if it has none.
std::string hostName();

// Who holds a lock on a file or folder: "process 1234 on meadow", as the holder noted it in the file or else as the
// system knows it; "another program" where neither does. To be asked while the lock is Busy: a note outlasts its
// writer.
std::string lockHolder(const std::filesystem::path& locked);

}  // namespace sward
