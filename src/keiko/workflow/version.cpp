#include "keiko/workflow/version.h"

#include "keiko/base/build_id.h"
#include "keiko/base/input_file.h"
#include "keiko/base/sha256.h"
#include "keiko/files/toml/toml_document.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/intersect/kernels/sub_patch_kernels.h"

#include <array>
#include <cstdint>
#include <ctime>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

namespace keiko {
namespace fs = std::filesystem;
namespace {

std::string file_hash(const fs::path& file) {
    return sha256_hex(read_file(file));
}

/// Hash of the program that imports models: read once, for it is large and the same for all parts
/// of a run, and again where it was replaced.
std::string worker_hash(const fs::path& worker) {
    struct Known {
        fs::path path;
        fs::file_time_type time;
        std::uintmax_t size = 0;
        std::string hash;
    };
    static std::mutex mutex;
    static Known known;
    std::error_code code; // of a worker that cannot be read, which file_hash reports
    const fs::file_time_type time = fs::last_write_time(worker, code);
    const std::uintmax_t size = code ? 0 : fs::file_size(worker, code);
    const std::scoped_lock lock(mutex);
    if (code || known.path != worker || known.time != time || known.size != size)
        known = {worker, time, size, file_hash(worker)};
    return known.hash;
}

std::vector<fs::path> files_of(const fs::path& input) {
    return input.extension() == ".toml" ? files_named_by(input) : std::vector<fs::path>{input};
}

} // namespace

std::string version() {
    return KEIKO_VERSION;
}

std::string program() {
    return build_id() + " " + sub_patch_kernels().name;
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
    std::string text = program() + "\n" + worker_hash(worker_path(load)) + "\n" + load.unit + "\n" +
                       load.axes + "\n" + settings;
    for (const fs::path& input : inputs)
        for (const fs::path& file : files_of(input))
            text += file.lexically_relative(folder).string() + " " + file_hash(file) + "\n";
    return sha256_hex(text);
}

} // namespace keiko
