#pragma once

#include "keiko/base/export.h"
#include "keiko/base/output_folder.h"

#include <filesystem>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// Places to which a run is about to write results. Empty paths are ignored.
struct ResultPlaces {
    std::vector<std::filesystem::path> files;   ///< to be written
    std::vector<std::filesystem::path> folders; ///< their content with_manifest
};

/// The files of a folder and one more, which lists them with their hashes: those that a later run
/// may withdraw.
FolderContent with_manifest(FolderContent content);

/// Removes the results of an earlier run in these places, so that a failed run leaves none that
/// could be mistaken for its own. In a folder it removes only files that its manifest lists, and
/// only if they are unchanged. Devices and pipes stay. In a folder all `inputs` stay, and the files
/// that they name, as scenes do. Throws Error for a file to be written that is one of those, before
/// anything is removed, and for a result that cannot be removed.
void withdraw_results(const ResultPlaces& places, std::span<const std::filesystem::path> inputs);

} // namespace keiko
