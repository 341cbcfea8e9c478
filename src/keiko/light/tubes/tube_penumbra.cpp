#include "keiko/light/tubes/tube_penumbra.h"

#include "keiko/light/tubes/width_samples.h"
#include "keiko/math/axes.h"

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

/// A lamp that may be partly hidden, with the nodes that are queried first.
class PartlySeen {
public:
    PartlySeen(const TubeLamp& lamp, const LampWidth& width, const PenumbraOptions& options)
        : axis_{lamp.a, lamp.b},
          width_(width),
          options_(options),
          parts_(parts_of(width)),
          middle_tells_(parts_.size() == 1 && parts_[0].at[Slices::middle].all > 0 &&
                        width.middle_tells_axis()) {}

    void add_lines(std::vector<Segment>& lines) const {
        if (options_.axes && !middle_tells_) lines.push_back(axis_);
        add_ends_and_middles(width_, parts_, lines);
    }
    /// Visibility of the lamp from that of those lines, from `next` on.
    LightVisibility seen(const Visibility& visible,
                         std::vector<IntervalSet>::const_iterator& next) {
        LightVisibility seen;
        if (options_.axes && !middle_tells_) seen.axis = *next++;
        hide_parts(next);
        if (options_.axes && middle_tells_) seen.axis = width_.of_axis(*parts_[0].seen[1]);
        if (options_.between_lines) look_between(visible);
        SolidAngle sums;
        for (const Slices& part : parts_) sums += integrate(width_, visible, part, rule_of(part));
        seen.share = sums.visible_share();
        return seen;
    }

private:
    void hide_parts(std::vector<IntervalSet>::const_iterator& next) {
        hide_ends_and_middles(width_, options_.between_lines, parts_, next);
        brightest_ = 0;
        for (const Slices& part : parts_) brightest_ = std::max(brightest_, part.brightest());
    }
    SliceRule rule_of(const Slices& part) const {
        constexpr int most_halvings = 14;
        const double error = options_.tolerance * 2 * brightest_ * part.half;
        return {error, options_.widest_spacing, options_.between_lines, most_halvings};
    }
    bool agree() const {
        return parts_.size() == 1 && ends_and_middle_agree(parts_[0], rule_of(parts_[0]));
    }
    /// Cuts the width at turns of outlines, as often as necessary for at most the tolerance to be
    /// missed between lines.
    void look_between(const Visibility& visible) {
        const double spacing = options_.widest_spacing / 2, allowed = options_.tolerance;
        const auto line = [&](double place) { return width_.line_of(width_.sub_axis(place)); };
        const Prism lines{line(-1), line(0), line(0), line(1)};
        const std::vector<CriticalSlice> found = visible.turns(lines, {spacing, allowed / 2});
        if (found.empty()) return;
        const std::vector<WidthCut> cuts =
            PenumbraBreakpoints(width_, found, spacing).cuts(allowed, agree());
        if (!cuts.empty()) cut_at(cuts, visible);
    }
    /// Cuts the width; the visibility of both ends is known.
    void cut_at(std::span<const WidthCut> cuts, const Visibility& visible) {
        std::vector<Slices> parts = parts_of(width_, cuts);
        if (parts.front().begin() == -1) parts.front().seen.front() = parts_.front().seen.front();
        if (parts.back().end() == 1) parts.back().seen.back() = parts_.back().seen.back();
        parts_ = std::move(parts);
        std::vector<Segment> lines;
        add_ends_and_middles(width_, parts_, lines);
        const std::vector<IntervalSet> seen = visible.intervals(lines);
        auto next = seen.begin();
        hide_parts(next);
    }

    Segment axis_;
    LampWidth width_;
    PenumbraOptions options_;
    std::vector<Slices> parts_;
    bool middle_tells_; ///< visibility of the middle line determines that of the axis
    double brightest_ = 0;
};

} // namespace

std::vector<LightVisibility> seen_tubes(std::span<const TubeLamp> row, const Vec3& point,
                                        const Vec3& normal, const Visibility& visible,
                                        const PenumbraOptions& options,
                                        std::span<const std::vector<OccludingTube>> hiding) {
    const std::vector<std::optional<bool>> wholes = visible.classify_prisms(boxes_around(row));
    std::vector<LightVisibility> seen(row.size(), LightVisibility{{}, 0, 0});
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
        const std::span<const OccludingTube> others =
            hiding.empty() ? std::span<const OccludingTube>() : hiding[i];
        lamp_of.push_back(i);
        parts.emplace_back(row[i], LampWidth(*view, point, options.shape, others), options);
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
