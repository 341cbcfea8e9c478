#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/inspection.h"
#include "keiko/inspect/seams/seam_profile.h"
#include "keiko/triage/triage.h"

#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Faults of an inspection in the order of mending, and profiles of stretches that show them.
struct TriagedFaults {
    Triage triage;                     ///< of the inspection
    std::vector<SeamProfile> profiles; ///< of the first stretch of some items
};

/// The faults as "keiko-faults/1": tool, verdict and preset of the inspection, and items and hidden
/// with the keys of report_json, with verdict, faces, message, place and profile. The profile is
/// that of the item's first stretch, with the keys of profiles_json, or null.
std::string faults_json(const TriagedFaults& faults, const Inspection& inspection,
                        const std::string& tool_version);

} // namespace keiko
