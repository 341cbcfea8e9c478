#pragma once

#include "keiko/io/model_format.h"
#include "keiko/patch/surface_model.h"

#include <filesystem>
#include <optional>
#include <string>

namespace keiko {

/// Models as the reader made them, kept in a folder under a hash of everything that the result
/// depends on: the file's bytes, its name, its kind, and the versions of Keiko, its serialisation,
/// its libraries and its reader. An entry never grows stale; nothing is ever removed.
class ModelCache {
public:
    /// Makes the folder where it is missing. Throws Error when that fails or nothing may be written
    /// there.
    explicit ModelCache(std::filesystem::path folder);

    /// What the model of a file is kept under, read by `worker`; nothing for a STEP file that names
    /// other files for its parts, which may change without it. Throws Error when the file cannot be
    /// read.
    static std::optional<std::string> key(const std::filesystem::path& file, ModelFormat format,
                                          const std::filesystem::path& worker);
    /// The model kept under a key; nothing where there is none, or a damaged one.
    std::optional<SurfaceModel> find(const std::string& key) const;
    /// Keeps a model, atomically. One that cannot be kept gets a warning and stays usable.
    void keep(const std::string& key, SurfaceModel& model) const;

private:
    std::filesystem::path entry(const std::string& key) const;

    std::filesystem::path folder_;
};

} // namespace keiko
