#include "keiko/intersect/hit/reflect_ray.h"

#include "keiko/light/tubes/c_plane_lookup.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace keiko;
using test::OracleRow;

namespace {

/// A mirror of the oracle, parametrised so that its second derivatives are closed forms.
class Mirror {
public:
    explicit Mirror(const OracleRow& row) : kind_(row.text("in.surf")), p_(row.list("in.surf_p")) {}

    /// The first hit of a ray with unit direction.
    Hit hit(const Ray& ray) const {
        return kind_ == "cylinder" ? hit_cylinder(ray) : hit_ellipsoid(ray);
    }

private:
    Hit finish(const Ray& ray, double t, const Vec3& du, const Vec3& dv,
               const SecondDerivatives& second, const Vec3& outward) const {
        Hit hit;
        hit.t = t;
        hit.position = ray.at(t);
        hit.dpdu = du;
        hit.dpdv = dv;
        hit.second = second;
        hit.normal = du.cross(dv).normalized();
        if (hit.normal.dot(outward) < 0) hit.normal = -hit.normal;
        return hit;
    }

    Hit hit_ellipsoid(const Ray& ray) const {
        const Vec3 center(p_[0], p_[1], p_[2]);
        const Vec3 axes = kind_ == "sphere" ? Vec3(p_[3]) : Vec3(p_[3], p_[4], p_[5]);
        const Vec3 o = (ray.origin - center) / axes, d = ray.direction / axes;
        const double t = first_root(d.dot(d), o.dot(d), o.dot(o) - 1);
        const Vec3 q = o + d * t;
        const double latitude = std::asin(q.z), longitude = std::atan2(q.y, q.x);
        const double c = std::cos(latitude), s = std::sin(latitude);
        const double cl = std::cos(longitude), sl = std::sin(longitude);
        const Vec3 du = Vec3(-c * sl, c * cl, 0) * axes, dv = Vec3(-s * cl, -s * sl, c) * axes;
        const SecondDerivatives second{Vec3(-c * cl, -c * sl, 0) * axes,
                                       Vec3(s * sl, -s * cl, 0) * axes,
                                       Vec3(-c * cl, -c * sl, -s) * axes};
        return finish(ray, t, du, dv, second, q / axes);
    }

    Hit hit_cylinder(const Ray& ray) const {
        const Vec3 base(p_[0], p_[1], p_[2]), axis = Vec3(p_[3], p_[4], p_[5]).normalized();
        const double radius = p_[6];
        const auto across = [&](const Vec3& v) { return v - axis * axis.dot(v); };
        const Vec3 o = across(ray.origin - base), d = across(ray.direction);
        const double t = first_root(d.dot(d), o.dot(d), o.dot(o) - radius * radius);
        const Vec3 outward = (o + d * t).normalized();
        return finish(ray, t, axis.cross(outward) * radius, axis,
                      {outward * -radius, Vec3(0), Vec3(0)}, outward);
    }

    static double first_root(double a, double half_b, double c) {
        return (-half_b - std::sqrt(half_b * half_b - a * c)) / a;
    }

    std::string kind_;
    std::vector<double> p_;
};

/// The camera ray of a row: direction F + x Rt + y Up, with its derivatives by x and y.
Ray camera_ray(const OracleRow& row) {
    const Vec3 right = row.unit("in.Rt"), up = row.unit("in.Up");
    const Vec3 d = row.unit("in.F") + right * row.number("in.x") + up * row.number("in.y");
    const double length = d.length();
    Ray ray;
    ray.origin = row.vector("in.E");
    ray.direction = d / length;
    const auto rate = [&](const Vec3& change) {
        return (change - ray.direction * ray.direction.dot(change)) / length;
    };
    ray.differentials = {Vec3(0), Vec3(0), rate(right), rate(up)};
    return ray;
}

} // namespace

TEST(MirrorRay, CarriesTheImageToTheCPlaneWithTheOraclesJacobian) {
    test::WorstError jacobian("jacobian");
    for (const OracleRow& row : test::OracleTable("mirror_jacobian")) {
        const Ray ray = camera_ray(row);
        const Hit hit = Mirror(row).hit(ray);
        const Ray mirrored = reflect_ray(ray, hit);
        EXPECT_LE((mirrored.direction - row.vector("out.Rf")).length(), 1e-12) << row.id();

        CPlane plane;
        plane.origin = row.vector("in.Oc");
        plane.u = row.unit("in.U") * 1000;
        plane.v = row.unit("in.V") * 1000;
        const CPlaneFrame frame(plane);
        const auto met = c_plane_coordinates(frame, mirrored.origin, mirrored.direction);
        ASSERT_TRUE(met) << row.id();
        const double scale = 1 + std::abs(row.number("out.u")) + std::abs(row.number("out.v"));
        EXPECT_NEAR(met->u, row.number("out.u"), 1e-9 * scale) << row.id();
        EXPECT_NEAR(met->v, row.number("out.v"), 1e-9 * scale) << row.id();

        const Footprint f = footprint_on(frame, *met, *mirrored.differentials);
        jacobian.compare(row, f.dx.x, row.number("out.du_dx"), 1e-8);
        jacobian.compare(row, f.dy.x, row.number("out.du_dy"), 1e-8);
        jacobian.compare(row, f.dx.y, row.number("out.dv_dx"), 1e-8);
        jacobian.compare(row, f.dy.y, row.number("out.dv_dy"), 1e-8);
    }
}

TEST(MirrorRay, HasDifferentialsOnlyWhereTheTangentsTellThem) {
    // A paraboloid z = c (x^2 + y^2) / 2 at its viewpoint, its parameter lines at a small angle.
    constexpr double c = 0.2;
    for (const double angle : {1e-3, 1e-5, 1e-7}) {
        Hit hit;
        hit.t = 10;
        hit.normal = {0, 0, 1};
        hit.dpdu = {1, 0, 0};
        hit.dpdv = {1, angle, 0};
        hit.second = SecondDerivatives{{0, 0, c}, {0, 0, c}, {0, 0, c * (1 + angle * angle)}};
        Ray ray{.origin = {0, 0, 10}, .direction = {0, 0, -1}};
        ray.differentials = RayDifferentials{.origin_dx = {1, 0, 0}, .origin_dy = {0, 1, 0}};
        const Ray mirrored = reflect_ray(ray, hit);
        ASSERT_EQ(mirrored.differentials.has_value(), angle > 1e-6) << angle;
        if (!mirrored.differentials) continue;
        EXPECT_LT((mirrored.differentials->direction_dx - Vec3(-2 * c, 0, 0)).length(), 1e-4);
        EXPECT_LT((mirrored.differentials->direction_dy - Vec3(0, -2 * c, 0)).length(), 1e-4);
    }
}

TEST(MirrorRay, ExcludesItsOwnRootAndNeedsNoDifferentials) {
    Hit hit;
    hit.position = {1, 2, 3};
    hit.normal = {0, 0, 1};
    hit.dpdu = {1, 0, 0};
    hit.dpdv = {0, 1, 0};
    hit.root = {4, 5, {{0.25, 0.25}, {0.5, 0.5}}};
    Ray ray;
    ray.direction = Vec3(1, 0, -1).normalized();
    const Ray mirrored = reflect_ray(ray, hit);
    EXPECT_EQ(mirrored.origin, hit.position);
    EXPECT_EQ(mirrored.direction, Vec3(1, 0, 1).normalized());
    ASSERT_TRUE(mirrored.excluded);
    EXPECT_EQ(mirrored.excluded->patch, 5u);
    EXPECT_FALSE(mirrored.differentials);
}
