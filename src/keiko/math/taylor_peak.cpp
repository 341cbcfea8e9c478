#include "keiko/math/taylor_peak.h"

#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// The quadratic part of a model, and the highest place of it that was looked at.
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

    /// Of slope t + square t^2 along a side.
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
        // where that top is cannot be told.
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

} // namespace keiko
