#include "car_truths.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace keiko::fixtures {
namespace {

double largest_deviation(const CarTrims& trims) {
    double largest = 0.0;
    const auto take = [&](const TrimCurve& curve) {
        for (const TrimPiece& piece : curve) largest = std::max(largest, piece.deviation);
    };
    take(trims.greenhouse_foot);
    for (const TrimCurve& arch : trims.wheel_arches) take(arch);
    for (const PanelCurve& panel : trims.body_panels) take(panel.curve);
    for (const PanelCurve& panel : trims.windows) take(panel.curve);
    return largest;
}

/// The distance of an arch from its axle, in side view, that is furthest off.
double arch_radius(const CarTrims& trims) {
    double worst = kArchRadius;
    for (std::size_t k = 0; k < trims.wheel_arches.size(); ++k)
        for (const TrimPiece& piece : trims.wheel_arches[k])
            for (double t = 0.0; t <= 1.0; t += 0.05) {
                const WheelPlace& wheel = kWheels[k % kWheels.size()];
                const gp_XYZ p = point_on(piece, t);
                const double radius = std::hypot(p.X() - wheel.x, p.Z() - wheel.z);
                if (std::abs(radius - kArchRadius) > std::abs(worst - kArchRadius)) worst = radius;
            }
    return worst;
}

gp_XYZ unit_normal(const SkinPoint& point) {
    return point.du.Crossed(point.dv).Normalized();
}

/// The angle in degrees that the greenhouse makes with the body where it is flattest.
double smallest_foot_angle(const Skin& body, const Skin& greenhouse, const CarTrims& trims) {
    double smallest = 180.0;
    for (const TrimPiece& piece : trims.greenhouse_foot) {
        // The body's du x dv points inwards.
        const gp_XYZ below = unit_normal(body.evaluate(piece.uv_poles[0].front())).Reversed();
        const gp_XYZ above = unit_normal(greenhouse.evaluate(piece.uv_poles[1].front()));
        const double angle = std::atan2(below.Crossed(above).Modulus(), below.Dot(above));
        smallest = std::min(smallest, angle * 180.0 / std::numbers::pi);
    }
    return smallest;
}

/// Second derivative by u of a patch at one of its u ends, in mm.
gp_XYZ second_derivative(const Skin& skin, Cell cell, double u, double v) {
    gp_Pnt position;
    gp_Vec du;
    gp_Vec dv;
    gp_Vec duu;
    gp_Vec dvv;
    gp_Vec duv;
    skin.patch(cell)->D2(u, v, position, du, dv, duu, dvv, duv);
    return duu.XYZ();
}

/// Its largest jump over all borders between columns: 0 for a C2 skin.
double second_derivative_jump(const Skin& skin) {
    double largest = 0.0;
    for (int i = skin.closed() ? 0 : 1; i < skin.columns(); ++i)
        for (int row = 0; row < skin.rows(); ++row)
            for (double v = 0.0; v <= 1.0; v += 0.125) {
                const gp_XYZ before = second_derivative(skin, {i - 1, row}, 1.0, v);
                const gp_XYZ after = second_derivative(skin, {i, row}, 0.0, v);
                largest = std::max(largest, (before - after).Modulus());
            }
    return largest;
}

/// How far the body's left half is from the mirror image of its right half.
double asymmetry(const Skin& body) {
    double largest = 0.0;
    for (int i = 0; i < body.columns() / 2; ++i)
        for (int row = 0; row < body.rows(); ++row) {
            const auto& right = body.patch({i, row});
            const auto& left = body.patch({body.columns() - 1 - i, row});
            const int count = right->NbUPoles();
            for (int a = 1; a <= count; ++a)
                for (int b = 1; b <= right->NbVPoles(); ++b) {
                    gp_Pnt image = left->Pole(count + 1 - a, b);
                    image.SetY(-image.Y());
                    largest = std::max(largest, image.Distance(right->Pole(a, b)));
                }
        }
    return largest;
}

/// Length, width and height.
std::array<double, 3> size_of(const std::vector<NamedFace>& faces) {
    Bnd_Box box;
    for (const NamedFace& named : faces) BRepBndLib::AddOptimal(named.face, box, false, false);
    const gp_XYZ size = box.CornerMax().XYZ() - box.CornerMin().XYZ();
    return {size.X(), size.Y(), size.Z()};
}

} // namespace

std::vector<GroundTruth> car_truths(const Skin& body, const Skin& greenhouse, const CarTrims& trims,
                                    const std::vector<NamedFace>& faces) {
    const auto [length, width, height] = size_of(faces);
    return {
        {"faces, each one Bezier patch", "", 185.0, static_cast<double>(faces.size()), 0.0},
        {"length", "mm", 4603.43, length, 0.01},
        {"width", "mm", 1850.85, width, 0.01},
        {"height", "mm", 1267.37, height, 0.01},
        {"body, jump of the second derivative at knots", "mm", 0.0, second_derivative_jump(body),
         1e-9},
        {"greenhouse, the same", "mm", 0.0, second_derivative_jump(greenhouse), 1e-9},
        {"body, left half to mirrored right half", "mm", 0.0, asymmetry(body), 0.0},
        {"radius of the wheel arches in side view", "mm", kArchRadius, arch_radius(trims), 1e-5},
        {"crease at the foot of the greenhouse, smallest angle", "deg", 10.88,
         smallest_foot_angle(body, greenhouse, trims), 0.01},
        {"trim curves to their faces, largest distance", "mm", 0.0, largest_deviation(trims),
         1e-5}};
}

} // namespace keiko::fixtures
