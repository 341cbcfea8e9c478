#include "keiko/render/lighting/interpolant.h"

#include <cmath>

namespace keiko {

Interpolant::Nodes::Nodes(int first, double begin, int last, double end)
    : size_(begin < end ? 2 : 1), numbers_{first, last, 0}, places_{begin, end, 0} {}

void Interpolant::Nodes::add(int middle, double place) {
    constexpr double least_share = 0.2; // of the distance to either end
    const double way = places_[1] - places_[0];
    if (size_ < 2 || std::min(place - places_[0], places_[1] - place) < least_share * way) return;
    numbers_[2] = middle;
    places_[2] = place;
    size_ = 3;
}

double Interpolant::Nodes::weight(std::size_t i, double place) const {
    double weight = 1;
    for (std::size_t k = 0; k < size_; ++k)
        if (k != i) weight *= (place - places_[k]) / (places_[i] - places_[k]);
    return weight;
}

LightPolynomial::Powers Interpolant::Nodes::powers(std::size_t i) const {
    LightPolynomial::Powers powers{1, 0, 0};
    for (std::size_t k = 0; k < size_; ++k) {
        if (k == i) continue;
        const double scale = 1 / (places_[i] - places_[k]), at = places_[k];
        powers = {-at * powers[0] * scale, (powers[0] - at * powers[1]) * scale,
                  (powers[1] - at * powers[2]) * scale};
    }
    return powers;
}

Interpolant Interpolant::lines(const ShadingGrid& grid, const Rectangle& r) {
    const Vec2 begin = grid.place({r.x0, r.y0}), end = grid.place({r.x1, r.y1});
    return {Nodes(r.x0, begin.x, r.x1, end.x), Nodes(r.y0, begin.y, r.y1, end.y)};
}

Interpolant Interpolant::parabolas(const ShadingGrid& grid, const Rectangle& r) {
    Interpolant fit = lines(grid, r);
    const Vec2 middle = grid.place(r.middle());
    fit.columns_.add(r.middle().x, middle.x);
    fit.rows_.add(r.middle().y, middle.y);
    return fit;
}

Interpolant::Weights Interpolant::weights(const Vec2& place) const {
    Weights weights{};
    for (std::size_t i = 0; i < size(); ++i)
        weights[i] = columns_.weight(i % columns_.size(), place.x) *
                     rows_.weight(i / columns_.size(), place.y);
    return weights;
}

} // namespace keiko
