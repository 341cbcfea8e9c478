#include "keiko/workflow/version.h"

#include "keiko/base/build_id.h"
#include "keiko/base/input_file.h"
#include "keiko/base/sha256.h"
#include "keiko/files/toml/toml_document.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/intersect/kernels/sub_patch_kernels.h"

#include <array>
#include <ctime>
#include <set>
#include <utility>

namespace keiko {
namespace fs = std::filesystem;
namespace {

std::string file_hash(const fs::path& file) {
    return sha256_hex(read_file(file));
}

/// Build of Keiko, and the detected instruction set.
std::string program() {
    return build_id() + " " + sub_patch_kernels().name;
}

std::vector<fs::path> files_of(const fs::path& input) {
    return input.extension() == ".toml" ? files_named_by(input) : std::vector<fs::path>{input};
}

} // namespace

std::string version() {
    return KEIKO_VERSION;
}

std::string utc_now(const char* format) {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), format, &utc);
    return text.data();
}

std::vector<InputFile> input_files(std::span<const fs::path> inputs) {
    std::set<fs::path> all;
    for (const fs::path& input : inputs)
        for (fs::path& file : files_of(input)) all.insert(std::move(file));
    std::vector<InputFile> files;
    for (const fs::path& file : all) files.push_back({file.string(), file_hash(file)});
    return files;
}

std::string input_key(std::span<const fs::path> inputs, const fs::path& folder,
                      const LoadOptions& load, const std::string& settings) {
    std::string text = program() + "\n" + file_hash(worker_path(load)) + "\n" + load.unit + "\n" +
                       load.axes + "\n" + settings;
    for (const fs::path& input : inputs)
        for (const fs::path& file : files_of(input))
            text += file.lexically_relative(folder).string() + " " + file_hash(file) + "\n";
    return sha256_hex(text);
}

} // namespace keiko
