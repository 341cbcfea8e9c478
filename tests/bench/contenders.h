#pragma once

#include "keiko/geometry/model/surface_model.h"

#include "tests/bench/command_line.h"
#include "tests/bench/contender.h"
#include "tests/bench/scenes.h"

#include <memory>
#include <vector>

namespace keiko::bench {

using Contenders = std::vector<std::unique_ptr<Contender>>;

/// Keiko first, then all its peers unless it is alone, made ready for one scene. `model` is the
/// scene as loaded; `primary` are the rays that a grid is fitted to. Throws Error where the file
/// cannot be read.
Contenders contenders_of(const SceneFile& scene, const SurfaceModel& model, const RaySet& primary,
                         const TraceOptions& options);

} // namespace keiko::bench
