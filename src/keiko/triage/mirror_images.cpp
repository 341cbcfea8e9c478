#include "keiko/triage/mirror_images.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double image_share = 0.01; ///< of the length of two images: by which they may differ

/// True if two places off a plane are images of each other at it, within `slack` mm.
bool are_images(const Vec3& a, const Vec3& b, double slack, const MirrorPlane& mirror) {
    return (mirror.image(a) - b).length() <= slack && std::abs(mirror.distance(a)) > slack;
}

bool are_images(const MeasuredSeam& a, const MeasuredSeam& b, const MirrorPlane& mirror) {
    const double slack = image_share * std::max(a.length, b.length);
    return std::abs(a.length - b.length) <= slack && are_images(a.middle, b.middle, slack, mirror);
}

/// False for checks that are of no opening.
bool are_images(const Check& a, const Check& b, const MirrorPlane& mirror) {
    const double slack = image_share * std::max(a.opening_length, b.opening_length);
    return slack > 0 && are_images(a.worst.place, b.worst.place, slack, mirror);
}

} // namespace

bool are_mirror_images(const Inspection& inspection, const FaultUnit& a, const FaultUnit& b,
                       const MirrorPlane& mirror) {
    const bool of_seam = a.seam != no_index;
    if (of_seam != (b.seam != no_index)) return false;
    if (of_seam) return are_images(inspection.seams[a.seam], inspection.seams[b.seam], mirror);
    return are_images(numbered_check(inspection, a.findings.front()),
                      numbered_check(inspection, b.findings.front()), mirror);
}

} // namespace keiko
