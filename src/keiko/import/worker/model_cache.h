#pragma once

#include "keiko/base/new_file.h"
#include "keiko/files/model/byte_stream.h"
#include "keiko/files/model/model_format.h"
#include "keiko/geometry/model/surface_model.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace keiko {

/// Folder of a user's own files, called entries, that can be made again at any time. Those that
/// were not used for the longest time are removed where it grows too large. Several processes may
/// use it at once.
class CacheFolder {
public:
    /// Makes the folder where it is missing, for the user alone. `ending` is that of the entries'
    /// names; files with other names are left alone. `limit` is the size of all entries, bytes; 0:
    /// no limit. Throws Error when the folder cannot be made or written, belongs to another user,
    /// or may be written by one.
    CacheFolder(std::filesystem::path folder, std::string ending, std::uint64_t limit);

    /// Content of an entry, which counts as used now; nullopt where there is none. What the user
    /// alone has not written is none: a link, a file of another user, one that others may write.
    std::optional<std::string> read(const std::string& name) const;

    /// Writes an entry in the place of what has the name, a link too, and removes the least
    /// recently used. Throws Error when it cannot be written, or is larger than the limit.
    void write(const std::string& name,
               const std::function<void(const TakeBytes& sink)>& content) const;

private:
    [[noreturn]] void fail(const std::string& reason) const;
    void remove_least_recently_used(const std::string& spared) const;

    std::filesystem::path path_;
    std::string ending_;
    std::uint64_t limit_;
    Descriptor folder_;
};

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
