#include "keiko/render/lighting/unshadowed_light.h"

#include "keiko/math/bounds.h"
#include "keiko/math/disjoint_sets.h"
#include "keiko/render/lighting/error_budget.h"
#include "keiko/render/lighting/quadratic_fit.h"
#include "keiko/render/shading/mapped_paint.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

namespace keiko {
namespace {

/// Places of a region whose light is computed: half as many again as the polynomial has terms. Flat
/// regions leave out those of the tilt.
constexpr std::size_t node_count = 3 * std::tuple_size_v<Monomials> / 2;
/// Number of such places where there are lobes: some twice the terms of the position.
constexpr std::size_t lobe_node_count = 12;
/// Distances between normals count this much more than those between positions, from -1 to 1 in a
/// region: the light depends more on where a surface faces than on where it is.
constexpr double tilt_weight = 4;
/// Cosine between the normals of neighbours in a region.
constexpr double least_alike = 0.5;
/// Places with more leverage than this are lit themselves: the nodes do not surround them.
constexpr double most_leverage = 1;
/// Radians that a normal may be off the fit of the nodes' normals, in the allowed relative error of
/// the light.
constexpr double most_bend = 2;
/// Share of the error that is allowed at a node that determines its own light, for rounding.
constexpr double least_own_share = 0.1;
/// Squared distances to nodes that are lit already count this much more.
constexpr double lit_first = 1.5;

using Places = std::vector<std::size_t>; ///< numbers of places, rising
using Chart = std::vector<ChartPlace>;   ///< of the places of a region

/// Sets of neighbouring places of one paint that face about the same way. They may show several
/// surfaces: without shadows, light on a base depends on position and normal alone. Those of a
/// paint with lobes show one smooth surface.
class LitRegions {
public:
    LitRegions(const Integrator& integrator, std::span<const LitPlace> places)
        : integrator_(integrator), places_(places), sets_(places.size()) {
        for (const LitPlace& place : places) {
            width_ = std::max(width_, place.pixel.x + 1);
            height_ = std::max(height_, place.pixel.y + 1);
        }
    }

    std::vector<Places> regions() {
        const std::vector<Places> pixels = by_pixel();
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                const Places& here = pixels[index(x, y)];
                join(here, here);
                if (x + 1 < width_) join(here, pixels[index(x + 1, y)]);
                if (y + 1 < height_) join(here, pixels[index(x, y + 1)]);
            }
        return sets();
    }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    std::vector<Places> by_pixel() const {
        std::vector<Places> pixels(index(0, height_));
        for (std::size_t i = 0; i < places_.size(); ++i)
            pixels[index(places_[i].pixel.x, places_[i].pixel.y)].push_back(i);
        return pixels;
    }
    bool alike(std::size_t i, std::size_t j) const {
        const SurfacePlace &a = places_[i].point->place, &b = places_[j].point->place;
        if (integrator_.has_lobes(*places_[i].point)) return is_same_surface(a, b);
        return a.paint == b.paint && a.normal.dot(b.normal) > least_alike;
    }
    void join(const Places& a, const Places& b) {
        for (const std::size_t i : a)
            for (const std::size_t j : b)
                if (sets_.root(i) != sets_.root(j) && alike(i, j)) sets_.join(i, j);
    }
    std::vector<Places> sets() {
        std::vector<Places> of_root(places_.size());
        for (std::size_t i = 0; i < places_.size(); ++i) of_root[sets_.root(i)].push_back(i);
        std::erase_if(of_root, [](const Places& set) { return set.empty(); });
        return of_root;
    }

    const Integrator& integrator_;
    std::span<const LitPlace> places_;
    DisjointSets sets_;
    int width_ = 0, height_ = 0; ///< px
};

/// Mean direction of the normals of a region, a unit vector.
Vec3 mean_normal(std::span<const LitPlace> places, const Places& region) {
    Vec3 sum(0);
    for (const std::size_t i : region) sum += places[i].point->place.normal;
    return sum.length() > 0 ? sum.normalized() : places[region[0]].point->place.normal;
}

/// A region's places before the plane across the mean of their normals, positions from -1 to 1. No
/// place is tilted unless `tilted`.
Chart chart_of(std::span<const LitPlace> places, const Places& region, bool tilted) {
    const Vec3 mean = mean_normal(places, region);
    const Vec3 beside = std::abs(mean.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 along = mean.cross(beside).normalized(), across = mean.cross(along);
    const auto turned = [&](const Vec3& w) {
        return Vec3(along.dot(w), across.dot(w), mean.dot(w));
    };
    std::vector<Vec3> positions;
    Box3 around;
    for (const std::size_t i : region) {
        positions.push_back(turned(places[i].point->place.position));
        around.extend(positions.back());
    }
    const Vec3 extent = around.extent();
    const double size = std::max({extent.x, extent.y, extent.z}) / 2;
    const double scale = size > 0 ? 1 / size : 1;
    Chart chart;
    for (std::size_t i = 0; i < region.size(); ++i) {
        const Vec3 at = (positions[i] - around.center()) * scale;
        const Vec3 normal = turned(places[region[i]].point->place.normal);
        chart.push_back({{at.x, at.y}, at.z, tilted ? Vec2(normal.x, normal.y) : Vec2(0)});
    }
    return chart;
}

/// Coordinates by which places of a region are near to each other.
using Coordinates = std::array<double, 5>;

Coordinates coordinates(const ChartPlace& place) {
    return {place.at.x, place.at.y, place.height, tilt_weight * place.tilt.x,
            tilt_weight * place.tilt.y};
}

double distance2(const ChartPlace& a, const ChartPlace& b) {
    const Coordinates from = coordinates(a), to = coordinates(b);
    double sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i) sum += (to[i] - from[i]) * (to[i] - from[i]);
    return sum;
}

/// The places of a region on both sides of the middle of the widest of their coordinates.
std::array<Places, 2> halves(const Places& region, const Chart& chart) {
    Coordinates low = coordinates(chart[0]), high = low;
    for (const ChartPlace& place : chart) {
        const Coordinates here = coordinates(place);
        for (std::size_t i = 0; i < here.size(); ++i)
            low[i] = std::min(low[i], here[i]), high[i] = std::max(high[i], here[i]);
    }
    std::size_t widest = 0;
    for (std::size_t i = 1; i < low.size(); ++i)
        if (high[i] - low[i] > high[widest] - low[widest]) widest = i;
    const double middle = (low[widest] + high[widest]) / 2;
    std::array<Places, 2> halves;
    for (std::size_t i = 0; i < region.size(); ++i)
        halves[coordinates(chart[i])[widest] > middle ? 1 : 0].push_back(region[i]);
    return halves;
}

class UnshadowedLight {
public:
    UnshadowedLight(const Integrator& integrator, std::span<const LitPlace> places, double error)
        : integrator_(integrator),
          places_(places),
          error_(error),
          light_(places.size()),
          is_lit_(places.size()) {}

    std::vector<DirectLight> light() {
        for (const Places& region : LitRegions(integrator_, places_).regions()) light(region);
        return std::move(light_);
    }

private:
    void light(const Places& region) {
        const bool has_lobes = integrator_.has_lobes(*places_[region[0]].point);
        const std::size_t count = has_lobes ? lobe_node_count : node_count;
        if (!(error_ > 0) || region.size() <= count || is_uneven(*places_[region[0]].point))
            return light_each(region);
        const Chart chart = chart_of(places_, region, !has_lobes);
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
        light_[place] = integrator_.direct_light(*places_[place].point);
        is_lit_[place] = true;
    }
    /// Lights a region by a fit; false if its nodes, or all other places, deviate from it.
    bool fit(const Places& region, const Chart& chart, std::size_t count) {
        Chart nodes;
        std::vector<DirectLight> lights;
        std::vector<Vec3> normals;
        std::vector<ErrorBudget> budgets;
        const Places chosen = nodes_of(region, chart, count);
        for (const std::size_t node : chosen) {
            light(region[node]);
            nodes.push_back(chart[node]);
            lights.push_back(light_[region[node]]);
            normals.push_back(normal(region[node]));
            const LitPlace& place = places_[region[node]];
            budgets.emplace_back(integrator_, *place.point, place.seen, lights.back(), error_);
        }
        const QuadraticFit fit(nodes);
        const auto fitted = fit.to(std::span<const DirectLight>(lights));
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (!agrees(lights[i], budgets[i], fitted, fit, monomials(nodes[i]))) return false;
        return fill(region, chart, fit, fitted, fit.to(std::span<const Vec3>(normals)),
                    most_bend * least_share(budgets));
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
                light_[region[i]] = fitted.at(powers), fits_any = true;
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
    /// Numbers of places of a region as far from each other as can be, rather of lit ones.
    Places nodes_of(const Places& region, const Chart& chart, std::size_t count) const {
        std::vector<double> apart(region.size(), std::numeric_limits<double>::infinity());
        Places nodes;
        while (nodes.size() < count) {
            std::size_t best = 0;
            double farthest = -1; // as of nodes
            for (std::size_t i = 0; i < region.size(); ++i) {
                if (!nodes.empty())
                    apart[i] = std::min(apart[i], distance2(chart[i], chart[nodes.back()]));
                const double worth = apart[i] * (is_lit_[region[i]] ? lit_first : 1);
                if (worth > farthest) farthest = worth, best = i;
            }
            nodes.push_back(best);
            apart[best] = -1;
        }
        return nodes;
    }

    const Integrator& integrator_;
    std::span<const LitPlace> places_;
    double error_;
    std::vector<DirectLight> light_;
    std::vector<char> is_lit_; ///< whether it is computed
};

} // namespace

std::vector<DirectLight> unshadowed_light(const Integrator& integrator,
                                          std::span<const LitPlace> places, double error) {
    return UnshadowedLight(integrator, places, error).light();
}

} // namespace keiko
