#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/scene/scene_spec.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace keiko {

/// The scene of models, which together form one body, or of one scene file (.toml) at a frame of
/// its animation. Models that no scene file paints have the named material. Throws Error.
SceneSpec spec_of(std::span<const std::filesystem::path> inputs, const std::string& material,
                  double frame = 0);

/// A body and its paint, one a face.
struct PaintedBody {
    SurfaceModel model;              ///< all models of the scene as one
    std::vector<Material> materials; ///< as SurfaceModel::faces
};

/// The models of a scene as one body. A file is read once, however often the scene places it.
/// Throws Error for input that cannot be read, and for an override that paints nothing.
PaintedBody read_body(const SceneSpec& spec, const LoadOptions& options, const Job& job);

} // namespace keiko
