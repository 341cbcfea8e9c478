#include "keiko/inspect/smooth_base.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko {
namespace {

constexpr std::size_t n = SmoothBase::term_count;
using Terms = std::array<double, n>;

/// 1; x, y; xx, xy, yy; ...
Terms powers(double x, double y) {
    Terms t;
    std::size_t index = 0;
    std::array<double, 5> px{1}, py{1};
    for (std::size_t k = 1; k < 5; ++k) px[k] = px[k - 1] * x, py[k] = py[k - 1] * y;
    for (std::size_t degree = 0; degree < 5; ++degree)
        for (std::size_t k = 0; k <= degree; ++k) t[index++] = px[degree - k] * py[k];
    return t;
}

double dot(const Terms& a, const Terms& b) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += a[i] * b[i];
    return sum;
}

/// Weighted least squares by Cholesky's decomposition of the normal equations.
class Fit {
public:
    void add(const Terms& t, double z, double weight) {
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j <= i; ++j) matrix_[i][j] += weight * t[i] * t[j];
            right_[i] += weight * t[i] * z;
        }
    }
    std::optional<Terms> solve() {
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j <= i; ++j) {
                double sum = matrix_[i][j];
                for (std::size_t k = 0; k < j; ++k) sum -= matrix_[i][k] * matrix_[j][k];
                constexpr double singular = 1e-12;
                if (i == j && !(sum > singular * matrix_[i][i])) return std::nullopt;
                matrix_[i][j] = i == j ? std::sqrt(sum) : sum / matrix_[j][j];
            }
        Terms t = right_;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = 0; k < i; ++k) t[i] -= matrix_[i][k] * t[k];
            t[i] /= matrix_[i][i];
        }
        for (std::size_t i = n; i-- > 0;) {
            for (std::size_t k = i + 1; k < n; ++k) t[i] -= matrix_[k][i] * t[k];
            t[i] /= matrix_[i][i];
        }
        return t;
    }

private:
    std::array<Terms, n> matrix_{}; ///< the lower half
    Terms right_{};
};

/// Heights over a disc of radius 1, their terms made ready.
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
    explicit Reweighted(std::vector<Place> places) : places_(std::move(places)) {}

    std::optional<Terms> majority() const {
        std::optional<Terms> t = solved([](const Place&) { return 1.0; });
        constexpr int rounds = 40;              // the rim of a dent goes out slowly
        for (int i = 0; i < rounds && t; ++i) { // the smallest sum of distances
            const Terms last = *t;
            const double least = 1e-3 * spread(last) + smallest;
            t = solved([&](const Place& place) {
                return 1 / std::max(std::abs(place.z - dot(place.terms, last)), least);
            });
        }
        for (int i = 0; i < rounds && t; ++i) { // Tukey's biweight
            const Terms last = *t;
            const double reach = 6 * spread(last) + smallest;
            t = solved([&](const Place& place) {
                const double off = (place.z - dot(place.terms, last)) / reach;
                const double share = std::max(0.0, 1 - off * off);
                return share * share;
            });
        }
        return t;
    }

private:
    static constexpr double smallest = 1e-9; ///< mm, about what rounding leaves

    template <class WeightOf>
    std::optional<Terms> solved(const WeightOf& weight_of) const {
        Fit fit;
        for (const Place& place : places_)
            fit.add(place.terms, place.z, place.weight * weight_of(place));
        return fit.solve();
    }
    double spread(const Terms& t) const {
        std::vector<double> distances;
        distances.reserve(places_.size());
        for (const Place& place : places_)
            distances.push_back(std::abs(place.z - dot(place.terms, t)));
        return median(std::move(distances));
    }

    std::vector<Place> places_;
};

} // namespace

std::optional<SmoothBase> SmoothBase::fit(std::span<const Height> heights, double reach) {
    std::vector<Place> places;
    for (const Height& h : heights)
        if (std::hypot(h.x, h.y) < reach)
            places.push_back({powers(h.x / reach, h.y / reach), h.z, h.weight});
    if (places.size() < 2 * n) return std::nullopt;
    const auto terms = Reweighted(std::move(places)).majority();
    if (!terms) return std::nullopt;
    SmoothBase base;
    base.reach_ = reach, base.terms_ = *terms;
    return base;
}

double SmoothBase::height(double x, double y) const {
    return dot(terms_, powers(x / reach_, y / reach_));
}

} // namespace keiko
