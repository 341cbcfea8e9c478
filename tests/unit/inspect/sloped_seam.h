#pragma once

#include "keiko/base/units.h"
#include "keiko/inspect/seams/seam_partition.h"

#include "tests/support/model_builder.h"

#include <array>
#include <cmath>
#include <vector>

namespace keiko::test {

/// The slope of the second sheet along a seam, the tangent of the seam's angle: one cubic after
/// another.
struct SeamSlope {
    struct Span {
        double to = 0;                 ///< mm
        std::array<double, 4> control; ///< of the cubic: degrees whose tangents are taken
    };
    std::vector<Span> spans;

    double length() const { return spans.back().to; }

    /// Degrees, x in mm.
    double angle(double x) const {
        double from = 0;
        std::size_t i = 0;
        while (i + 1 < spans.size() && x > spans[i].to) from = spans[i++].to;
        const double u = (x - from) / (spans[i].to - from), r = 1 - u;
        const double weights[] = {r * r * r, 3 * r * r * u, 3 * r * u * u, u * u * u};
        double slope = 0;
        for (std::size_t k = 0; k < 4; ++k) slope += weights[k] * tangent(spans[i].control[k]);
        return radians_to_degrees(std::atan(slope));
    }
    /// Place where the angle passes a value between two places, to 1e-12 mm.
    double place_of(double degrees, double begin, double end) const {
        const bool above = angle(begin) > degrees;
        for (int i = 0; i < 60; ++i) {
            const double middle = (begin + end) / 2;
            ((angle(middle) > degrees) == above ? begin : end) = middle;
        }
        return begin;
    }

    static double tangent(double degrees) { return std::tan(degrees_to_radians(degrees)); }
};

/// A flat sheet of 50 mm in +y beside one of 50 mm in -y with that slope. The seam runs along x; at
/// `corner` mm it turns by twice `turn` degrees, in the plane.
inline SurfaceModel sloped_sheets(const SeamSlope& slope, double corner = 0, double turn = 0) {
    NurbsSurface flat{3, 1, {0}, {0, 0, 1, 1}, {}}, sloped = flat;
    const double aside = SeamSlope::tangent(turn);
    double from = 0;
    for (const SeamSlope::Span& span : slope.spans) {
        for (std::size_t k = span.to == slope.spans[0].to ? 0 : 1; k < 4; ++k) {
            const double x = from + (span.to - from) * double(k) / 3;
            const Vec3 on(x, -aside * std::abs(x - corner), 0);
            // Across the seam the slope's share is larger by the turn.
            const double down =
                50 * SeamSlope::tangent(span.control[k]) * std::cos(degrees_to_radians(turn));
            for (NurbsSurface* sheet : {&flat, &sloped}) {
                sheet->points.emplace_back(on.x, on.y, on.z, 1);
                const Vec3 far = on + (sheet == &flat ? Vec3(0, 50, 0) : Vec3(0, -50, -down));
                sheet->points.emplace_back(far.x, far.y, far.z, 1);
            }
        }
        for (NurbsSurface* sheet : {&flat, &sloped})
            sheet->knots_u.insert(sheet->knots_u.end(), 3, from);
        from = span.to;
    }
    for (NurbsSurface* sheet : {&flat, &sloped})
        sheet->knots_u.insert(sheet->knots_u.end(), 4, from);
    ModelBuilder builder;
    builder.nurbs(flat);
    builder.nurbs(sloped);
    return builder.build();
}

/// The seam of two sheets along their sides of least v, all along.
inline Seam first_sides() {
    return {{0, 0, natural_side, 0, 1}, {0, 1, natural_side, 0, 1}, std::nullopt};
}

/// The seam of sloped_sheets, ready to be probed.
class SlopedSeam {
public:
    explicit SlopedSeam(const SeamSlope& slope, double corner = 0, double turn = 0)
        : model_(sloped_sheets(slope, corner, turn)), curves_(model_) {
        seams_.push_back(first_sides());
        probes_.emplace_back(curves_, seams_.front());
    }

    const SurfaceModel& model() const { return model_; }
    const BoundaryCurves& curves() const { return curves_; }
    const std::vector<Seam>& seams() const { return seams_; }
    const std::vector<SeamProbe>& probes() const { return probes_; }

private:
    SurfaceModel model_;
    BoundaryCurves curves_;
    std::vector<Seam> seams_;
    std::vector<SeamProbe> probes_;
};

} // namespace keiko::test
