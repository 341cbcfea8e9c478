#include "keiko/base/new_file.h"

#include "keiko/base/error.h"

#include <sys/random.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <climits>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <utility>

namespace keiko {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view prefix = ".keiko-";

std::uint64_t random_number() {
    std::uint64_t number = 0;
    while (getrandom(&number, sizeof number, 0) != sizeof number)
        if (errno != EINTR) throw_system_error("", "no random numbers");
    return number;
}

std::string hexadecimal(std::uint64_t number) {
    std::array<char, 16> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, 16).ptr;
    return {digits.data(), end};
}

bool is_running(pid_t pid) {
    return kill(pid, 0) == 0 || errno == EPERM;
}

/// "-HOST.tmp", at the end of the names of this machine: numbers of processes are its own.
std::string ending() {
    std::array<char, HOST_NAME_MAX + 1> host{};
    if (gethostname(host.data(), host.size() - 1) != 0) host.front() = '\0';
    return "-" + std::string(host.data()) + ".tmp";
}

} // namespace

void throw_system_error(const fs::path& path, const std::string& what) {
    throw Error(path.string(), "", what + ": " + std::strerror(errno));
}

Descriptor create_file(const fs::path& path, mode_t mode, int folder) {
    constexpr int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    Descriptor file(openat(folder, path.c_str(), flags, mode));
    if (!file.open()) throw_system_error(path, "cannot write");
    return file;
}

void write_all(const Descriptor& file, std::string_view bytes, const fs::path& path) {
    while (!bytes.empty()) {
        const ssize_t written = write(file.number(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw_system_error(path, "cannot write");
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

std::string temporary_name() {
    return std::string(prefix) + std::to_string(getpid()) + "-" + hexadecimal(random_number()) +
           ending();
}

bool is_abandoned(const std::string& name) {
    if (!name.starts_with(prefix)) return false;
    pid_t pid = 0;
    const char* const end = name.data() + name.size();
    const auto [rest, code] = std::from_chars(name.data() + prefix.size(), end, pid);
    if (code != std::errc() || *rest != '-') return false;
    const std::string_view random_and_host(rest + 1, end);
    const std::size_t host = random_and_host.find('-');
    return host != random_and_host.npos && random_and_host.substr(host) == ending() && pid > 0 &&
           !is_running(pid);
}

namespace {

/// New file at `path`; errors name the target, which the user knows.
Descriptor create_for(const fs::path& target, const fs::path& path, mode_t mode, int folder) {
    try {
        return create_file(path, mode, folder);
    } catch (const Error& error) {
        throw Error(target.string(), error.where(), error.reason());
    }
}

} // namespace

TemporaryFile::TemporaryFile(fs::path target, mode_t mode, int folder)
    : target_(std::move(target)),
      path_(target_.parent_path() / temporary_name()),
      folder_(folder),
      file_(create_for(target_, path_, mode, folder)) {}

TemporaryFile::~TemporaryFile() {
    if (!path_.empty()) unlinkat(folder_, path_.c_str(), 0);
}

void TemporaryFile::write(std::string_view bytes) {
    write_all(file_, bytes, target_);
}

void TemporaryFile::finish() {
    // Some file systems have nothing to wait for.
    const bool kept = fsync(file_.number()) == 0 || errno == EINVAL || errno == ENOTSUP;
    if (!kept) throw_system_error(target_, "cannot write");
    file_.close();
}

void TemporaryFile::put_in_place() {
    if (renameat(folder_, path_.c_str(), folder_, target_.c_str()) != 0)
        throw_system_error(target_, "cannot write");
    path_.clear();
}

} // namespace keiko
