#include "keiko/light/tubes/tube_penumbra.h"

#include "keiko/light/penumbra/width_share.h"
#include "keiko/math/axes.h"

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

/// The part of a lamp's axis above the horizon.
IntervalSet above_horizon(const TubeLamp& lamp, const Vec3& point, const Vec3& normal) {
    const double a = normal.dot(lamp.a - point), b = normal.dot(lamp.b - point);
    if (a >= 0 && b >= 0) return IntervalSet::whole();
    if (!(a > 0) && !(b > 0)) return {};
    return a > 0 ? IntervalSet::whole(0, a / (a - b)) : IntervalSet::whole(a / (a - b), 1);
}

/// Visibility of a lamp whose only lit part is a cap.
LightVisibility seen_end_on(const TubeLamp& lamp, const Visibility& visible) {
    const IntervalSet axis = visible.intervals({lamp.a, lamp.b});
    return {axis, axis.empty() ? 0.0 : 1.0};
}

/// A lamp that may be partly hidden, with the lines that are queried first. References are kept.
class PartlySeen {
public:
    PartlySeen(const TubeLamp& lamp, const LampWidth& width, const PenumbraOptions& options)
        : axis_{lamp.a, lamp.b},
          width_(width),
          axes_(options.axes),
          share_(width, {options.tolerance, options.widest_spacing, options.between_lines}),
          middle_tells_(share_.parts().size() == 1 &&
                        share_.parts()[0].at[Slices::middle].all > 0 && width.middle_tells_axis()) {
    }

    void add_lines(std::vector<Segment>& lines) const {
        if (axes_ && !middle_tells_) lines.push_back(axis_);
        share_.add_lines(width_, lines);
    }
    /// Visibility of the lamp from that of those lines, from `next` on.
    LightVisibility seen(const Visibility& visible,
                         std::vector<IntervalSet>::const_iterator& next) {
        LightVisibility seen;
        if (axes_ && !middle_tells_) seen.axis = *next++;
        share_.hide_lines(width_, next);
        if (axes_ && middle_tells_) seen.axis = width_.of_axis(*share_.parts()[0].seen[1]);
        seen.share = share_.visible_share(width_, visible);
        return seen;
    }

private:
    Segment axis_;
    const LampWidth& width_;
    bool axes_;
    WidthShare share_;
    bool middle_tells_; ///< visibility of the middle line determines that of the axis
};

} // namespace

std::vector<LightVisibility> seen_tubes(std::span<const TubeLamp> row, const Vec3& point,
                                        const Vec3& normal, const Visibility& visible,
                                        const PenumbraOptions& options,
                                        std::span<const std::vector<OccludingTube>> hiding) {
    const std::vector<std::optional<bool>> wholes = visible.classify_prisms(boxes_around(row));
    std::vector<LightVisibility> seen(row.size(), LightVisibility{{}, 0, 0});
    std::vector<PartlySeen> parts;
    std::vector<LampWidth> widths; // that the parts refer to
    widths.reserve(row.size());
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
        const std::span<const OccludingTube> others =
            hiding.empty() ? std::span<const OccludingTube>() : hiding[i];
        lamp_of.push_back(i);
        widths.emplace_back(*view, point, options.shape, others);
        parts.emplace_back(row[i], widths.back(), options);
    }
    std::vector<Segment> lines;
    for (const PartlySeen& part : parts) part.add_lines(lines);
    const std::vector<IntervalSet> of_lines = visible.intervals(lines);
    auto next = of_lines.begin();
    for (std::size_t k = 0; k < parts.size(); ++k) seen[lamp_of[k]] = parts[k].seen(visible, next);
    for (std::size_t i = 0; i < row.size(); ++i)
        if (!wholes[i] && row[i].luminous_caps)
            seen[i].cap = seen_share_of_cap(row[i], point, normal, visible, options.tolerance);
    return seen;
}

} // namespace keiko
