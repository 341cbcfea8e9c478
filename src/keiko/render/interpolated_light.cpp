#include "keiko/render/interpolated_light.h"

#include "keiko/render/grid_lights.h"
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

using Lights = std::vector<std::size_t>; ///< numbers, rising

/// How far a light may be off, as a share of the error that is allowed.
struct Doubt {
    std::size_t light;
    double error;
};

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

    /// Lights a rectangle, of which `known` is what some lights bring to it and `open` are the
    /// others; `left` of the error is still allowed.
    void light(const Rectangle& r, const LinearLight& known, Open open, double left) {
        if (!asks_for_any(r)) return;
        if (open.lit.empty() || r.is_small()) return fill(r, known, open);
        Lights linear;
        if (error_ > 0 && !(r.longest() > largest_square) &&
            grid_.is_smooth(r.x0, r.y0, r.x1, r.y1)) {
            find_probes(r, open);
            linear = take_linear(r, known, open, left);
            take_linearly_seen(r, known, open, left);
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
    void find_probes(const Rectangle& r, const Open& open) {
        for (const Pixel& p : r.corners()) find(p, open);
        for (const Pixel& p : grid_.probes(r)) find(p, open);
    }
    /// Takes lights off that are linear in the quarters, within what is `left` of the error, which
    /// they lessen.
    Lights take_linear(const Rectangle& r, const LinearLight& known, Open& open,
                       double& left) const {
        const Lights linear =
            least_doubtful(r, known, open.lit, open.lit, left,
                           [&](std::size_t light, const Pixel& p) -> std::optional<SpotLight> {
                               return between_corners(r, light, p) - lights_.light(p.x, p.y, light);
                           });
        without(open.lit, linear);
        without(open.seen, linear);
        return linear;
    }
    /// The same of those of which what is seen is linear, and so known in the quarters.
    void take_linearly_seen(const Rectangle& r, const LinearLight& known, Open& open,
                            double& left) {
        const Lights linear = least_doubtful(
            r, known, open.lit, open.seen, left,
            [&](std::size_t light, const Pixel& p) { return wrong_if_seen_linearly(r, light, p); });
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
    /// Those of some lights of which `wrong`(light, place) is least at the probes, as long as all
    /// together are within what is `left` of the error, which they lessen; none of which that is
    /// nothing. `lit`: all that are not `known`.
    template <class Wrong>
    Lights least_doubtful(const Rectangle& r, const LinearLight& known, const Lights& lit,
                          const Lights& lights, double& left, const Wrong& wrong) const {
        std::vector<Doubt> doubts;
        for (const std::size_t light : lights) doubts.push_back({light, 0});
        for (const Pixel& p : grid_.probes(r)) {
            const SpotLight total = known.at(grid_.share(r, p)) + lights_.sum(p.x, p.y, lit);
            for (Doubt& doubt : doubts)
                if (doubt.error <= left)
                    doubt.error =
                        std::max(doubt.error, share_of_error(p, wrong(doubt.light, p), total));
        }
        std::stable_sort(doubts.begin(), doubts.end(),
                         [](const Doubt& a, const Doubt& b) { return a.error < b.error; });
        Lights taken;
        for (const Doubt& doubt : doubts) {
            if (!(doubt.error <= left)) break;
            left -= doubt.error;
            taken.push_back(doubt.light);
        }
        std::sort(taken.begin(), taken.end());
        return taken;
    }
    static void without(Lights& lights, const Lights& taken) {
        std::erase_if(lights, [&](std::size_t light) {
            return std::binary_search(taken.begin(), taken.end(), light);
        });
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
