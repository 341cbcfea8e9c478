#pragma once

#include "keiko/base/job.h"
#include "keiko/import/subdivision/limit_table.h"

#include <memory>

namespace keiko::subdivision {

/// How far caps are from the limit surface, at parameters where a deeper table is exact.
struct CapError {
    double distance = 0; ///< mm, at equal parameters
    double height = 0;   ///< mm, along the normal: what distance is of shape
    double angle = 0;    ///< radians, between the normals

    /// Takes the larger of both for each of the three.
    void extend(const CapError& other);
};

/// Largest number of points that semi-sharp creases may need; about 4 GB in all.
constexpr std::size_t most_refined_points = 4'000'000;

/// A cage refined as deep as its caps need.
struct CapChoice {
    std::unique_ptr<LimitTable> table; ///< of that level, not null
    int level = 0;                     ///< of refinement, up to deepest_level
    std::vector<CapError> errors;      ///< a base face: at most
};

/// Refines until every cap is within its tolerances, measured against the deepest table, or to the
/// deepest level; then the errors are those of caps two levels before it, which bound them. Throws
/// Error for semi-sharp creases that ask for more than most_refined_points.
CapChoice choose_caps(const Cage& cage, const Job& job = {});

/// 1 for a regular face of the scheme, n for an n-gon of the Catmull-Clark scheme.
std::uint32_t base_faces(const Cage& cage, const CageFace& face);

} // namespace keiko::subdivision
