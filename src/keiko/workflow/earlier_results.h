#pragma once

#include "keiko/base/output_folder.h"

#include <filesystem>
#include <span>
#include <vector>

namespace keiko {

/// Places that a run is about to write results to. Empty paths stand for nothing.
struct ResultPlaces {
    std::vector<std::filesystem::path> files;
    std::vector<std::filesystem::path> folders; ///< their content with_manifest
};

/// The files of a folder and one more, which lists them with their hashes: what a later run may
/// withdraw.
FolderContent with_manifest(FolderContent content);

/// Removes what an earlier run has left in these places, so that a run that fails leaves no results
/// that pass for its own. Of a folder only what its manifest lists, and only where it is unchanged.
/// Devices and pipes stay, and so does whatever `inputs` are or name, as scenes name files. Throws
/// Error for a result that cannot be removed.
void withdraw_results(const ResultPlaces& places, std::span<const std::filesystem::path> inputs);

} // namespace keiko
