#pragma once

#include "keiko/base/export.h"
#include "keiko/workflow/compare_options.h"

#include <filesystem>
#include <functional>

namespace KEIKO_API keiko {

/// Reads, measures and compares two models or scenes, in the same coordinates or aligned. The
/// comparison of a body with its own mirror image measures its asymmetry. Throws Error, Cancelled.
CompareResult compare_bodies(const std::filesystem::path& before,
                             const std::filesystem::path& after,
                             const CompareBodiesOptions& options = {}, const Job& job = {});

/// Opens a body for a comparison, with SceneOptions as in its options.
using OpenBody = std::function<Scene(const Job& job)>;

/// Likewise for two bodies that come from elsewhere than a file.
CompareResult compare_bodies(const OpenBody& before, const OpenBody& after,
                             const CompareBodiesOptions& options = {}, const Job& job = {});

/// compare.html, compare.json, the pictures and, if there are views, rig.toml, for a folder. The
/// rig names its files relative to the folder's path.
FolderContent comparison_files(const std::filesystem::path& folder, const CompareResult& result);

} // namespace keiko
