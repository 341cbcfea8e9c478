#include "keiko/render/interpolated_light.h"

#include "keiko/render/spot_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

/// Pixels a side of the largest squares that are lit from nine places: shadows narrower than half
/// of it may be missed.
constexpr int largest_square = 8;

/// A rectangle of pixels, its last column and row with it.
struct Rectangle {
    int x0, y0, x1, y1;

    int middle_x() const { return (x0 + x1) / 2; }
    int middle_y() const { return (y0 + y1) / 2; }
    bool is_small() const { return x1 - x0 <= 1 && y1 - y0 <= 1; }
    bool is_large() const { return std::max(x1 - x0, y1 - y0) > largest_square; }
};

/// The four parts around the middle, which share its column and row.
std::array<Rectangle, 4> quarters(const Rectangle& r) {
    const int x = r.middle_x(), y = r.middle_y();
    return {{{r.x0, r.y0, x, y}, {x, r.y0, r.x1, y}, {r.x0, y, x, r.y1}, {x, y, r.x1, r.y1}}};
}

/// How far a place lies from `begin` to `end`, 0 to 1.
double share(int begin, int end, int at) {
    return end > begin ? static_cast<double>(at - begin) / (end - begin) : 0;
}

class Interpolation {
public:
    Interpolation(const Integrator& integrator, const SpotGrid& grid, double error,
                  std::span<const EyeSample> samples)
        : integrator_(integrator),
          grid_(grid),
          error_(error),
          samples_(samples),
          exact_(samples.size()),
          between_(samples.size()) {}

    void light(const Rectangle& r) {
        if (error_ > 0 && !r.is_small() && !r.is_large() &&
            grid_.is_smooth(r.x0, r.y0, r.x1, r.y1) && is_linear(r)) {
            for (const Rectangle& quarter : quarters(r)) fill(quarter);
        } else if (r.is_small()) {
            for (int y = r.y0; y <= r.y1; ++y)
                for (int x = r.x0; x <= r.x1; ++x)
                    if (grid_.at(x, y)) exact(x, y);
        } else {
            for (const Rectangle& quarter : quarters(r)) light(quarter);
        }
    }
    /// On a place that was lit.
    const SpotLight& operator[](std::size_t i) const {
        return exact_[i] ? *exact_[i] : between_[i];
    }

private:
    const SpotLight& exact(int x, int y) {
        auto& known = exact_[grid_.index(x, y)];
        if (!known) known = integrator_.light_on(*grid_.at(x, y));
        return *known;
    }
    /// Between the corners.
    SpotLight linear(const Rectangle& r, int x, int y) {
        const double s = share(r.x0, r.x1, x), t = share(r.y0, r.y1, y);
        const SpotLight upper = exact(r.x0, r.y0) * (1 - s) + exact(r.x1, r.y0) * s;
        const SpotLight lower = exact(r.x0, r.y1) * (1 - s) + exact(r.x1, r.y1) * s;
        return upper * (1 - t) + lower * t;
    }
    /// Whether the quarters may be filled: the corners tell what lies amid them, and the quarters'
    /// corners what lies in them. Two places with nothing in common with the others, since shadows
    /// of a row of lamps are stairs, which look even where places and steps lie alike.
    bool is_linear(const Rectangle& r) {
        for (const int y : {r.y0, r.middle_y(), r.y1})
            for (const int x : {r.x0, r.middle_x(), r.x1})
                if (!fits(r, x, y)) return false;
        constexpr int probed = 6;
        if (std::min(r.x1 - r.x0, r.y1 - r.y0) < probed) return true;
        const auto parts = quarters(r);
        return fits(parts[0], r.x0 + 3, r.y0 + 1) && fits(parts[3], r.x1 - 2, r.y1 - 3);
    }
    bool fits(const Rectangle& r, int x, int y) {
        const LitSpot& spot = *grid_.at(x, y);
        const SpotLight& light = exact(x, y);
        const SpotLight wrong = linear(r, x, y) - light;
        if (std::abs(wrong.incident) > error_ * light.incident) return false;
        const Rgb off = seen_of(spot, wrong);
        const Rgb seen = samples_[spot.sample].luminance + seen_of(spot, light);
        return std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)}) <=
               error_ * max_channel(seen);
    }
    Rgb seen_of(const LitSpot& spot, const SpotLight& light) const {
        return spot.weight * integrator_.luminance(spot, light);
    }
    void fill(const Rectangle& r) {
        for (int y = r.y0; y <= r.y1; ++y)
            for (int x = r.x0; x <= r.x1; ++x) between_[grid_.index(x, y)] = linear(r, x, y);
    }

    const Integrator& integrator_;
    const SpotGrid& grid_;
    double error_;
    std::span<const EyeSample> samples_;
    std::vector<std::optional<SpotLight>> exact_;
    std::vector<SpotLight> between_;
};

} // namespace

void add_interpolated_light(const Integrator& integrator, int width, int height, double error,
                            EyeView& view) {
    each_depth(view.spots, [&](std::span<const LitSpot> spots) {
        const SpotGrid grid(width, height, spots);
        Interpolation light(integrator, grid, error, view.samples);
        light.light({0, 0, width - 1, height - 1});
        for (const LitSpot& spot : spots)
            integrator.add_light(spot, light[spot.sample], view.samples[spot.sample]);
    });
}

} // namespace keiko
