#pragma once

#include "keiko/geometry/rays/visibility.h"

#include <algorithm>

namespace keiko::test {

/// Shows what lies on one side of a wall at an x.
class ShowsBelow final : public Visibility {
public:
    explicit ShowsBelow(double x) : x_(x) {}
    using Visibility::intervals;
    IntervalSet intervals(const Segment& line) const override {
        const double rise = line.b.x - line.a.x;
        if (rise == 0) return line.a.x < x_ ? IntervalSet::whole() : IntervalSet();
        const double t = std::clamp((x_ - line.a.x) / rise, 0.0, 1.0);
        return rise > 0 ? IntervalSet::whole(0, t) : IntervalSet::whole(t, 1);
    }

private:
    double x_;
};

} // namespace keiko::test
