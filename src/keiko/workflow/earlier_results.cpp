#include "keiko/workflow/earlier_results.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/output_target.h"
#include "keiko/base/sha256.h"
#include "keiko/files/toml/toml_document.h"

#include <set>
#include <sstream>

namespace keiko {
namespace fs = std::filesystem;
namespace {

constexpr const char* manifest_name = ".keiko-results";
constexpr const char* manifest_format = "keiko-results/1";

bool is_file(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

/// The files that a run reads, without links.
std::set<fs::path> files_read(std::span<const fs::path> inputs) {
    std::set<fs::path> read;
    for (const fs::path& input : inputs) {
        if (!is_file(input)) continue;
        read.insert(real_path(input));
        if (input.extension() != ".toml") continue;
        try {
            for (const fs::path& file : files_named_by(input)) read.insert(real_path(file));
        } catch (const Error&) { // in the input, which the run will report
        }
    }
    return read;
}

void remove_result(const fs::path& path) {
    std::error_code code;
    fs::remove(path, code);
    if (code) throw Error(path.string(), "", "cannot remove the earlier result: " + code.message());
}

std::string hash_of(const fs::path& path) {
    try {
        return sha256_hex(read_file(path));
    } catch (const Error&) { // an unreadable file differs from the written one
        return "";
    }
}

/// True if a name in a manifest lies in its folder.
bool is_plain_name(const fs::path& name) {
    return name == name.filename() && name != "." && name != "..";
}

void withdraw_folder(const fs::path& folder, const std::set<fs::path>& kept) {
    const fs::path manifest = folder / manifest_name;
    if (!is_file(manifest)) return;
    std::istringstream lines(read_file(manifest));
    std::string line;
    if (!std::getline(lines, line) || line != manifest_format) return;
    while (std::getline(lines, line)) {
        const std::size_t blank = line.find(' ');
        if (blank == std::string::npos) continue;
        const std::string name = line.substr(blank + 1);
        const fs::path path = folder / name;
        if (is_plain_name(name) && !fs::is_symlink(path) && !kept.contains(real_path(path)) &&
            hash_of(path) == line.substr(0, blank))
            remove_result(path);
    }
    remove_result(manifest);
}

} // namespace

FolderContent with_manifest(FolderContent content) {
    std::string text = std::string(manifest_format) + "\n";
    for (const auto& [name, bytes] : content) text += sha256_hex(bytes) + " " + name + "\n";
    content[manifest_name] = std::move(text);
    return content;
}

void withdraw_results(const ResultPlaces& places, std::span<const fs::path> inputs) {
    const std::set<fs::path> read = files_read(inputs);
    const auto is_there = [](const fs::path& file) { return !file.empty() && is_file(file); };
    for (const fs::path& file : places.files)
        if (is_there(file) && read.contains(real_path(file)))
            throw Error(file.string(), "", "is an input as well");
    for (const fs::path& file : places.files)
        if (is_there(file)) remove_result(real_path(file));
    for (const fs::path& folder : places.folders)
        if (!folder.empty()) withdraw_folder(folder, read);
}

} // namespace keiko
