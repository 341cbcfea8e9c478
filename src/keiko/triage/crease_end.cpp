#include "keiko/triage/crease_end.h"

#include "keiko/inspect/seams/seam_chain.h"

#include <algorithm>
#include <array>

namespace keiko {

std::optional<Vec3> end_of_crease(const Inspection& inspection, const MeasuredSeam& seam) {
    if (seam.kind != SeamClass::smooth) return std::nullopt;
    const std::array<Vec3, 2> ends{seam.course.front().front(), seam.course.back().back()};
    const auto meets_crease = [&](const Vec3& end) {
        return std::any_of(
            inspection.seams.begin(), inspection.seams.end(), [&](const MeasuredSeam& other) {
                if (other.line != seam.line || other.kind != SeamClass::crease) return false;
                const Vec3 &first = other.course.front().front(),
                           &last = other.course.back().back();
                return std::min((end - first).length(), (end - last).length()) <= same_vertex;
            });
    };
    const bool first = meets_crease(ends[0]), last = meets_crease(ends[1]);
    if (first == last) return std::nullopt;
    return ends[first ? 1 : 0];
}

} // namespace keiko
