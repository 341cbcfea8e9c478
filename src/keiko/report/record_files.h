#pragma once

#include "keiko/base/export.h"
#include "keiko/base/output_folder.h"
#include "keiko/compare/fixture_record.h"

#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Author, date and reason of an accepted baseline, and its changes.
struct BaselineChange {
    std::string date;                 ///< "2026-11-21T15:54:00Z"
    std::string by, reason;           ///< who accepted it, and why
    std::string tool;                 ///< "keiko 0.1.0"
    std::vector<std::string> changed; ///< one line each
};

/// A record of a fixture as files: metrics.json (keiko-metrics/1), VIEW.LAYER.exr, rig.toml for
/// lamps that were placed, and manifest.json (keiko-manifest/1) with the SHA-256 of each.
struct KeptRecord {
    FixtureRecord record;                ///< metrics and pictures
    std::string key;                     ///< of its inputs; empty for a baseline
    std::vector<BaselineChange> changes; ///< of a baseline, oldest first
};

/// The files of a record, for a folder.
FolderContent files_of(const KeptRecord& kept);

/// The record in files of `folder`, whose name is for messages. Throws Error for files that are
/// missing, too many, damaged or of another format.
KeptRecord record_of(const FolderContent& files, const std::string& folder);

/// The changes listed in manifest.json, regardless of the other files; empty if it cannot be read
/// itself.
std::vector<BaselineChange> changes_in(const FolderContent& files);

} // namespace keiko
