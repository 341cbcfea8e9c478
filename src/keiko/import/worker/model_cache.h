#pragma once

#include "keiko/files/model/model_format.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/import/worker/cache_folder.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace keiko {

/// Identity of a file and its last change, from the file system.
struct FileStamp {
    std::uint64_t device = 0; ///< number of the file system
    std::uint64_t inode = 0;  ///< number of the file on it
    std::uint64_t size = 0;   ///< bytes
    std::int64_t changed = 0; ///< ns since 1970, of content or status: no program can set it

    bool operator==(const FileStamp&) const = default;
};

/// A file at one moment, to find out later whether it has changed.
struct FileState {
    FileStamp stamp;    ///< taken before the content was read
    std::string sha256; ///< of the content
};

/// State of a file as it is now. Throws Error when it cannot be read.
FileState file_state(const std::filesystem::path& file);

/// Key of a file's model, and the file as it was when the key was made.
struct ModelKey {
    std::string text; ///< 64 hexadecimal digits
    FileState file;   ///< stamped before its bytes were read
};

/// Models as the reader made them, kept in a folder under a hash of everything that the result
/// depends on. These are the file's bytes, its name, its kind, and the versions of Keiko, its
/// serialisation, its libraries and its reader. An entry never grows stale, and is of no use under
/// another key.
class ModelCache {
public:
    /// Folder of the models and their size in all, bytes, 0: no limit, as in CacheFolder. Throws
    /// Error.
    ModelCache(std::filesystem::path folder, std::uint64_t limit);

    /// Key of a file's model, read by `worker`; nullopt for a STEP file that names other files for
    /// its parts, which may change without it. Throws Error when the file cannot be read.
    static std::optional<ModelKey> key(const std::filesystem::path& file, ModelFormat format,
                                       const std::filesystem::path& worker);
    /// Model kept under a key; nullopt where there is none, or one that is damaged or was kept
    /// under another key.
    std::optional<SurfaceModel> find(const ModelKey& key) const;
    /// Keeps a model. One that cannot be kept gets a warning and stays usable.
    void keep(const ModelKey& key, SurfaceModel& model) const;

private:
    CacheFolder folder_;
};

} // namespace keiko
