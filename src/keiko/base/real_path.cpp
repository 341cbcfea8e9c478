#include "keiko/base/real_path.h"

#include <algorithm>

namespace keiko {
namespace fs = std::filesystem;
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
