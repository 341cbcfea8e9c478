#include "keiko/math/taylor_model.h"

#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// The quadratic part of a model, and its highest place among those that are inspected.
class Summit {
public:
    explicit Summit(const TaylorModel& model) : c_(model.c) {
        for (const double end : {-1.0, 1.0}) {
            for (const double other : {-1.0, 1.0}) look({end, other});
            look_at_vertex(c_[5], c_[2] + c_[4] * end, [&](double y) { return Vec2(end, y); });
            look_at_vertex(c_[3], c_[1] + c_[4] * end, [&](double x) { return Vec2(x, end); });
        }
        look_inside();
    }

    double height() const { return height_; }
    const Vec2& place() const { return place_; }

private:
    void look(const Vec2& p) {
        const double height = c_[0] + c_[1] * p.x + c_[2] * p.y + c_[3] * p.x * p.x +
                              c_[4] * p.x * p.y + c_[5] * p.y * p.y;
        if (height > height_) height_ = height, place_ = p;
    }

    /// Inspects the vertex of slope t + square t^2 along a side, where that is a maximum within it.
    template <class PlaceOf>
    void look_at_vertex(double square, double slope, const PlaceOf& place_of) {
        if (square < 0 && std::abs(slope) < -2 * square) look(place_of(-slope / (2 * square)));
    }

    void look_inside() {
        const double determinant = 4 * c_[3] * c_[5] - c_[4] * c_[4], trace = -(c_[3] + c_[5]);
        if (!(c_[3] < 0 && c_[5] < 0 && determinant > 0)) return;
        const Vec2 top((c_[4] * c_[2] - 2 * c_[5] * c_[1]) / determinant,
                       (c_[4] * c_[1] - 2 * c_[3] * c_[2]) / determinant);
        if (std::abs(top.x) <= 1 && std::abs(top.y) <= 1) look(top);
        // A ridge that is nearly level: its top is hardly above where it leaves the square, but
        // where that top is stays unknown.
        constexpr double ill_conditioned = 1e-6;
        if (determinant < ill_conditioned * trace * trace) height_ += 2 * determinant / trace;
    }

    const std::array<double, TaylorModel::count>& c_;
    double height_ = -std::numeric_limits<double>::infinity();
    Vec2 place_{0};
};

} // namespace

TaylorPeak peak(const TaylorModel& model) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!std::isfinite(model.error)) return {infinity, Vec2(0)};
    const Summit summit(model);
    const double rounding = taylor_rounding::product * (std::abs(model.c[0]) + model.deviation());
    return {summit.height() + model.cubic_part() + model.error + rounding, summit.place()};
}

bool may_vanish(const TaylorModel& model) {
    if (std::abs(model.c[0]) > model.deviation()) return false;
    return !(peak(model.c[0] > 0 ? -model : model).bound < 0);
}

TaylorModel at_x(const TaylorModel& model, double at) {
    const auto& c = model.c;
    TaylorModel line;
    line.c = {c[0] + at * (c[1] + at * (c[3] + at * c[6])),
              0,
              c[2] + at * (c[4] + at * c[7]),
              0,
              0,
              c[5] + at * c[8],
              0,
              0,
              0,
              c[9]};
    line.error = model.error + taylor_rounding::product * (std::abs(c[0]) + model.deviation());
    return line;
}

TaylorModel at_y(const TaylorModel& model, double at) {
    const auto& c = model.c;
    TaylorModel line;
    line.c = {c[0] + at * (c[2] + at * (c[5] + at * c[9])),
              c[1] + at * (c[4] + at * c[8]),
              0,
              c[3] + at * c[7],
              0,
              0,
              c[6],
              0,
              0,
              0};
    line.error = model.error + taylor_rounding::product * (std::abs(c[0]) + model.deviation());
    return line;
}

namespace {

/// f of a model, from f and its derivatives, each over its factorial, at the model's constant; the
/// fourth where it is largest.
TaylorModel composed(const TaylorModel& model, const std::array<double, 5>& f) {
    TaylorModel step(model);
    step.c[0] = 0;
    TaylorModel value = step * (step * (step * f[3] + f[2]) + f[1]) + f[0];
    const double r = model.deviation();
    value.error += r * r * r * r * std::abs(f[4]);
    const double size =
        std::abs(f[0]) + r * (std::abs(f[1]) + r * (std::abs(f[2]) + r * std::abs(f[3])));
    value.error += taylor_rounding::product * (size + value.error);
    return value;
}

/// The model is nowhere less.
double lower_bound(const TaylorModel& model) {
    return -peak(-model).bound;
}

TaylorModel unknown() {
    TaylorModel model;
    model.error = std::numeric_limits<double>::infinity();
    return model;
}

} // namespace

TaylorModel reciprocal(const TaylorModel& model) {
    const double g = model.c[0], low = g > 0 ? lower_bound(model) : lower_bound(-model);
    if (!(low > 0)) return unknown();
    const double f = 1 / g, low2 = low * low;
    return composed(model, {f, -f * f, f * f * f, -f * f * f * f, 1 / (low2 * low2 * low)});
}

TaylorModel sqrt(const TaylorModel& model) {
    const double g = model.c[0], low = lower_bound(model);
    if (!(low > 0)) return unknown();
    const double f = std::sqrt(g);
    return composed(model, {f, 0.5 / f, -0.125 / (g * f), 0.0625 / (g * g * f),
                            5.0 / 128 / (low * low * low * std::sqrt(low))});
}

TaylorModel inverse_cubed_root(const TaylorModel& model) {
    const double g = model.c[0], low = lower_bound(model);
    if (!(low > 0)) return unknown();
    const double f = 1 / (g * std::sqrt(g));
    const double low2 = low * low;
    return composed(model, {f, -1.5 * f / g, 1.875 * f / (g * g), -2.1875 * f / (g * g * g),
                            2.4609375 / (low2 * low2 * low * std::sqrt(low))});
}

} // namespace keiko
