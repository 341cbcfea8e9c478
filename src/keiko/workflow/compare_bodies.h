#pragma once

#include "keiko/base/export.h"
#include "keiko/workflow/compare_options.h"

#include <filesystem>

namespace KEIKO_API keiko {

/// Reads, measures and compares two models or scenes, in the same coordinates or aligned. The
/// comparison of a body with its own mirror image measures its asymmetry. Throws Error, Cancelled.
CompareResult compare_bodies(const std::filesystem::path& before,
                             const std::filesystem::path& after,
                             const CompareBodiesOptions& options = {}, const Job& job = {});

/// Likewise for two bodies that have been opened, with SceneOptions as in `options`.
CompareResult compare_scenes(const Scene& before, Scene after,
                             const CompareBodiesOptions& options = {}, const Job& job = {});

/// compare.html, compare.json, the pictures and, if there are views, rig.toml, for a folder. The
/// rig names its files relative to the folder's path.
FolderContent comparison_files(const std::filesystem::path& folder, const CompareResult& result);

} // namespace keiko
