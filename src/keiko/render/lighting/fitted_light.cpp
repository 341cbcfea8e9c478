#include "keiko/render/lighting/fitted_light.h"

#include "keiko/render/lighting/error_budget.h"
#include "keiko/render/lighting/quadratic_fit.h"
#include "keiko/render/shading/mapped_paint.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace keiko {
namespace {

/// Places of a region whose light is computed: half as many again as the polynomial has terms. Flat
/// regions leave out those of the tilt.
constexpr std::size_t node_count = 3 * std::tuple_size_v<Monomials> / 2;
/// Number of such places where lamps light lobes: some twice the terms of the position.
constexpr std::size_t lobe_node_count = 12;
/// Cosine between the normals of neighbours in a region.
constexpr double least_alike = 0.5;
/// Places with more leverage than this are lit themselves: the nodes do not surround them.
constexpr double most_leverage = 1;
/// Radians that a normal may be off the fit of the nodes' normals, in the allowed relative error of
/// the light.
constexpr double most_bend = 2;
/// Share of the error that is allowed at a node that determines its own light, for rounding.
constexpr double least_own_share = 0.1;
/// Error allowed in the light of an open sky, in that past no body, as a multiple of the error.
constexpr double of_open_sky = 3;
/// Pixels a side of squares; one place beside other surfaces tests a fit in each.
constexpr int check_spacing = 8;

Rgb not_negative(const Rgb& value) {
    return {std::max(value.r, 0.0), std::max(value.g, 0.0), std::max(value.b, 0.0)};
}

/// A fit may undershoot where there is hardly any light.
DirectLight not_negative(const DirectLight& light) {
    return {not_negative(light.illuminance), not_negative(light.lobes),
            std::max(light.incident, 0.0)};
}

class FittedLight {
public:
    FittedLight(const Integrator& integrator, std::span<const LightId> lights,
                std::span<const LitPlace> places, double error)
        : integrator_(integrator),
          lights_(lights),
          outdoors_(!lights.empty() && integrator.is_open_sky(lights[0])),
          places_(places),
          error_(error),
          light_(places.size()),
          budgets_(places.size()),
          is_lit_(places.size()) {}

    std::vector<DirectLight> light() {
        const auto alike = [&](std::size_t i, std::size_t j) { return are_alike(i, j); };
        const std::vector<Places> regions = regions_of(places_, alike);
        if (outdoors_) beside_others_ = beside_others(places_, regions);
        for (const Places& region : regions) light(region);
        return std::move(light_);
    }

private:
    /// Whether the light of a region is fitted by normal too. Lobes of lamps follow the normal too
    /// closely for that, and depend on the eye; those of a sky are as even as it is.
    bool fits_tilt(std::size_t place) const {
        return outdoors_ || !integrator_.has_lobes(*places_[place].point);
    }
    /// Without shadows, light on a base is alike on several surfaces.
    bool are_alike(std::size_t i, std::size_t j) const {
        const SurfacePlace &a = places_[i].point->place, &b = places_[j].point->place;
        if (outdoors_ || !fits_tilt(i)) return is_same_surface(a, b);
        return a.paint == b.paint && a.normal.dot(b.normal) > least_alike;
    }
    void light(const Places& region) {
        const bool tilted = fits_tilt(region[0]);
        const std::size_t count = tilted ? node_count : lobe_node_count;
        if (!(error_ > 0) || region.size() <= count || is_uneven(*places_[region[0]].point))
            return light_each(region);
        const Chart chart = chart_of(places_, region, tilted);
        if (fit(region, chart, count)) return;
        const auto [low, high] = halves(region, chart);
        if (high.empty()) return light_each(region);
        light(low);
        light(high);
    }
    void light_each(const Places& places) {
        for (const std::size_t place : places) light(place);
    }
    void light(std::size_t place) {
        if (is_lit_[place]) return;
        light_[place] = integrator_.direct_light(*places_[place].point, lights_);
        is_lit_[place] = true;
    }
    /// Lights a region by a fit; false if its nodes, or all other places, deviate from it.
    bool fit(const Places& region, const Chart& chart, std::size_t count) {
        Chart nodes;
        std::vector<DirectLight> lights;
        std::vector<Vec3> normals;
        std::vector<ErrorBudget> budgets;
        for (const std::size_t node : spread_places(chart, count, lit_in(region))) {
            light(region[node]);
            nodes.push_back(chart[node]);
            lights.push_back(light_[region[node]]);
            normals.push_back(normal(region[node]));
            budgets.push_back(budget_at(region[node]));
        }
        const QuadraticFit fit(nodes);
        const auto fitted = fit.to(std::span<const DirectLight>(lights));
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (!agrees(lights[i], budgets[i], fitted, fit, monomials(nodes[i]))) return false;
        if (!holds_beside_others(region, chart, fitted)) return false;
        return fill(region, chart, fit, fitted, fit.to(std::span<const Vec3>(normals)),
                    most_bend * least_share(budgets));
    }
    /// True if a fit below a sky predicts the light beside other surfaces, which may throw shadows
    /// too short for the nodes: at one place in each square of some pixels.
    bool holds_beside_others(const Places& region, const Chart& chart,
                             const Quadratic<DirectLight>& fitted) {
        if (!outdoors_) return true;
        std::set<std::pair<int, int>> squares;
        for (std::size_t i = 0; i < region.size(); ++i) {
            const std::size_t place = region[i];
            const Pixel& at = places_[place].pixel;
            if (!beside_others_[place]) continue;
            if (!squares.insert({at.x / check_spacing, at.y / check_spacing}).second) continue;
            light(place);
            if (budget_at(place).used_by(light_[place] - fitted.at(monomials(chart[i]))) > 1)
                return false;
        }
        return true;
    }
    std::vector<bool> lit_in(const Places& region) const {
        std::vector<bool> lit;
        for (const std::size_t place : region) lit.push_back(is_lit_[place]);
        return lit;
    }
    /// Error allowed in the light of a lit place.
    const ErrorBudget& budget_at(std::size_t place) {
        std::optional<ErrorBudget>& budget = budgets_[place];
        if (budget) return *budget;
        const LitPlace& at = places_[place];
        DirectLight besides;
        if (outdoors_)
            besides = integrator_.unoccluded_light(*at.point, lights_) * (of_open_sky * error_);
        return budget.emplace(integrator_, *at.point, at.seen, light_[place], error_, besides);
    }
    /// The smallest share of the light that any of them allows.
    static double least_share(const std::vector<ErrorBudget>& budgets) {
        double least = std::numeric_limits<double>::infinity();
        for (const ErrorBudget& budget : budgets) least = std::min(least, budget.share());
        return least;
    }
    /// Lights the other places of a region by a fit. Those whose normals are farther than `most`
    /// radians off theirs, or to which it extrapolates, form a region of their own. False if none
    /// is lit by the fit.
    bool fill(const Places& region, const Chart& chart, const QuadraticFit& fit,
              const Quadratic<DirectLight>& fitted, const Quadratic<Vec3>& fitted_normal,
              double most) {
        Places off;
        bool fits_any = false;
        for (std::size_t i = 0; i < region.size(); ++i) {
            if (is_lit_[region[i]]) continue;
            const Monomials powers = monomials(chart[i]);
            const double bend = (fitted_normal.at(powers) - normal(region[i])).length();
            if (fit.leverage(powers) <= most_leverage && bend <= most)
                light_[region[i]] = not_negative(fitted.at(powers)), fits_any = true;
            else
                off.push_back(region[i]);
        }
        if (off.empty()) return true;
        if (!fits_any) return false;
        light(off);
        return true;
    }
    const Vec3& normal(std::size_t place) const { return places_[place].point->place.normal; }
    /// True if the other nodes of a fit predict the light of one.
    static bool agrees(const DirectLight& light, const ErrorBudget& allowed,
                       const Quadratic<DirectLight>& fitted, const QuadraticFit& fit,
                       const Monomials& powers) {
        const double share = std::max(1 - fit.leverage(powers), least_own_share);
        return allowed.used_by(light - fitted.at(powers)) <= share;
    }

    const Integrator& integrator_;
    std::span<const LightId> lights_;
    bool outdoors_; ///< the lights are those of open skies, with shadows
    std::span<const LitPlace> places_;
    double error_;
    std::vector<DirectLight> light_;
    std::vector<std::optional<ErrorBudget>> budgets_; ///< as far as they were needed
    std::vector<bool> beside_others_;                 ///< below a sky
    std::vector<bool> is_lit_;                        ///< whether it is computed
};

} // namespace

std::vector<DirectLight> fitted_light(const Integrator& integrator, std::span<const LightId> lights,
                                      std::span<const LitPlace> places, double error) {
    return FittedLight(integrator, lights, places, error).light();
}

} // namespace keiko
