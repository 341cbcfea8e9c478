#pragma once

#include "keiko/inspect/flaws/face_surface.h"

#include "tests/support/model_builder.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

namespace keiko::test {

/// A dent round about a place of a panel, along the panel's normal.
struct RoundDent {
    enum class Profile { square, cube, fourth, cosine };
    Vec2 centre{0};
    double diameter = 0; ///< mm
    double depth = 0;    ///< mm; negative of a bump
    Profile profile = Profile::fourth;

    /// The share of the depth at a distance from the centre.
    double at(double distance) const {
        const double r = 2 * distance / diameter, left = 1 - r * r;
        if (!(left > 0)) return 0;
        switch (profile) {
            case Profile::square:
                return left * left;
            case Profile::cube:
                return left * left * left;
            case Profile::fourth:
                return left * left * left * left;
            case Profile::cosine:
                return (1 + std::cos(std::numbers::pi * r)) / 2;
        }
        return 0;
    }
};

using PanelHeight = std::function<double(double, double)>; ///< of a form over x and y, mm

constexpr double half_panel = 120, panel_step = 4; ///< mm: of the panel, and from knot to knot

/// A panel of uniform bicubic splines, whose control points sample form and dent; two faces, with
/// the seam at about x = `cut`, where that is given.
inline SurfaceModel dented_panel(const PanelHeight& height, const RoundDent& dent,
                                 const std::optional<double>& cut = {}) {
    constexpr int spans = static_cast<int>(2 * half_panel / panel_step), degree = 3;
    const auto form = [&](const Vec2& at) { return Vec3(at.x, at.y, height(at.x, at.y)); };
    const Vec3 middle = form(dent.centre);
    const auto point = [&](int i, int j) {
        const Vec2 at((i - 1) * panel_step - half_panel, (j - 1) * panel_step - half_panel);
        constexpr double h = 1e-3;
        const Vec3 x = form(at + Vec2(h, 0)) - form(at - Vec2(h, 0));
        const Vec3 y = form(at + Vec2(0, h)) - form(at - Vec2(0, h));
        const Vec3 here = form(at);
        const Vec3 p =
            here - x.cross(y).normalized() * (dent.depth * dent.at((here - middle).length()));
        return Vec4(p.x, p.y, p.z, 1);
    };
    const auto knots = [](int begin, int end) {
        std::vector<double> all;
        for (int k = begin - degree; k <= end + degree; ++k) all.push_back(k);
        return all;
    };
    ModelBuilder builder;
    const auto add_face = [&](int begin, int end) {
        NurbsSurface surface{degree, degree, knots(begin, end), knots(0, spans), {}};
        for (int i = begin; i < end + degree; ++i)
            for (int j = 0; j < spans + degree; ++j) surface.points.push_back(point(i, j));
        builder.nurbs(surface);
    };
    const int seam = cut ? static_cast<int>(std::lround((*cut + half_panel) / panel_step)) : spans;
    add_face(0, seam);
    if (seam < spans) add_face(seam, spans);
    return builder.build();
}

/// How deep the dent of a panel is off the same panel without it, along the normal, where it is
/// deepest.
inline double planted_depth(const PanelHeight& height, const RoundDent& dent) {
    RoundDent none = dent;
    none.depth = 0;
    const SurfaceModel with = dented_panel(height, dent), without = dented_panel(height, none);
    const FaceSurface dented(with, 0, 0), clean(without, 0, 0);
    const auto depth = [&](const Vec2& at) {
        const Vec2 place = (at + Vec2(half_panel)) / panel_step;
        const auto a = dented.evaluate(place, 0), b = clean.evaluate(place, 1);
        if (!a || !b) return 0.0;
        return (a->position() - b->position()).dot(b->du().cross(b->dv()).normalized());
    };
    Vec2 deepest = dent.centre;
    for (double step = dent.diameter / 20; step > 1e-3; step /= 2) {
        const Vec2 around = deepest;
        for (int i = -10; i <= 10; ++i)
            for (int j = -10; j <= 10; ++j) {
                const Vec2 at = around + Vec2(i, j) * step;
                if (std::abs(depth(at)) > std::abs(depth(deepest))) deepest = at;
            }
    }
    return std::abs(depth(deepest));
}

} // namespace keiko::test
