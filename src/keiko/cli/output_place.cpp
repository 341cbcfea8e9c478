#include "keiko/cli/output_place.h"

#include "keiko/base/error.h"

#include <unistd.h>

namespace keiko::cli {
namespace fs = std::filesystem;
namespace {

void require_writable(const fs::path& folder, const fs::path& wanted) {
    std::error_code ignored;
    if (!fs::exists(folder, ignored))
        throw Error(wanted.string(), "", "there is no folder " + folder.string());
    if (!fs::is_directory(folder, ignored))
        throw Error(wanted.string(), "", folder.string() + " is a file, not a folder");
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        throw Error(wanted.string(), "", "no permission to write in " + folder.string());
}

} // namespace

void require_place_for_file(const fs::path& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        throw Error(path.string(), "", "is a directory, not a file");
    require_writable(path.has_parent_path() ? path.parent_path() : ".", path);
}

void require_place_for_folder(const fs::path& folder) {
    if (folder.empty()) throw Error("", "--output", "names no folder");
    fs::path there = folder;
    std::error_code ignored;
    while (!fs::exists(there, ignored)) {
        const fs::path above = there.parent_path();
        const bool higher = there.has_relative_path() && there != above && !above.empty();
        there = higher ? above : fs::path(".");
    }
    require_writable(there, folder);
}

} // namespace keiko::cli
