#include "keiko/inspect/flaws/reference_form.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko {
namespace {

/// The principal curvature at the origin that is larger in size, over a disc of radius 1.
double largest_bend(const FormTerms& t, FormDomain domain) {
    if (domain == FormDomain::line) return 2 * t[2];
    const double mean = t[3] + t[5], half = std::hypot(t[3] - t[5], t[4]);
    return mean + std::copysign(half, mean);
}

/// Height over a disc of radius 1, with the powers of its place.
struct Place {
    FormPowers powers;
    double z, weight;
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

constexpr double smallest = 1e-9; ///< mm, about what rounding leaves

/// Tukey's biweight of a distance, by the spread of all.
class Biweight {
public:
    explicit Biweight(double spread) : reach_(6 * spread + smallest) {}
    double operator()(double distance) const {
        const double off = distance / reach_;
        const double share = std::max(0.0, 1 - off * off);
        return share * share;
    }

private:
    double reach_;
};

/// Terms by least squares of heights that `level` changes; nullopt if they do not determine them.
template <class Level>
std::optional<FormTerms> least_squares(const std::vector<Place>& places, FormDomain domain,
                                       const Level& level) {
    PolynomialFit fit(domain);
    for (const Place& place : places) fit.add(place.powers, level(place.z), place.weight);
    if (!fit.decompose()) return std::nullopt;
    return fit.solution();
}

class Reweighted {
public:
    Reweighted(std::vector<Place> places, FormDomain domain)
        : places_(std::move(places)), domain_(domain) {}

    std::optional<FormTerms> majority() const {
        constexpr double roughly = 1e-2, closely = 1e-4; // of the spread
        auto t = least_squares(places_, domain_, [](double z) { return z; });
        // The smallest sum of distances, whence the biweight begins.
        t = repeated(t, roughly, [](double spread) {
            const double least = 1e-3 * spread + smallest;
            return [least](double off) { return 1 / std::max(std::abs(off), least); };
        });
        return repeated(t, closely, [](double spread) { return Biweight(spread); });
    }
    /// ReferenceForm::origin_bound of these terms.
    std::optional<double> origin_bound(const FormTerms& t) const {
        const std::vector<double> off = distances(t);
        const Biweight weight_of(spread(off));
        const auto fit = weighted(weight_of, off);
        if (!fit) return std::nullopt;
        const FormTerms origin = fit->at_origin();
        double squares = 0, weights = 0, lebesgue = 0;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const double weight = places_[i].weight * weight_of(off[i]);
            squares += weight * off[i] * off[i], weights += weight;
            lebesgue += weight * std::abs(height(origin, places_[i].powers));
        }
        constexpr double largest = 1.5; // about the root of the mean square, of smooth deviations
        return (1 + lebesgue) * largest * std::sqrt(squares / weights);
    }

private:
    static double spread(const std::vector<double>& off) {
        std::vector<double> sizes;
        sizes.reserve(off.size());
        for (const double distance : off) sizes.push_back(std::abs(distance));
        return median(std::move(sizes));
    }

    /// Improves terms until they change by less than a share of the spread. `weights`: the weight
    /// of a distance, by the spread.
    template <class Weights>
    std::optional<FormTerms> repeated(std::optional<FormTerms> t, double share,
                                      const Weights& weights) const {
        constexpr int rounds = 40; // the weight of a dent's rim fades slowly
        for (int i = 0; i < rounds && t; ++i) {
            const FormTerms last = *t;
            const std::vector<double> off = distances(last);
            const double wide = spread(off);
            t = solved(weights(wide), off);
            if (t && largest_change(*t, last) < share * wide + smallest / 10) break;
        }
        return t;
    }
    static double largest_change(const FormTerms& a, const FormTerms& b) {
        double largest = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            largest = std::max(largest, std::abs(a[i] - b[i]));
        return largest;
    }
    /// Distances of the heights from the form, mm.
    std::vector<double> distances(const FormTerms& t) const {
        std::vector<double> off;
        off.reserve(places_.size());
        for (const Place& place : places_) off.push_back(place.z - height(t, place.powers));
        return off;
    }
    /// The fit weighted by the distances; nullopt if it is singular.
    template <class WeightOf>
    std::optional<PolynomialFit> weighted(const WeightOf& weight_of,
                                          const std::vector<double>& off) const {
        PolynomialFit fit(domain_);
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const double weight = places_[i].weight * weight_of(off[i]);
            if (weight > 0) fit.add(places_[i].powers, places_[i].z, weight);
        }
        if (!fit.decompose()) return std::nullopt;
        return fit;
    }
    template <class WeightOf>
    std::optional<FormTerms> solved(const WeightOf& weight_of,
                                    const std::vector<double>& off) const {
        const auto fit = weighted(weight_of, off);
        if (!fit) return std::nullopt;
        return fit->solution();
    }

    std::vector<Place> places_;
    FormDomain domain_;
};

} // namespace

std::optional<ReferenceForm> ReferenceForm::fit(std::span<const FormHeight> heights, double reach,
                                                FormKind kind, FormDomain domain) {
    std::vector<Place> places;
    for (const FormHeight& h : heights)
        if (std::hypot(h.x, h.y) < reach)
            places.push_back({powers_at(h.x / reach, h.y / reach, domain), h.z, h.weight});
    if (places.size() < 2 * term_count(domain)) return std::nullopt;
    ReferenceForm base;
    base.reach_ = reach, base.domain_ = domain;
    constexpr int rounds = 4; // levelled heights give the curvature more accurately
    for (int i = 0; kind == FormKind::bent && i < rounds; ++i) {
        const auto rough =
            least_squares(places, domain, [&](double z) { return base.levelled(z); });
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
    return levelled(h.z) - height(terms_, powers_at(h.x / reach_, h.y / reach_, domain_));
}

} // namespace keiko
