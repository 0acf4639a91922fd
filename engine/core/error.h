// What a function returns when the user's input or machine is at fault, and what stops a programmer's mistake.
// Does not: log. Whoever shows the error to the user does that once.
#pragma once
#include <fmt/format.h>

#include <string>
#include <utility>
#include <variant>

namespace sward {

// Process exit codes; they hold from the first release (README, "Exit codes").
enum class ExitCode { Done = 0, Failed = 1, Usage = 2, Unsound = 3, NoContext = 4, Interrupted = 130 };

// A user's error: what is wrong, where, and what to do about it.
struct Error {
    ExitCode code = ExitCode::Failed;
    std::string message;  // what is wrong
    std::string file;     // the file at fault, or empty
    int line = 0;         // 1-based; 0: none
    int column = 0;       // 1-based; 0: none
    std::string remedy;   // what to do; may be empty

    // "file:line:column: message (remedy)", leaving out what is not known.
    std::string text() const;
    // This error at another place: the file at fault, and its 1-based line and column where they are known.
    Error at(std::string where, int atLine = 0, int atColumn = 0) const;
};

// Makers of errors, one an exit code: what is wrong, and what to do about it. `unsound("is no map", "export it
// again").at(file, 3)` names the place too.
Error failed(std::string message, std::string remedy = {});        // ExitCode::Failed: the machine did not do it
Error usage(std::string message, std::string remedy = {});         // ExitCode::Usage: what was asked for cannot be
Error unsound(std::string message, std::string remedy = {});       // ExitCode::Unsound: a file holds what it must not
Error noContext(std::string message, std::string remedy = {});     // ExitCode::NoContext: there is no OpenGL 4.5
Error interruption(std::string message, std::string remedy = {});  // ExitCode::Interrupted: the user stopped it

// A value, or the error that kept it from being made.
template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : data_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : data_(std::in_place_index<1>, std::move(error)) {}
    // True if it holds the value; *, -> and error() may then be asked only of what is there (else
    // std::bad_variant_access).
    explicit operator bool() const { return data_.index() == 0; }
    T& operator*() { return std::get<0>(data_); }
    const T& operator*() const { return std::get<0>(data_); }
    T* operator->() { return &std::get<0>(data_); }
    const T* operator->() const { return &std::get<0>(data_); }
    // The error; only of a result that is false.
    const Error& error() const { return std::get<1>(data_); }

  private:
    std::variant<T, Error> data_;
};

template <>
class [[nodiscard]] Result<void> {
  public:
    Result() = default;
    Result(Error error) : error_(std::move(error)), ok_(false) {}
    // True if nothing went wrong; error() is empty then.
    explicit operator bool() const { return ok_; }
    // The error; an empty one if nothing went wrong.
    const Error& error() const { return error_; }

  private:
    Error error_;
    bool ok_ = true;
};
using Status = Result<void>;

// Prints and aborts; for programmer's errors only.
[[noreturn]] void checkFailed(const char* file, int line, const std::string& what);

}  // namespace sward

#define CHECK(condition)                                                        \
    do {                                                                        \
        if (!(condition)) ::sward::checkFailed(__FILE__, __LINE__, #condition); \
    } while (0)
#define CHECK_EQ(a, b)                                                                                             \
    do {                                                                                                           \
        const auto& checkA_ = (a);                                                                                 \
        const auto& checkB_ = (b);                                                                                 \
        if (!(checkA_ == checkB_))                                                                                 \
            ::sward::checkFailed(__FILE__, __LINE__, fmt::format("{} == {}: {} != {}", #a, #b, checkA_, checkB_)); \
    } while (0)
