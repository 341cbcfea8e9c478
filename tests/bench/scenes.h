#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <filesystem>
#include <string>
#include <vector>

namespace keiko::bench {

/// A body that rays are traced against.
struct SceneFile {
    std::string name{};
    std::filesystem::path file{};
    bool free_form = true; ///< styled surfaces; false: mechanical parts, mostly trimmed
    double scale = 1;      ///< the file's lengths are multiplied by it

    bool present() const { return std::filesystem::exists(file); }
    /// Throws Error.
    SurfaceModel load() const;
};

/// All scenes, whether their file is there or not.
std::vector<SceneFile> known_scenes();

/// Scenes of the given names (or paths of model files); all when there are none. Throws Error for a
/// name that is neither.
std::vector<SceneFile> chosen_scenes(const std::vector<std::string>& names);

} // namespace keiko::bench
