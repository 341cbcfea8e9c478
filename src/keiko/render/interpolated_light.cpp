#include "keiko/render/interpolated_light.h"

#include "keiko/render/grid_lights.h"
#include "keiko/render/light_doubts.h"
#include "keiko/render/linear_light.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace keiko {
namespace {

/// Pixels a side of the largest squares that are lit from a few places: shadows narrower than a
/// third of it may be missed.
constexpr int largest_square = 16;

/// Infinite where nothing is allowed, or what is wrong is no number.
double ratio(double wrong, double allowed) {
    if (wrong == 0) return 0;
    const double ratio = wrong / allowed;
    return ratio >= 0 ? ratio : std::numeric_limits<double>::infinity();
}

class Interpolation {
public:
    Interpolation(const Integrator& integrator, const SpotGrid& grid,
                  const std::vector<bool>& skipped, double error, std::span<const Rgb> seen)
        : integrator_(integrator),
          grid_(grid),
          skipped_(skipped),
          error_(error),
          seen_(seen),
          lights_(integrator, grid),
          light_(grid.size()) {}

    /// The light of each place that is not skipped, by its index.
    std::vector<SpotLight> light() {
        const Rectangle all{0, 0, grid_.width() - 1, grid_.height() - 1};
        const auto numbers = lights_.numbers();
        const Lights each(numbers.begin(), numbers.end());
        light(all, {}, {each, each}, 1);
        return std::move(light_);
    }

private:
    /// Lights that are not linear over a rectangle.
    struct Open {
        Lights lit;
        Lights seen; ///< those of them of which it is not known either what is seen
    };

    /// Doubts of the lights that are open in whether they are linear, and in whether what is seen
    /// of them is.
    struct Doubts {
        std::vector<Doubt> lit, seen;
    };

    /// Lights a rectangle, of which `known` is what some lights bring to it and `open` are the
    /// others; `left` of the error is still allowed.
    void light(const Rectangle& r, const LinearLight& known, Open open, double left) {
        if (!asks_for_any(r)) return;
        if (open.lit.empty() || r.is_small()) return fill(r, known, open);
        Lights linear;
        if (error_ > 0 && !(r.longest() > largest_square) &&
            grid_.is_smooth(r.x0, r.y0, r.x1, r.y1)) {
            Doubts doubts = doubts_of(r, known, open, left);
            linear = least_doubtful(std::move(doubts.lit), left);
            without(open.lit, linear);
            without(open.seen, linear);
            take_linearly_seen(r, std::move(doubts.seen), open, left);
        }
        for (const Rectangle& quarter : r.quarters()) {
            LinearLight of_quarter;
            for (std::size_t i = 0; i < 4; ++i) {
                const Pixel corner = quarter.corners()[i];
                of_quarter.corners[i] = known.at(grid_.share(r, corner));
                if (!linear.empty())
                    of_quarter.corners[i] += lights_.sum(corner.x, corner.y, linear);
            }
            light(quarter, of_quarter, open, left);
        }
    }
    void find(const Pixel& p, const Open& open) {
        lights_.find_for_sure(p.x, p.y, open.seen);
        lights_.find(p.x, p.y, open.lit);
    }
    /// At odd places only those are asked for that the middles, for which the quarters ask as well,
    /// leave a hope.
    Doubts doubts_of(const Rectangle& r, const LinearLight& known, const Open& open, double left) {
        Doubts doubts{doubts_in(open.lit), doubts_in(open.seen)};
        for (const Pixel& p : r.corners()) find(p, open);
        for (const Pixel& p : r.middles()) find(p, open);
        for (const Pixel& p : r.middles())
            add_doubts(r, p, known.at(grid_.share(r, p)) + lights_.sum(p.x, p.y, open.lit), left,
                       doubts);
        for (const Pixel& p : grid_.odd_places(r)) {
            const Open hopeful = hopes(doubts, left);
            find(p, hopeful);
            SpotLight total = known.at(grid_.share(r, p));
            for (const std::size_t light : open.lit)
                total += holds(hopeful.lit, light) ? lights_.light(p.x, p.y, light)
                                                   : between_corners(r, light, p);
            add_doubts(r, p, total, left, doubts);
        }
        return doubts;
    }
    /// The lights of which either may still be within what is `left` of the error.
    static Open hopes(const Doubts& doubts, double left) {
        Open hopeful;
        for (const auto* of : {&doubts.lit, &doubts.seen})
            for (const Doubt& doubt : *of)
                if (doubt.error <= left) hopeful.lit.push_back(doubt.light);
        std::sort(hopeful.lit.begin(), hopeful.lit.end());
        hopeful.lit.erase(std::unique(hopeful.lit.begin(), hopeful.lit.end()), hopeful.lit.end());
        for (const Doubt& doubt : doubts.seen)
            if (holds(hopeful.lit, doubt.light)) hopeful.seen.push_back(doubt.light);
        return hopeful;
    }
    /// Of one place, `total` being all light there; only where they are still within what is `left`
    /// of the error.
    void add_doubts(const Rectangle& r, const Pixel& p, const SpotLight& total, double left,
                    Doubts& doubts) const {
        for (Doubt& doubt : doubts.lit)
            if (doubt.error <= left)
                doubt.add(share_of_error(
                    p, between_corners(r, doubt.light, p) - lights_.light(p.x, p.y, doubt.light),
                    total));
        for (Doubt& doubt : doubts.seen)
            if (doubt.error <= left)
                doubt.add(share_of_error(p, wrong_if_seen_linearly(r, doubt.light, p), total));
    }
    /// Takes lights off of which what is seen is linear, and so known in the quarters.
    void take_linearly_seen(const Rectangle& r, std::vector<Doubt> doubts, Open& open,
                            double& left) {
        std::erase_if(doubts, [&](const Doubt& doubt) { return !holds(open.seen, doubt.light); });
        const Lights linear = least_doubtful(std::move(doubts), left);
        for (const std::size_t light : linear)
            for (const Rectangle& quarter : r.quarters()) take_seen(quarter, light);
        without(open.seen, linear);
    }
    std::optional<SpotLight> wrong_if_seen_linearly(const Rectangle& r, std::size_t light,
                                                    const Pixel& p) const {
        const auto seen = seen_between_corners(r, light, p);
        if (!seen) return std::nullopt;
        if (*seen == lights_.seen(p.x, p.y, light)) return SpotLight();
        return lights_.if_seen(p.x, p.y, light, *seen) - lights_.light(p.x, p.y, light);
    }
    void take_seen(const Rectangle& r, std::size_t light) {
        for (int y = r.y0; y <= r.y1; ++y)
            for (int x = r.x0; x <= r.x1; ++x)
                if (const auto seen = seen_between_corners(r, light, {x, y}))
                    lights_.take(x, y, light, *seen);
    }
    /// What one light would bring to a place if it were linear between the corners.
    SpotLight between_corners(const Rectangle& r, std::size_t light, const Pixel& p) const {
        LinearLight linear;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto [x, y] = r.corners()[i];
            linear.corners[i] = lights_.light(x, y, light);
        }
        return linear.at(grid_.share(r, p));
    }
    /// Nothing where the corners do not see the same number of parts of it.
    std::optional<SeenLight> seen_between_corners(const Rectangle& r, std::size_t light,
                                                  const Pixel& p) const {
        const auto [a, b, c, d] = r.corners();
        const auto at = [&](const Pixel& corner) {
            return lights_.seen(corner.x, corner.y, light);
        };
        const Vec2 share = grid_.share(r, p);
        const auto upper = between(at(a), at(b), share.x), lower = between(at(c), at(d), share.x);
        return upper && lower ? between(*upper, *lower, share.y) : std::nullopt;
    }
    /// What is wrong at a place as a share of what may be, `total` being all light there.
    double share_of_error(const Pixel& p, const std::optional<SpotLight>& wrong,
                          const SpotLight& total) const {
        if (!wrong) return std::numeric_limits<double>::infinity();
        const LitSpot& spot = *grid_.at(p.x, p.y);
        const auto seen_of = [&](const SpotLight& light) {
            return spot.weight * integrator_.luminance(spot, light);
        };
        const Rgb off = seen_of(*wrong), seen = seen_[grid_.index(p.x, p.y)] + seen_of(total);
        const double most = std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)});
        return std::max(ratio(most, error_ * max_channel(seen)),
                        ratio(std::abs(wrong->incident), error_ * total.incident));
    }
    bool asks_for(int x, int y) const {
        return grid_.at(x, y) && (skipped_.empty() || !skipped_[grid_.index(x, y)]);
    }
    bool asks_for_any(const Rectangle& r) const {
        for (int y = r.y0; y <= r.y1; ++y)
            for (int x = r.x0; x <= r.x1; ++x)
                if (asks_for(x, y)) return true;
        return false;
    }
    void fill(const Rectangle& r, const LinearLight& known, const Open& open) {
        for (int y = r.y0; y <= r.y1; ++y)
            for (int x = r.x0; x <= r.x1; ++x) {
                if (!asks_for(x, y)) continue;
                find({x, y}, open);
                light_[grid_.index(x, y)] =
                    known.at(grid_.share(r, {x, y})) + lights_.sum(x, y, open.lit);
            }
    }

    const Integrator& integrator_;
    const SpotGrid& grid_;
    const std::vector<bool>& skipped_;
    double error_;
    std::span<const Rgb> seen_;
    GridLights lights_;
    std::vector<SpotLight> light_;
};

} // namespace

std::vector<SpotLight> interpolated_light(const Integrator& integrator, const SpotGrid& grid,
                                          std::span<const Rgb> seen,
                                          const std::vector<bool>& skipped, double error) {
    return Interpolation(integrator, grid, skipped, error, seen).light();
}

void add_interpolated_light(const Integrator& integrator, int width,
                            const std::vector<bool>& skipped, double error, EyeView& view) {
    const auto height = static_cast<int>(view.samples.size()) / width;
    each_depth(view.spots, [&](std::span<const LitSpot> spots) {
        const SpotGrid grid(width, height, spots);
        std::vector<Rgb> seen;
        for (const EyeSample& sample : view.samples) seen.push_back(sample.luminance);
        const std::vector<SpotLight> light =
            interpolated_light(integrator, grid, seen, skipped, error);
        for (const LitSpot& spot : spots)
            integrator.add_light(spot, light[spot.sample], view.samples[spot.sample]);
    });
}

} // namespace keiko
