#pragma once

#include "keiko/base/job.h"
#include "keiko/import/subdivision/limit_table.h"

namespace keiko::subdivision {

/// How far caps are from the limit surface, at parameters where a deeper table is exact.
struct CapError {
    double distance = 0; ///< mm, at equal parameters
    double height = 0;   ///< mm, along the normal: what distance is of shape
    double angle = 0;    ///< radians, between the normals

    void extend(const CapError& other);
};

/// What a cap may differ by.
struct CapTolerance {
    double distance = 0, angle = 0; ///< as CapError
};

/// The caps of `table` against the exact patches of `deeper`, each base face's worst.
std::vector<CapError> cap_errors(const LimitTable& table, const LimitTable& deeper,
                                 std::size_t base_faces, const Job& job = {});

/// Whether all of them keep within a tolerance; stops at the first that does not.
bool caps_within(const LimitTable& table, const LimitTable& deeper, const CapTolerance& tolerance);

} // namespace keiko::subdivision
