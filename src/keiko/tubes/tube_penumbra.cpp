#include "keiko/tubes/tube_penumbra.h"

#include "keiko/math/perpendicular.h"
#include "keiko/tubes/cap_penumbra.h"
#include "keiko/tubes/width_slices.h"

#include <algorithm>
#include <optional>

namespace keiko {
namespace {

/// A box around a tube.
Prism box_around(const TubeLamp& lamp) {
    const Vec3 along = (lamp.b - lamp.a).normalized();
    const Vec3 across = any_perpendicular(along).normalized() * (lamp.diameter / 2);
    const Vec3 up = along.cross(across);
    const auto moved = [&](const Vec3& by) { return Segment{lamp.a + by, lamp.b + by}; };
    return {moved(up - across), moved(-up - across), moved(across + up), moved(across - up)};
}

std::vector<Prism> boxes_around(std::span<const TubeLamp> row) {
    std::vector<Prism> boxes;
    for (const TubeLamp& lamp : row) boxes.push_back(box_around(lamp));
    return boxes;
}

/// Of a lamp's axis.
IntervalSet above_horizon(const TubeLamp& lamp, const Vec3& point, const Vec3& normal) {
    const double a = normal.dot(lamp.a - point), b = normal.dot(lamp.b - point);
    if (a >= 0 && b >= 0) return IntervalSet::whole();
    if (!(a > 0) && !(b > 0)) return {};
    return a > 0 ? IntervalSet::whole(0, a / (a - b)) : IntervalSet::whole(a / (a - b), 1);
}

/// A cap alone lights.
SeenLight seen_end_on(const TubeLamp& lamp, const Visible& visible) {
    const IntervalSet axis = visible.intervals({lamp.a, lamp.b});
    return {axis, axis.empty() ? 0.0 : 1.0};
}

/// A lamp of which some may be hidden, with the nodes that are asked for first.
class PartlySeen {
public:
    PartlySeen(const TubeLamp& lamp, const LampWidth& width, bool axis)
        : axis_{lamp.a, lamp.b},
          width_(width),
          parts_(parts_of(width)),
          asks_axis_(axis),
          middle_tells_(parts_.size() == 1 && parts_[0].at[Slices::middle].all > 0 &&
                        width.middle_tells_axis()) {}

    void add_lines(std::vector<Segment>& lines) const {
        if (asks_axis_ && !middle_tells_) lines.push_back(axis_);
        for (const Slices& part : parts_)
            keiko::add_lines(width_, Slices::ends_and_middle, part, lines);
    }
    /// By what is seen of those lines, from `next` on.
    SeenLight seen(const Visible& visible, const PenumbraOptions& options,
                   std::vector<IntervalSet>::const_iterator& next) {
        SeenLight seen;
        if (asks_axis_) seen.axis = middle_tells_ ? width_.of_axis(next[before_middle()]) : *next++;
        double brightest = 0;
        for (Slices& part : parts_) {
            hide_slices(width_, Slices::ends_and_middle, part, next);
            brightest = std::max(brightest, part.brightest());
        }
        SolidAngle sums;
        for (const Slices& part : parts_) {
            constexpr int most_halvings = 14;
            const double error = options.tolerance * 2 * brightest * part.half;
            sums += integrate(width_, visible, part, {error, options.widest_gap, most_halvings});
        }
        seen.share = sums.visible_share();
        return seen;
    }

private:
    /// Lines of the first part before the middle one.
    int before_middle() const { return parts_[0].at[Slices::first].all > 0 ? 1 : 0; }

    Segment axis_;
    LampWidth width_;
    std::vector<Slices> parts_;
    bool asks_axis_;
    bool middle_tells_; ///< what is seen of the axis
};

} // namespace

std::vector<SeenLight> seen_tubes(std::span<const TubeLamp> row, const Vec3& point,
                                  const Vec3& normal, const Visible& visible,
                                  const PenumbraOptions& options,
                                  std::span<const std::vector<HidingTube>> hiding) {
    const std::vector<std::optional<bool>> wholes = visible.seen_as_whole(boxes_around(row));
    std::vector<SeenLight> seen(row.size(), SeenLight{{}, 0, 0});
    std::vector<PartlySeen> parts;
    std::vector<std::size_t> lamp_of;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (wholes[i]) {
            if (*wholes[i]) seen[i] = {above_horizon(row[i], point, normal), 1, 1};
            continue;
        }
        const auto view = view_of(row[i], point, normal);
        if (!view) {
            seen[i] = seen_end_on(row[i], visible);
            continue;
        }
        const std::span<const HidingTube> others =
            hiding.empty() ? std::span<const HidingTube>() : hiding[i];
        lamp_of.push_back(i);
        parts.emplace_back(row[i], LampWidth(*view, point, options.shape, others), options.axes);
    }
    std::vector<Segment> lines;
    for (const PartlySeen& part : parts) part.add_lines(lines);
    const std::vector<IntervalSet> of_lines = visible.intervals(lines);
    auto next = of_lines.begin();
    for (std::size_t k = 0; k < parts.size(); ++k)
        seen[lamp_of[k]] = parts[k].seen(visible, options, next);
    for (std::size_t i = 0; i < row.size(); ++i)
        if (!wholes[i] && row[i].luminous_caps)
            seen[i].cap = seen_share_of_cap(row[i], point, normal, visible, options.tolerance);
    return seen;
}

} // namespace keiko
