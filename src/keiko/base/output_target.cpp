#include "keiko/base/output_target.h"

#include "keiko/base/error.h"
#include "keiko/base/new_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <string>

namespace keiko {
namespace fs = std::filesystem;
namespace {

/// True if somebody else may have put it there. The kernel's fs.protected_symlinks and
/// fs.protected_fifos have this rule for folders such as /tmp, but systems may switch it off and
/// reading a link goes past it.
bool may_be_planted(const fs::path& path) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
    struct stat entry {
    }, around{};
    if (lstat(path.c_str(), &entry) != 0 || stat(folder.c_str(), &around) != 0) return false;
    const bool shared = (around.st_mode & S_IWOTH) != 0;
    return shared && entry.st_uid != geteuid() && entry.st_uid != around.st_uid;
}

void refuse_planted(const fs::path& path, const std::string& what) {
    if (may_be_planted(path))
        throw Error(path.string(), "",
                    "is a " + what + " of another user in a folder where everybody may write");
}

/// A name that no file can have must be refused before other outputs are put in place.
void refuse_long_name(const fs::path& path) {
    struct stat entry {};
    if (lstat(path.c_str(), &entry) != 0 && errno == ENAMETOOLONG)
        throw_system_error(path, "cannot write");
}

} // namespace

fs::path behind_links(const fs::path& path) {
    refuse_long_name(path);
    constexpr int most_links = 40; // as many as the kernel follows
    fs::path behind = path;
    std::error_code ignored; // whatever is wrong with the file shows when it is written
    for (int links = 0; fs::is_symlink(behind, ignored); ++links) {
        if (links == most_links) throw Error(path.string(), "", "is a link that leads nowhere");
        refuse_planted(behind, "link");
        behind = behind.parent_path() / fs::read_symlink(behind, ignored);
    }
    return behind;
}

bool is_stream(const fs::path& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

OutputTarget output_target(const fs::path& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status)) throw Error(path.string(), "", "is a directory, not a file");
    if (fs::is_block_file(status)) throw Error(path.string(), "", "is a block device, not a file");
    if (fs::is_socket(status)) throw Error(path.string(), "", "is a socket, not a file");
    fs::path file = behind_links(path);
    if (!is_stream(path)) return {std::move(file)};
    refuse_planted(file, "pipe");
    return {path, true};
}

namespace {

/// "a/b/" has an empty name at its end.
fs::path without_slash_at_end(const fs::path& path) {
    return path.has_filename() ? path : path.parent_path();
}

/// The target of a link, also of one to a file that does not exist; any other path as it is.
fs::path link_target(const fs::path& path) {
    constexpr int most_links = 40; // as the kernel follows
    std::error_code code;
    fs::path target = path;
    for (int i = 0; i < most_links && fs::is_symlink(target, code); ++i) {
        const fs::path next = fs::read_symlink(target, code);
        if (code) break;
        target = target.parent_path() / next;
    }
    return target;
}

} // namespace

fs::path real_path(const fs::path& path) {
    std::error_code code;
    const fs::path whole = fs::absolute(link_target(path), code);
    const fs::path real = fs::weakly_canonical(whole, code);
    return without_slash_at_end(code ? whole.lexically_normal() : real);
}

bool lies_within(const fs::path& path, const fs::path& folder) {
    const fs::path inner = real_path(path), outer = real_path(folder);
    const auto [in, out] = std::mismatch(inner.begin(), inner.end(), outer.begin(), outer.end());
    return out == outer.end();
}

} // namespace keiko
