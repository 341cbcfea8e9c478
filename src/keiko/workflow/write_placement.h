#pragma once

#include "keiko/base/export.h"
#include "keiko/workflow/place_scene.h"

#include <filesystem>

namespace KEIKO_API keiko {

/// Writes placement.json, histogram-N.png for each plane and plan.png (body, lamps and cameras from
/// above) into a folder.
void write_placement(const std::filesystem::path& folder, const Scene& scene,
                     const PlaceResult& result, const Job& job = {});

} // namespace keiko
