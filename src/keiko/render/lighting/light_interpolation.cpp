#include "keiko/render/lighting/light_interpolation.h"

#include "keiko/render/lighting/interpolation_test.h"
#include "keiko/render/lighting/light_samples.h"

#include <algorithm>
#include <utility>

namespace keiko {
namespace {

/// Pixels a side of the largest squares that are lit from a few places. Shadows narrower than half
/// of it may be missed on curved surfaces and where the light is partly hidden anyway, those of
/// less than two pixels anywhere.
constexpr int largest_square = 16;
/// Pixels a side of squares that consist of their corners and middles only.
constexpr int all_asked = 2;
/// Share of the remaining error for lights interpolated over one size of squares. The rest is for
/// smaller squares, beside the edges of shadows.
constexpr double share_of_a_size = 0.5;

class Interpolation {
public:
    Interpolation(const Integrator& integrator, const ShadingGrid& grid,
                  const std::vector<bool>& skipped, double error, std::span<const Rgb> seen)
        : integrator_(integrator),
          grid_(grid),
          skipped_(skipped),
          error_(error),
          lights_(integrator, grid),
          trial_(integrator, grid, seen, error, lights_),
          light_(grid.size()) {}

    /// The light of each place that is not skipped, by its index.
    std::vector<DirectLight> light() {
        const Rectangle all{0, 0, grid_.width() - 1, grid_.height() - 1};
        const Lights& each = integrator_.interpolated_lights();
        light(all, {}, {each, each}, 1);
        return std::move(light_);
    }

private:
    /// Computes the light of a rectangle. `known`: the light of some lights there; `open`: the
    /// others; `left` of the error is still allowed.
    void light(const Rectangle& r, LightPolynomial known, UnresolvedLights open, double left) {
        if (!asks_for_any(r)) return;
        if (open.lit.empty() || r.longest() <= all_asked) return fill(r, known, open);
        const InterpolationTest::Accepted told = tell(r, known, open, left);
        for (const Lights* lights : {&told.parabolas, &told.lines}) {
            open.lit = without(open.lit, *lights);
            open.seen = without(open.seen, *lights);
        }
        open.seen = without(open.seen, told.seen);
        add(without(told.parabolas, told.threatened), Interpolant::parabolas, r, known);
        if (open.lit.empty() && told.lines.empty() && told.threatened.empty())
            return fill(r, known, open);
        for (const Rectangle& quarter : r.quarters()) light(r, quarter, told, known, open, left);
    }
    /// Computes the light of a quarter of a rectangle, with the lights that were accepted over all
    /// of it.
    void light(const Rectangle& r, const Rectangle& quarter,
               const InterpolationTest::Accepted& told, LightPolynomial known,
               UnresolvedLights open, double left) {
        const Lights hidden =
            possibly_occluded_lights(integrator_, grid_, quarter, told.threatened);
        const Lights clear = without(told.threatened, hidden);
        add(common(told.parabolas, clear), Interpolant::parabolas, r, known);
        add(without(told.lines, hidden), Interpolant::lines, quarter, known);
        for (const std::size_t light : without(told.seen, hidden))
            open.linearly_seen.push_back({light, quarter});
        open.lit = united(open.lit, common(hidden, united(told.parabolas, told.lines)));
        open.seen = united(open.seen, hidden);
        light(quarter, known, open, left);
    }
    InterpolationTest::Accepted tell(const Rectangle& r, const LightPolynomial& known,
                                     const UnresolvedLights& open, double& left) {
        if (!(error_ > 0) || r.longest() > largest_square ||
            !grid_.is_smooth(r.x0, r.y0, r.x1, r.y1))
            return {};
        double allowed = left * share_of_a_size;
        const double kept = left - allowed;
        InterpolationTest::Accepted told = trial_.tell(r, known, open, allowed);
        left = kept + allowed;
        return told;
    }
    template <class MakeFit>
    void add(const Lights& lights, const MakeFit& fit, const Rectangle& r,
             LightPolynomial& known) const {
        if (lights.empty()) return;
        known +=
            fit(grid_, r).through([&](const Pixel& p) { return lights_.sum(p.x, p.y, lights); });
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
    void fill(const Rectangle& r, const LightPolynomial& known, const UnresolvedLights& open) {
        for (int y = r.y0; y <= r.y1; ++y)
            for (int x = r.x0; x <= r.x1; ++x) {
                if (!asks_for(x, y)) continue;
                DirectLight& light = light_[grid_.index(x, y)];
                light = known.at(grid_.place({x, y}));
                if (open.lit.empty()) continue;
                find(open, grid_, {x, y}, lights_);
                light += lights_.sum(x, y, open.lit);
            }
    }

    const Integrator& integrator_;
    const ShadingGrid& grid_;
    const std::vector<bool>& skipped_;
    double error_;
    LightSamples lights_;
    InterpolationTest trial_; ///< of the lights
    std::vector<DirectLight> light_;
};

} // namespace

std::vector<DirectLight> light_interpolation(const Integrator& integrator, const ShadingGrid& grid,
                                             std::span<const Rgb> seen,
                                             const std::vector<bool>& skipped, double error) {
    return Interpolation(integrator, grid, skipped, error, seen).light();
}

void add_interpolated_light(const Integrator& integrator, int width,
                            const std::vector<bool>& skipped, double error, SampleBatch& view) {
    const auto height = static_cast<int>(view.samples.size()) / width;
    each_branch(view.points, [&](std::span<const ShadingPoint> points) {
        const ShadingGrid grid(width, height, points);
        std::vector<Rgb> seen;
        for (const PixelSample& sample : view.samples) seen.push_back(sample.luminance);
        const std::vector<DirectLight> light =
            light_interpolation(integrator, grid, seen, skipped, error);
        for (const ShadingPoint& point : points)
            integrator.add_light(point, light[point.sample], view.samples[point.sample]);
    });
}

} // namespace keiko
