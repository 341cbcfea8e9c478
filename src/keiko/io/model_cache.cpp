#include "keiko/io/model_cache.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/output_file.h"
#include "keiko/base/sha256.h"
#include "keiko/io/model_serialization.h"

#include <unistd.h>

#include <fstream>

namespace keiko {
namespace fs = std::filesystem;
namespace {

/// Tells one build of the reader from another.
std::string stamp(const fs::path& worker) {
    std::error_code code;
    const auto size = fs::file_size(worker, code);
    const auto time = fs::last_write_time(worker, code).time_since_epoch().count();
    return std::to_string(size) + " " + std::to_string(time);
}

} // namespace

ModelCache::ModelCache(fs::path folder) : folder_(std::move(folder)) {
    std::error_code code;
    fs::create_directories(folder_, code);
    if (code) throw Error(folder_.string(), "", "cannot make the folder: " + code.message());
    if (access(folder_.c_str(), W_OK | X_OK) != 0)
        throw Error(folder_.string(), "", "no permission to write in the folder");
}

std::optional<std::string> ModelCache::key(const fs::path& file, ModelFormat format,
                                           const fs::path& worker) {
    const std::string bytes = read_file(file);
    if (format == ModelFormat::step && bytes.find("DOCUMENT_FILE") != std::string::npos)
        return std::nullopt;
    std::string text;
    // The name of the file becomes that of a part without a name of its own.
    for (const std::string& part :
         {sha256_hex(bytes), std::string(name_of(format)), file.stem().string(),
          std::string(KEIKO_READERS), std::to_string(model_serialization_version), stamp(worker)})
        text += part + "\n";
    return sha256_hex(text);
}

fs::path ModelCache::entry(const std::string& key) const {
    return folder_ / (key + ".keiko-model");
}

std::optional<SurfaceModel> ModelCache::find(const std::string& key) const {
    const fs::path path = entry(key);
    try {
        return deserialize(read_file(path), path.string());
    } catch (const Error&) {
        return std::nullopt;
    }
}

void ModelCache::keep(const std::string& key, SurfaceModel& model) const {
    try {
        write_atomically(entry(key), [&](const fs::path& temporary) {
            std::ofstream file(temporary, std::ios::binary);
            serialize(model, [&](std::string_view piece) {
                file.write(piece.data(), static_cast<std::streamsize>(piece.size()));
            });
            file.close();
            if (!file) throw Error(temporary.string(), "", "cannot write");
        });
    } catch (const Error& e) {
        model.diagnostics.push_back(
            {Severity::warning, "", std::string("not kept in the cache: ") + e.what()});
    }
}

} // namespace keiko
