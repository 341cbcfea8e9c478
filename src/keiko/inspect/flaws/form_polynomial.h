#pragma once

#include <array>
#include <cstddef>

namespace keiko {

/// Domains of the heights of a form.
enum class FormDomain {
    disc, ///< around the origin
    line  ///< on the x axis; their y does not count
};

/// Number of powers x^i y^j of total degree 0 to `degree`.
constexpr std::size_t powers_to(std::size_t degree) {
    return (degree + 1) * (degree + 2) / 2;
}

/// Total degree of a form.
constexpr std::size_t form_degree = 4;
/// Number of its terms; on a line only the first form_degree + 1 are not 0.
constexpr std::size_t most_terms = powers_to(form_degree);

/// Factors of the powers of a form: of 1; x, y; xx, xy, yy; ... On a line of 1, x, xx, ...
using FormTerms = std::array<double, most_terms>;
/// The powers at a place, in that order: those of the terms, then those of products of two terms.
using FormPowers = std::array<double, powers_to(2 * form_degree)>;

/// The powers at a place.
FormPowers powers_at(double x, double y, FormDomain domain);

/// Number of terms of a form.
constexpr std::size_t term_count(FormDomain domain) {
    return domain == FormDomain::line ? form_degree + 1 : most_terms;
}

/// The form's height at a place.
inline double height(const FormTerms& terms, const FormPowers& powers) {
    double sum = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) sum += terms[i] * powers[i];
    return sum;
}

/// Weighted least squares by Cholesky's decomposition of the normal equations. Many of their
/// entries are the same sum of weighted powers.
class PolynomialFit {
public:
    explicit PolynomialFit(FormDomain domain) : domain_(domain), count_(term_count(domain)) {}

    /// Adds a height over a place.
    void add(const FormPowers& t, double z, double weight) {
        for (std::size_t i = 0; i < t.size(); ++i) sums_[i] += weight * t[i];
        for (std::size_t i = 0; i < right_.size(); ++i) right_[i] += weight * z * t[i];
    }
    /// Decomposes the matrix, after which nothing can be added; false where it is singular.
    bool decompose();
    /// The terms of the heights added. Requires decompose(), as the next one does.
    FormTerms solution() const { return solved(right_); }
    /// Weights of the heights' terms at the origin: the solution for a right side of (1, 0, ...).
    FormTerms at_origin() const { return solved({1}); }

private:
    FormTerms solved(FormTerms t) const;

    FormDomain domain_;
    std::size_t count_;
    FormPowers sums_{};
    std::array<FormTerms, most_terms> matrix_{}; ///< Cholesky's factor, the lower half
    FormTerms right_{};
};

} // namespace keiko
