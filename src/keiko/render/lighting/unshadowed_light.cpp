#include "keiko/render/lighting/unshadowed_light.h"

#include "keiko/math/bounds.h"
#include "keiko/math/disjoint_sets.h"
#include "keiko/render/lighting/error_budget.h"
#include "keiko/render/lighting/quadratic_fit.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

namespace keiko {
namespace {

/// Places of a region whose light is computed: twice the terms of the polynomial, so that each is
/// tested by as many as determine it.
constexpr std::size_t node_count = 2 * std::tuple_size_v<Monomials>;
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

/// Sets of neighbouring places that show one smooth surface.
class SmoothRegions {
public:
    explicit SmoothRegions(std::span<const LitPlace> places)
        : places_(places), sets_(places.size()) {
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
    void join(const Places& a, const Places& b) {
        for (const std::size_t i : a)
            for (const std::size_t j : b)
                if (sets_.root(i) != sets_.root(j) &&
                    is_same_surface(places_[i].point->place, places_[j].point->place))
                    sets_.join(i, j);
    }
    std::vector<Places> sets() {
        std::vector<Places> of_root(places_.size());
        for (std::size_t i = 0; i < places_.size(); ++i) of_root[sets_.root(i)].push_back(i);
        std::erase_if(of_root, [](const Places& set) { return set.empty(); });
        return of_root;
    }

    std::span<const LitPlace> places_;
    DisjointSets sets_;
    int width_ = 0, height_ = 0; ///< px
};

/// Positions of a region's places on the plane across the mean of their normals, -1 to 1.
std::vector<Vec2> chart_of(std::span<const LitPlace> places, const Places& region) {
    const Vec3 first = places[region[0]].point->place.normal;
    Vec3 sum(0);
    for (const std::size_t i : region) {
        const Vec3& normal = places[i].point->place.normal;
        sum += normal.dot(first) < 0 ? -normal : normal;
    }
    const Vec3 mean = sum.length() > 0 ? sum.normalized() : first;
    const Vec3 beside = std::abs(mean.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 along = mean.cross(beside).normalized(), across = mean.cross(along);
    std::vector<Vec2> chart;
    Box2 around;
    for (const std::size_t i : region) {
        const Vec3& position = places[i].point->place.position;
        chart.emplace_back(along.dot(position), across.dot(position));
        around.extend(chart.back());
    }
    const double size = std::max(around.extent().x, around.extent().y) / 2;
    const double scale = size > 0 ? 1 / size : 1;
    for (Vec2& place : chart) place = (place - around.center()) * scale;
    return chart;
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
        for (const Places& region : SmoothRegions(places_).regions()) light(region);
        return std::move(light_);
    }

private:
    void light(const Places& region) {
        if (!(error_ > 0) || region.size() <= node_count) return light_each(region);
        const std::vector<Vec2> chart = chart_of(places_, region);
        if (fit(region, chart)) return;
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
    bool fit(const Places& region, const std::vector<Vec2>& chart) {
        std::vector<Vec2> nodes;
        std::vector<DirectLight> lights;
        std::vector<Vec3> normals;
        std::vector<ErrorBudget> budgets;
        const Places chosen = nodes_of(region, chart);
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
    /// Lights the other places of a region by a fit, and those whose normals are farther than
    /// `most` radians off theirs as a region of their own; false if all are.
    bool fill(const Places& region, const std::vector<Vec2>& chart, const QuadraticFit& fit,
              const Quadratic<DirectLight>& fitted, const Quadratic<Vec3>& fitted_normal,
              double most) {
        Places off;
        for (std::size_t i = 0; i < region.size(); ++i) {
            if (is_lit_[region[i]]) continue;
            const Monomials powers = monomials(chart[i]);
            const double bend = (fitted_normal.at(powers) - normal(region[i])).length();
            if (fit.leverage(powers) <= most_leverage && bend <= most)
                light_[region[i]] = fitted.at(powers);
            else
                off.push_back(region[i]);
        }
        if (off.size() + node_count >= region.size()) return false;
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
    Places nodes_of(const Places& region, const std::vector<Vec2>& chart) const {
        std::vector<double> apart(region.size(), std::numeric_limits<double>::infinity());
        Places nodes;
        while (nodes.size() < node_count) {
            std::size_t best = 0;
            double farthest = -1; // as of nodes
            for (std::size_t i = 0; i < region.size(); ++i) {
                if (!nodes.empty())
                    apart[i] = std::min(apart[i], (chart[i] - chart[nodes.back()]).length2());
                const double worth = apart[i] * (is_lit_[region[i]] ? lit_first : 1);
                if (worth > farthest) farthest = worth, best = i;
            }
            nodes.push_back(best);
            apart[best] = -1;
        }
        return nodes;
    }
    /// The places of a region on both sides of the middle of its chart's longer side.
    static std::array<Places, 2> halves(const Places& region, const std::vector<Vec2>& chart) {
        Box2 around;
        for (const Vec2& place : chart) around.extend(place);
        const int axis = around.extent().x < around.extent().y ? 1 : 0;
        std::array<Places, 2> halves;
        for (std::size_t i = 0; i < region.size(); ++i)
            halves[chart[i][axis] > around.center()[axis] ? 1 : 0].push_back(region[i]);
        return halves;
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
