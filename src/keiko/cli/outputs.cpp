#include "keiko/cli/outputs.h"

#include "keiko/base/error.h"
#include "keiko/base/output_target.h"
#include "keiko/base/text.h"

#include <unistd.h>

#include <iostream>
#include <map>

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
    if (output_target(path).stream) return;
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

void require_distinct(std::span<const fs::path> outputs, std::span<const fs::path> inputs) {
    std::map<fs::path, const char*> known;
    for (const fs::path& input : inputs) known.emplace(real_path(input), "is an input as well");
    for (const fs::path& output : outputs) {
        if (output.empty() || is_stream(output)) continue;
        const auto [found, is_new] = known.emplace(real_path(output), "is named for two outputs");
        if (!is_new) throw Error(output.string(), "", found->second);
    }
}

void print(std::string_view lines) {
    std::cout << terminal_text(lines);
}

} // namespace keiko::cli
