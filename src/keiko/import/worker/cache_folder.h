#pragma once

#include "keiko/base/new_file.h"
#include "keiko/files/model/byte_stream.h"

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

} // namespace keiko
