#include "keiko/import/worker/model_cache.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/new_file.h"
#include "keiko/base/sha256.h"
#include "keiko/files/model/model_serialization.h"

#include <sys/stat.h>

namespace keiko {

namespace fs = std::filesystem;
namespace {

/// Stamp of the file that a path leads to. Throws Error.
FileStamp file_stamp(const std::filesystem::path& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0) throw_system_error(file, "cannot read");
    return {status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size),
            status.st_ctim.tv_sec * 1'000'000'000 + status.st_ctim.tv_nsec};
}

constexpr const char* ending = ".keiko-model";

/// Tells one build of the reader from another.
std::string stamp(const fs::path& worker) {
    std::error_code code;
    const auto size = fs::file_size(worker, code);
    const auto time = fs::last_write_time(worker, code).time_since_epoch().count();
    return std::to_string(size) + " " + std::to_string(time);
}

/// First line of an entry, which binds it to its key.
std::string header(const ModelKey& key) {
    return "KEIKO-MC 1 " + key.text + "\n";
}

} // namespace

FileState file_state(const std::filesystem::path& file) {
    const FileStamp stamp = file_stamp(file);
    return {stamp, sha256_hex(read_file(file))};
}

ModelCache::ModelCache(fs::path folder, std::uint64_t limit)
    : folder_(std::move(folder), ending, limit) {}

std::optional<ModelKey> ModelCache::key(const fs::path& file, ModelFormat format,
                                        const fs::path& worker) {
    ModelKey key{"", {file_stamp(file), ""}};
    const std::string bytes = read_file(file);
    if (format == ModelFormat::step && bytes.find("DOCUMENT_FILE") != std::string::npos)
        return std::nullopt;
    key.file.sha256 = sha256_hex(bytes);
    std::string text;
    // The name of the file becomes that of a part without a name of its own.
    for (const std::string& part :
         {key.file.sha256, std::string(name_of(format)), file.stem().string(),
          std::string(KEIKO_READERS), std::to_string(model_serialization_version), stamp(worker)})
        text += part + "\n";
    key.text = sha256_hex(text);
    return key;
}

std::optional<SurfaceModel> ModelCache::find(const ModelKey& key) const {
    const std::optional<std::string> entry = folder_.read(key.text + ending);
    const std::string first_line = header(key);
    if (!entry || !entry->starts_with(first_line)) return std::nullopt;
    try {
        return deserialize(std::string_view(*entry).substr(first_line.size()), key.text);
    } catch (const Error&) {
        return std::nullopt;
    }
}

void ModelCache::keep(const ModelKey& key, SurfaceModel& model) const {
    try {
        folder_.write(key.text + ending, [&](const TakeBytes& sink) {
            sink(header(key));
            serialize(model, sink);
        });
    } catch (const Error& e) {
        model.diagnostics.push_back(
            {Severity::warning, "", std::string("not kept in the cache: ") + e.what()});
    }
}

} // namespace keiko
