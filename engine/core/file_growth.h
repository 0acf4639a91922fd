// A large file that comes to its next version by growing: what is new is added at its end and flushed, where nothing
// refers to it yet; then one number near its beginning is changed, which refers to all that counts. At any instant the
// file is as before or as after, and who has it open goes on to read what was before.
// Does not: know what is in a file.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include "core/error.h"

namespace sward {

// The number of four bytes, in this machine's order, that makes a file's new end count.
struct HeadSwitch {
    uint64_t at = 0;  // in the file
    uint32_t before = 0, after = 0;
    uint64_t size = 0;  // bytes that the file has with its new end
    bool operator==(const HeadSwitch&) const = default;
};
// To and from a small file. Writing flushes it; reading refuses what is none (Unsound).
Status writeSwitch(const std::filesystem::path& to, const HeadSwitch& s);
Result<HeadSwitch> readSwitch(const std::filesystem::path& from);
// Changes the file, and flushes it; nothing to do if that is done. Nothing is done either, but told, if the file is
// another one by now; Failed error if it cannot be written, or is one that lacks the new end.
Status switchHead(const std::filesystem::path& file, const HeadSwitch& s);

// Whether a file can grow in its place: one that may be written, under one name only (what a link beside it leads to
// would change as well).
bool mayGrow(const std::filesystem::path& file);

class FileGrowth {
  public:
    // Failed error if it cannot be written to.
    static Result<FileGrowth> begin(const std::filesystem::path& file);
    FileGrowth(FileGrowth&&) noexcept;
    FileGrowth& operator=(FileGrowth&&) noexcept;
    ~FileGrowth();

    // Bytes of the file with what was added: where the next come to lie.
    uint64_t size() const;
    Status append(std::string_view bytes);
    Status flush() const;
    // The file is as it was, its time included.
    void undo();

  private:
    FileGrowth();
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace sward
