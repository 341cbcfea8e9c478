#include "keiko/inspect/seams/course_distance.h"

#include "keiko/geometry/model/closest_point.h"

#include <algorithm>
#include <limits>
#include <span>

namespace keiko {
namespace {

/// Distance by which a course lies off its chords about point i: an eighth of its second
/// difference.
double sagitta_at(std::span<const Vec3> course, std::size_t i) {
    if (i == 0 || i + 1 >= course.size()) return 0;
    return (course[i - 1] - course[i] * 2 + course[i + 1]).length() / 8;
}

} // namespace

double distance_from_course(const MeasuredSeam& seam, const Vec3& place) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::vector<Vec3>& piece : seam.course)
        for (std::size_t i = 0; i + 1 < piece.size(); ++i) {
            const double sagitta = std::max(sagitta_at(piece, i), sagitta_at(piece, i + 1));
            const double off = segment_distance(piece[i], piece[i + 1], place) - sagitta;
            nearest = std::min(nearest, std::max(off, 0.0));
        }
    return nearest;
}

} // namespace keiko
