#pragma once

#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace keiko {

/// File descriptor that is closed at the end of its scope.
class Descriptor {
public:
    /// Takes over an open descriptor; a negative number is none.
    explicit Descriptor(int number = -1) : number_(number) {}
    /// Takes over the other's descriptor, which holds none afterwards.
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    /// Closes its own descriptor and takes over the other's; safe on itself.
    Descriptor& operator=(Descriptor&& other) noexcept {
        reset(std::exchange(other.number_, -1));
        return *this;
    }
    ~Descriptor() { close(); }

    /// The descriptor, for system calls; negative if there is none.
    int number() const { return number_; }
    /// True if it holds a descriptor.
    bool open() const { return number_ >= 0; }
    /// Closes the descriptor and takes over another.
    void reset(int number) { close(), number_ = number; }
    /// Closes the descriptor, if there is one. Errors of the system are not reported.
    void close() {
        if (open()) ::close(number_);
        number_ = -1;
    }

private:
    int number_;
};

/// Permissions of a file that anybody may read whom the umask lets.
constexpr mode_t public_file = 0666;
/// Permissions of a file of the user alone.
constexpr mode_t private_file = 0600;

/// Error of a system call that failed on `path`: "WHAT: " and the system's reason, from errno.
[[noreturn]] void throw_system_error(const std::filesystem::path& path, const std::string& what);

/// New, empty file, open for writing. Whatever has the name already, a link too, is an error: it is
/// neither followed nor written. `path` starts at the open directory `folder`; the umask is taken
/// off `mode`. Throws Error.
Descriptor create_file(const std::filesystem::path& path, mode_t mode = public_file,
                       int folder = AT_FDCWD);

/// Writes all bytes to an open file. `path` is for the error alone. Throws Error.
void write_all(const Descriptor& file, std::string_view bytes, const std::filesystem::path& path);

/// Name for a file or folder that is not finished: ".keiko-PID-RANDOM-HOST.tmp". Nobody can foresee
/// it.
std::string temporary_name();

/// True if the name is one of temporary_name() in a process of this machine that is gone. Other
/// machines may be writing to a folder that they share.
bool is_abandoned(const std::string& name);

/// New file beside the place that it is meant for; gone again unless it is put there. Its name
/// cannot be foreseen, and nothing that stands there is followed or written.
class TemporaryFile {
public:
    /// `target` starts at the open directory `folder`, which must outlive this; the umask is taken
    /// off `mode`. Throws Error naming `target`.
    explicit TemporaryFile(std::filesystem::path target, mode_t mode = public_file,
                           int folder = AT_FDCWD);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /// Appends bytes. Throws Error naming the target.
    void write(std::string_view bytes);
    /// Waits until the disk has all bytes, and takes no more. Throws Error naming the target.
    void finish();
    /// Renames the finished file to the target: a link there is replaced, never followed. Throws
    /// Error naming the target.
    void put_in_place();

private:
    std::filesystem::path target_, path_;
    int folder_;
    Descriptor file_;
};

} // namespace keiko
