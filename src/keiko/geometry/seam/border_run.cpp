#include "keiko/geometry/seam/border_run.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

const double sin_parallel = std::sin(parallel_borders);

/// The two walks from a place, there and back.
struct Surroundings {
    LoopWalk ahead, behind;

    explicit Surroundings(const LoopPlace& place) : ahead(place, true), behind(place, false) {}

    /// From where the loop comes within `radius` mm of the place to where it leaves; 0 if it turns
    /// back between, nullopt if it stays within.
    std::optional<Vec3> chord(double radius) {
        const std::optional<Vec3> to = ahead.leave(radius), from = behind.leave(radius);
        if (!to || !from) return std::nullopt;
        const Vec3 chord = *to - *from;
        return chord.length() >= radius ? chord : Vec3(0);
    }
};

} // namespace

bool nearly_parallel(const Vec3& a, const Vec3& b, double sine) {
    const Vec3 c = a.cross(b);
    return c.dot(c) <= sine * sine * a.dot(a) * b.dot(b);
}

LoopWalk::LoopWalk(const LoopPlace& from, bool forward)
    : line_(*from.line),
      from_(from.position),
      last_(from.position),
      next_(forward ? (from.chord + 1) % from.line->size() : from.chord),
      forward_(forward) {}

std::optional<Vec3> LoopWalk::leave(double radius) {
    const std::size_t last = line_.size() - 1;
    for (; passed_ <= line_.size(); ++passed_) {
        const Vec3& next = line_[next_];
        const Vec3 apart = next - from_;
        if (apart.dot(apart) >= radius * radius) {
            // |last + x (next - last) - from| = radius
            const Vec3 way = next - last_, off = last_ - from_;
            const double a = way.dot(way), b = way.dot(off);
            const double c = std::min(off.dot(off) - radius * radius, 0.0);
            return last_ + way * (a > 0 ? (std::sqrt(b * b - a * c) - b) / a : 0);
        }
        last_ = next;
        if (forward_)
            next_ = next_ < last ? next_ + 1 : 0;
        else
            next_ = next_ > 0 ? next_ - 1 : last;
    }
    return std::nullopt;
}

void Border::append_to(LoopLine& line) {
    loop = &line, first = line.size();
    line.insert(line.end(), polyline.points.begin(), polyline.points.end());
}

LoopPlace Border::place(double t, const Vec3& position) const {
    const auto beyond = std::upper_bound(polyline.t.begin() + 1, polyline.t.end() - 1, t);
    return {loop, first + static_cast<std::size_t>(beyond - polyline.t.begin()) - 1, position};
}

std::optional<bool> run_alike(const BorderPlace& a, const BorderPlace& b, double join) {
    if (nearly_parallel(a.along, b.along, sin_parallel)) return a.along.dot(b.along) > 0;
    constexpr int halvings = 8;
    Surroundings of_a(a.place), of_b(b.place);
    const double largest = join / sin_parallel / 2;
    for (int i = halvings; i >= 0; --i) {
        const double radius = std::ldexp(largest, -i);
        const auto chord_a = of_a.chord(radius), chord_b = of_b.chord(radius);
        if (!chord_a || !chord_b) return std::nullopt;
        const double same = chord_a->dot(*chord_b);
        if (same != 0 && nearly_parallel(*chord_a, *chord_b, sin_parallel)) return same > 0;
    }
    return std::nullopt;
}

} // namespace keiko
