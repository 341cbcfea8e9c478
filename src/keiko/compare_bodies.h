#pragma once

#include "keiko/compare/compare_inspections.h"
#include "keiko/compare/deviation.h"
#include "keiko/keiko.h"

namespace keiko {

/// What counts as the same body.
struct BodyTolerance {
    double deviation = 5e-4; ///< mm
    double normal = 0.01;    ///< degrees between the normals
};

struct CompareBodiesOptions {
    LoadOptions load;
    CriteriaPreset preset;
    double join = 0.5; ///< mm
    BodyTolerance tolerance;
    CompareOptions seams;
    DeviationOptions deviation;
};

/// Two revisions of a part held against each other.
struct BodyComparison {
    std::string before, after; ///< files
    BodyTolerance tolerance;
    Deviation deviation; ///< of the latter from the former
    Deviation missing;   ///< of the former from the latter: what the latter has lost
    std::size_t faces_before = 0, faces_after = 0;
    std::vector<std::string> turned; ///< faces of the latter with the inside outside
    InspectionDifference seams;
    Inspection inspection_before, inspection_after;

    /// Whether everything is within the tolerances, with the same faces and findings.
    bool same() const;
};

/// Reads, measures and compares two models, in the same coordinates. Throws Error, Cancelled.
BodyComparison compare_bodies(const std::filesystem::path& before,
                              const std::filesystem::path& after,
                              const CompareBodiesOptions& options = {}, const Job& job = {});

/// For people, some lines; the same text for any number of threads.
std::string comparison_text(const BodyComparison& comparison);

} // namespace keiko
