#include "keiko/inspect/flaws/dent_depth.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko {
namespace {

constexpr std::size_t n = ReferenceForm::term_count;
using Terms = std::array<double, n>;

constexpr std::size_t line_terms = 5;

/// 1; x, y; xx, xy, yy; ... On a line 1, x, xx, ...
Terms powers(double x, double y, BaseDomain domain) {
    Terms t{1};
    if (domain == BaseDomain::line) {
        for (std::size_t k = 1; k < line_terms; ++k) t[k] = t[k - 1] * x;
        return t;
    }
    std::size_t index = 0;
    std::array<double, 5> px{1}, py{1};
    for (std::size_t k = 1; k < 5; ++k) px[k] = px[k - 1] * x, py[k] = py[k - 1] * y;
    for (std::size_t degree = 0; degree < 5; ++degree)
        for (std::size_t k = 0; k <= degree; ++k) t[index++] = px[degree - k] * py[k];
    return t;
}

std::size_t count_of(BaseDomain domain) {
    return domain == BaseDomain::line ? line_terms : n;
}

double dot(const Terms& a, const Terms& b) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += a[i] * b[i];
    return sum;
}

/// The principal curvature at the origin that is larger in size, over a disc of radius 1.
double largest_bend(const Terms& t, BaseDomain domain) {
    if (domain == BaseDomain::line) return 2 * t[2];
    const double mean = t[3] + t[5], half = std::hypot(t[3] - t[5], t[4]);
    return mean + std::copysign(half, mean);
}

/// Weighted least squares by Cholesky's decomposition of the normal equations.
class Fit {
public:
    /// `count`: of the terms, the others are 0.
    explicit Fit(std::size_t count) : count_(count) {}

    void add(const Terms& t, double z, double weight) {
        for (std::size_t i = 0; i < count_; ++i) {
            for (std::size_t j = 0; j <= i; ++j) matrix_[i][j] += weight * t[i] * t[j];
            right_[i] += weight * t[i] * z;
        }
    }
    /// Decomposes the matrix, after which nothing can be added; false where it is singular.
    bool decompose() {
        for (std::size_t i = 0; i < count_; ++i)
            for (std::size_t j = 0; j <= i; ++j) {
                double sum = matrix_[i][j];
                for (std::size_t k = 0; k < j; ++k) sum -= matrix_[i][k] * matrix_[j][k];
                constexpr double singular = 1e-12;
                if (i == j && !(sum > singular * matrix_[i][i])) return false;
                matrix_[i][j] = i == j ? std::sqrt(sum) : sum / matrix_[j][j];
            }
        return true;
    }
    /// The terms of the heights added.
    Terms solution() const { return solved(right_); }
    /// Weights of the heights' terms at the origin: the solution for a right side of (1, 0, ...).
    Terms at_origin() const { return solved({1}); }

private:
    Terms solved(Terms t) const {
        for (std::size_t i = 0; i < count_; ++i) {
            for (std::size_t k = 0; k < i; ++k) t[i] -= matrix_[i][k] * t[k];
            t[i] /= matrix_[i][i];
        }
        for (std::size_t i = count_; i-- > 0;) {
            for (std::size_t k = i + 1; k < count_; ++k) t[i] -= matrix_[k][i] * t[k];
            t[i] /= matrix_[i][i];
        }
        return t;
    }

    std::size_t count_;
    std::array<Terms, n> matrix_{}; ///< the lower half
    Terms right_{};
};

/// Heights over a disc of radius 1, with their terms computed.
struct Place {
    Terms terms;
    double z, weight;
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

class Reweighted {
public:
    Reweighted(std::vector<Place> places, BaseDomain domain)
        : places_(std::move(places)), count_(count_of(domain)) {}

    /// Terms by least squares.
    std::optional<Terms> all() const {
        return solved([](const Place&) { return 1.0; });
    }
    std::optional<Terms> majority() const {
        std::optional<Terms> t = all();
        t = repeated(t, [this](const Terms& last, double spread) { // the smallest sum of distances
            const double least = 1e-3 * spread + smallest;
            return solved([&, least](const Place& place) {
                return 1 / std::max(std::abs(distance(place, last)), least);
            });
        });
        return repeated(t, [this](const Terms& last, double spread) {
            const double reach = biweight_reach(spread);
            return solved([&](const Place& place) { return biweight(place, last, reach); });
        });
    }
    /// ReferenceForm::origin_bound of these terms.
    std::optional<double> origin_bound(const Terms& t) const {
        const double reach = biweight_reach(spread(t));
        const auto fit = weighted([&](const Place& place) { return biweight(place, t, reach); });
        if (!fit) return std::nullopt;
        const Terms origin = fit->at_origin();
        double squares = 0, weights = 0, lebesgue = 0;
        for (const Place& place : places_) {
            const double weight = place.weight * biweight(place, t, reach);
            const double off = distance(place, t);
            squares += weight * off * off, weights += weight;
            lebesgue += weight * std::abs(dot(origin, place.terms));
        }
        constexpr double largest = 1.5; // about the root of the mean square, of smooth deviations
        return (1 + lebesgue) * largest * std::sqrt(squares / weights);
    }

private:
    static constexpr double smallest = 1e-9; ///< mm, about what rounding leaves

    static double biweight_reach(double spread) { return 6 * spread + smallest; }
    static double distance(const Place& place, const Terms& t) {
        return place.z - dot(place.terms, t);
    }
    /// Tukey's biweight.
    static double biweight(const Place& place, const Terms& t, double reach) {
        const double off = distance(place, t) / reach;
        const double share = std::max(0.0, 1 - off * off);
        return share * share;
    }

    /// Improves terms until they hardly change.
    template <class Next>
    std::optional<Terms> repeated(std::optional<Terms> t, const Next& next) const {
        constexpr int rounds = 40;     // the weight of a dent's rim fades slowly
        constexpr double close = 1e-4; // of the spread
        for (int i = 0; i < rounds && t; ++i) {
            const Terms last = *t;
            const double wide = spread(last);
            t = next(last, wide);
            if (t && largest_change(*t, last) < close * wide + smallest / 10) break;
        }
        return t;
    }
    static double largest_change(const Terms& a, const Terms& b) {
        double largest = 0;
        for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
        return largest;
    }
    /// The weighted fit; nullopt if it is singular.
    template <class WeightOf>
    std::optional<Fit> weighted(const WeightOf& weight_of) const {
        Fit fit(count_);
        for (const Place& place : places_)
            fit.add(place.terms, place.z, place.weight * weight_of(place));
        if (!fit.decompose()) return std::nullopt;
        return fit;
    }
    template <class WeightOf>
    std::optional<Terms> solved(const WeightOf& weight_of) const {
        const auto fit = weighted(weight_of);
        if (!fit) return std::nullopt;
        return fit->solution();
    }
    double spread(const Terms& t) const {
        std::vector<double> distances;
        distances.reserve(places_.size());
        for (const Place& place : places_) distances.push_back(std::abs(distance(place, t)));
        return median(std::move(distances));
    }

    std::vector<Place> places_;
    std::size_t count_;
};

} // namespace

std::optional<ReferenceForm> ReferenceForm::fit(std::span<const FormHeight> heights, double reach,
                                                BaseKind kind, BaseDomain domain) {
    std::vector<Place> places;
    for (const FormHeight& h : heights)
        if (std::hypot(h.x, h.y) < reach)
            places.push_back({powers(h.x / reach, h.y / reach, domain), h.z, h.weight});
    if (places.size() < 2 * count_of(domain)) return std::nullopt;
    ReferenceForm base;
    base.reach_ = reach, base.domain_ = domain;
    constexpr int rounds = 4; // levelled heights give the curvature more accurately
    for (int i = 0; kind == BaseKind::bent && i < rounds; ++i) {
        std::vector<Place> levelled = places;
        for (Place& place : levelled) place.z = base.levelled(place.z);
        const auto rough = Reweighted(std::move(levelled), domain).all();
        if (!rough) return std::nullopt;
        base.bend_ = largest_bend(*rough, domain) / (reach * reach);
    }
    for (Place& place : places) place.z = base.levelled(place.z);
    const Reweighted fit(std::move(places), domain);
    const auto terms = fit.majority();
    const auto bound = terms ? fit.origin_bound(*terms) : std::nullopt;
    if (!bound) return std::nullopt;
    base.terms_ = *terms, base.origin_bound_ = *bound;
    return base;
}

double ReferenceForm::offset(const FormHeight& h) const {
    return levelled(h.z) - dot(terms_, powers(h.x / reach_, h.y / reach_, domain_));
}

} // namespace keiko
