#include "keiko/placement/hit_histogram.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

constexpr double tail = 0.005; ///< share left out at each end of the range
constexpr double margin = 0.1; ///< relative width added to the rest of the range

/// Values below which `low` and 1 - `low` of the weight lies.
std::pair<double, double> quantiles(std::vector<std::pair<double, double>> values, double low) {
    std::sort(values.begin(), values.end());
    double total = 0;
    for (const auto& [value, weight] : values) total += weight;
    double sum = 0;
    std::pair<double, double> found{values.front().first, values.back().first};
    bool below = true;
    for (const auto& [value, weight] : values) {
        sum += weight;
        if (below && sum >= low * total) found.first = value, below = false;
        if (sum >= (1 - low) * total) {
            found.second = value;
            break;
        }
    }
    return found;
}

Box2 quantile_range(std::span<const WeightedPlace> places) {
    Box2 range;
    if (places.empty()) return {Vec2(0), Vec2(1)};
    for (unsigned axis = 0; axis < 2; ++axis) {
        std::vector<std::pair<double, double>> values;
        values.reserve(places.size());
        for (const WeightedPlace& p : places) values.emplace_back(p.place[axis], p.weight);
        const auto [low, high] = quantiles(std::move(values), tail);
        const double least = 1e-9 * (1 + std::abs(low)); // all at one place
        const double grow = std::max(margin / 2 * (high - low), least);
        range.lower[axis] = low - grow;
        range.upper[axis] = high + grow;
    }
    return range;
}

/// Sums over rectangles of cells in constant time [Crow1984].
class SummedArea {
public:
    explicit SummedArea(const HitHistogram& h) : width_(h.width()) {
        sums_.assign(index(width_, h.height()) + 1, 0);
        for (int v = 0; v < h.height(); ++v)
            for (int u = 0; u < width_; ++u)
                sum(u + 1, v + 1) = h.at(u, v) + sum(u, v + 1) + sum(u + 1, v) - sum(u, v);
    }
    /// Weight of the cells u0 <= u < u1, v0 <= v < v1.
    double over(int u0, int u1, int v0, int v1) const {
        return sum(u1, v1) - sum(u0, v1) - sum(u1, v0) + sum(u0, v0);
    }

private:
    std::size_t index(int u, int v) const {
        const int place = v * (width_ + 1) + u;
        return static_cast<std::size_t>(place);
    }
    double& sum(int u, int v) { return sums_[index(u, v)]; }
    double sum(int u, int v) const { return sums_[index(u, v)]; }

    int width_;
    std::vector<double> sums_;
};

/// A rectangle of cells that shrinks from its borders.
struct CellWindow {
    int u0, u1, v0, v1; ///< u0 <= u < u1

    double area() const { return static_cast<double>(u1 - u0) * (v1 - v0); }
    double content(const SummedArea& sums) const { return sums.over(u0, u1, v0, v1); }
    std::array<CellWindow, 4> smaller() const {
        return {{{u0 + 1, u1, v0, v1},
                 {u0, u1 - 1, v0, v1},
                 {u0, u1, v0 + 1, v1},
                 {u0, u1, v0, v1 - 1}}};
    }
};

/// The smaller window that loses the least weight per area and keeps `least`, or the same window.
CellWindow shrunk(const CellWindow& window, const SummedArea& sums, double least) {
    CellWindow best = window;
    double lowest = 0;
    for (const CellWindow& next : window.smaller()) {
        if (next.area() <= 0 || !(next.content(sums) >= least)) continue;
        const double density =
            (window.content(sums) - next.content(sums)) / (window.area() - next.area());
        if (best.area() == window.area() || density < lowest) best = next, lowest = density;
    }
    return best;
}

} // namespace

HitHistogram::HitHistogram(std::span<const WeightedPlace> places, int cells)
    : HitHistogram(places, cells, quantile_range(places)) {}

HitHistogram::HitHistogram(std::span<const WeightedPlace> places, int cells, const Box2& range)
    : range_(range),
      cells_(cells),
      weights_(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells)) {
    const Vec2 scale = Vec2(cells) / range_.extent();
    for (const WeightedPlace& p : places) {
        total_ += p.weight;
        if (!range_.contains(p.place)) continue;
        const Vec2 cell = (p.place - range_.lower) * scale;
        weights_[index(std::min(static_cast<int>(cell.x), cells - 1),
                       std::min(static_cast<int>(cell.y), cells - 1))] += p.weight;
    }
}

HitHistogram HitHistogram::smoothed() const {
    HitHistogram result = *this;
    const auto inside = [this](int i) { return std::clamp(i, 0, cells_ - 1); };
    for (int v = 0; v < cells_; ++v)
        for (int u = 0; u < cells_; ++u) {
            double sum = 0;
            for (int dv = -1; dv <= 1; ++dv)
                for (int du = -1; du <= 1; ++du)
                    sum += at(inside(u + du), inside(v + dv)) * (2 - std::abs(du)) *
                           (2 - std::abs(dv));
            result.weights_[index(u, v)] = sum / 16;
        }
    return result;
}

std::vector<Box2> HitHistogram::rectangles(std::span<const double> shares) const {
    const SummedArea sums(*this);
    const Vec2 cell = range_.extent() / Vec2(cells_);
    CellWindow window{0, cells_, 0, cells_};
    std::vector<Box2> found;
    for (const double share : shares) {
        for (;;) {
            const CellWindow next = shrunk(window, sums, share * total_);
            if (next.area() == window.area()) break;
            window = next;
        }
        found.push_back({range_.lower + cell * Vec2(window.u0, window.v0),
                         range_.lower + cell * Vec2(window.u1, window.v1)});
    }
    return found;
}

} // namespace keiko
