#include "keiko/triage/continuations.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/seam/border_run.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

/// An end of a stretch and the direction in which the stretch leads out of it.
struct CourseEnd {
    std::size_t stretch = 0;
    Vec3 place{0}, out{0};
    double length = 0; ///< mm, of the stretch
    bool goes_on = false;
};

/// The end at the front of a course. Its direction is that from a twentieth of the length before
/// it: the first chords may be of any length.
CourseEnd front_end(const std::vector<std::vector<Vec3>>& course, std::size_t stretch,
                    double length) {
    const Vec3 end = course.front().front();
    Vec3 before = end;
    for (const std::vector<Vec3>& piece : course)
        for (const Vec3& point : piece)
            if ((before - end).length() < length / 20) before = point;
    return {stretch, end, end - before, length};
}

std::vector<CourseEnd> ends_of(std::span<const MeasuredSeam* const> stretches) {
    std::vector<CourseEnd> ends;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        const MeasuredSeam& seam = *stretches[i];
        std::vector<std::vector<Vec3>> reversed(seam.course.rbegin(), seam.course.rend());
        for (std::vector<Vec3>& piece : reversed) std::reverse(piece.begin(), piece.end());
        ends.push_back(front_end(seam.course, i, seam.length));
        ends.push_back(front_end(reversed, i, seam.length));
    }
    return ends;
}

/// False for a short piece at the end of a line, as at the corner of a fillet: it is no link to
/// what lies beyond it.
bool are_of_one_size(const CourseEnd& a, const CourseEnd& b) {
    constexpr double least = 0.1;
    return std::min(a.length, b.length) >= least * std::max(a.length, b.length);
}

/// mm between two ends where one goes on as the other leads out; infinite for others.
double distance_on(const CourseEnd& a, const CourseEnd& b, double reach) {
    constexpr double bend = 0.5; // sine of the largest angle between them
    const double distance = (a.place - b.place).length();
    const bool is_on = distance <= reach && a.stretch != b.stretch && are_of_one_size(a, b) &&
                       a.out.dot(b.out) < 0 && nearly_parallel(a.out, b.out, bend);
    return is_on ? distance : HUGE_VAL;
}

/// The end that goes on where another leads out; null if nothing within reach does.
const CourseEnd* nearest_free(const std::vector<CourseEnd>& ends, const CourseEnd& from,
                              double out_of_step) {
    constexpr double share = 0.05;
    const CourseEnd* nearest = nullptr;
    double distance = HUGE_VAL;
    for (const CourseEnd& end : ends) {
        if (end.goes_on) continue;
        const double reach = std::min(out_of_step, share * std::min(from.length, end.length));
        const double own = distance_on(from, end, reach);
        if (own < distance) nearest = &end, distance = own;
    }
    return nearest;
}

} // namespace

std::vector<std::array<std::size_t, 2>> continuations(
    std::span<const MeasuredSeam* const> stretches, const LineReach& reach) {
    std::vector<CourseEnd> ends = ends_of(stretches);
    std::vector<std::array<std::size_t, 2>> pairs;
    for (std::size_t j = 1; j < ends.size(); ++j) {
        check_stop();
        for (std::size_t i = 0; i < j; ++i) {
            if (distance_on(ends[i], ends[j], reach.join) > reach.join) continue;
            ends[i].goes_on = ends[j].goes_on = true;
            pairs.push_back({ends[i].stretch, ends[j].stretch});
        }
    }
    for (const CourseEnd& end : ends) {
        if (end.goes_on) continue;
        check_stop();
        if (const CourseEnd* next = nearest_free(ends, end, reach.out_of_step))
            pairs.push_back({end.stretch, next->stretch});
    }
    return pairs;
}

} // namespace keiko
