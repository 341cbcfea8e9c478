#include "keiko/render/lighting/quadratic_fit.h"

#include <cmath>
#include <numeric>
#include <utility>

namespace keiko {
namespace {

double dot(std::span<const double> a, std::span<const double> b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

} // namespace

QuadraticFit::QuadraticFit(std::span<const ChartPlace> nodes) {
    for (const ChartPlace& node : nodes) nodes_.push_back(monomials(node));
    constexpr double least_share = 1e-3; // of a term, that no other explains
    for (std::size_t number = 0; number < std::tuple_size_v<Monomials>; ++number) {
        Term term = monomial(number);
        const double whole = std::sqrt(dot(term.at_nodes, term.at_nodes));
        for (const Term& other : basis_) {
            const double common = dot(term.at_nodes, other.at_nodes);
            for (std::size_t i = 0; i < nodes_.size(); ++i)
                term.at_nodes[i] -= common * other.at_nodes[i];
            for (std::size_t i = 0; i < term.factors.size(); ++i)
                term.factors[i] -= common * other.factors[i];
        }
        const double length = std::sqrt(dot(term.at_nodes, term.at_nodes));
        if (!(length > least_share * whole)) continue;
        for (double& value : term.at_nodes) value /= length;
        for (double& factor : term.factors) factor /= length;
        basis_.push_back(std::move(term));
    }
}

QuadraticFit::Term QuadraticFit::monomial(std::size_t number) const {
    Term term;
    term.factors[number] = 1;
    for (const Monomials& node : nodes_) term.at_nodes.push_back(node[number]);
    return term;
}

double QuadraticFit::leverage(const Monomials& powers) const {
    double sum = 0;
    for (const Term& term : basis_) {
        const double value = dot(term.factors, powers);
        sum += value * value;
    }
    return sum;
}

} // namespace keiko
