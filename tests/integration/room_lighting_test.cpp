#include "keiko/light/tubes/tube_hit.h"
#include "keiko/light/tubes/tube_lamp.h"
#include "keiko/stream/light_points.h"

#include "tests/support/paths.h"
#include "tests/support/random.h"
#include "tests/unit/stream/cut_text.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

// `keiko illuminance` on the workshop of the gallery: rows of tubes on several planes, past a car,
// a bench and a hood, against rays to many places of each tube.

namespace keiko {
namespace {

Scene workshop() {
    const std::filesystem::path file = test::repository("surfaces/workshop-scene.toml");
    SceneOptions options;
    options.shadows = true;
    return open_scene({&file, 1}, options);
}

/// A place of a tube as its lateral surface shines on a point.
struct TubePlace {
    Vec3 at{0};
    double lux = 0; ///< if it is seen
};

/// The side of a tube that faces a point in cells of equal angle and length, with a random place in
/// each.
std::vector<TubePlace> places_of(const TubeLamp& lamp, const Ray& receiver, test::Random& random) {
    constexpr int along = 200, around = 200;
    const Vec3 axis = (lamp.b - lamp.a).normalized(), from = receiver.origin - lamp.a;
    const Vec3 off = from - axis * from.dot(axis), towards = off.normalized();
    const double radius = lamp.diameter / 2, length = (lamp.b - lamp.a).length();
    const double seen = std::acos(radius / off.length());
    const double cell = length / along * radius * 2 * seen / around;
    std::vector<TubePlace> places;
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            const double phi = seen * (2 * (j + test::uniform(random, 0, 1)) / around - 1);
            const Vec3 out = towards * std::cos(phi) + axis.cross(towards) * std::sin(phi);
            const double x = length * (i + test::uniform(random, 0, 1)) / along;
            const Vec3 at = lamp.a + axis * x + out * radius, to = at - receiver.origin;
            const double cosines = std::max(0.0, receiver.direction.normalized().dot(to)) *
                                   std::max(0.0, -out.dot(to));
            places.push_back(
                {at, luminance(lamp.luminance) * cell * cosines / std::pow(to.length(), 4)});
        }
    return places;
}

/// Rays from the receiver to places at t = 1.
std::vector<Ray> rays_to(const std::vector<TubePlace>& places, const Vec3& from) {
    std::vector<Ray> rays;
    for (const TubePlace& place : places) {
        Ray ray;
        ray.origin = from;
        ray.direction = place.at - from;
        ray.t_min = 1e-7, ray.t_max = 1;
        rays.push_back(ray);
    }
    return rays;
}

/// Illuminance of a receiver by rays to places of its lamps that no body and no other lamp of the
/// row hides.
double lux_by_rays(const Scene& scene, const Ray& receiver, test::Random& random) {
    double lux = 0;
    for (const LightSource& source : scene.rig->sources) {
        const CPlane& row = std::get<CPlane>(source);
        const CPlaneFrame frame(row);
        for (int lamp = 0; lamp < frame.lamps; ++lamp) {
            const std::vector<TubePlace> places =
                places_of(lamp_of(frame, lamp, row.luminance), receiver, random);
            const std::vector<Ray> rays = rays_to(places, receiver.origin);
            const std::vector<bool> hidden = scene.seen().any(rays);
            for (std::size_t i = 0; i < places.size(); ++i) {
                const auto tube = nearest_tube(frame, receiver.origin, rays[i].direction);
                if (!hidden[i] && (!tube || tube->lamp == lamp)) lux += places[i].lux;
            }
        }
    }
    return lux;
}

/// The numbers of a row's last column.
std::vector<double> sums_of(const std::string& rows) {
    std::istringstream lines(rows);
    std::vector<double> sums;
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) sums.push_back(std::stod(line.substr(line.rfind(',') + 1)));
    return sums;
}

TEST(RoomLighting, OfTheWorkshopIsWhatRaysToItsLampsTell) {
    const Scene scene = workshop();
    // In the open, and beside the car among its penumbrae. On the bench beside the hood, on the
    // shelf below, on the floor below its rim, and on a wall in the plane of the bench's lamps.
    const std::string points =
        "4000,700,0,0,0,1\n3000,1250,0,0,0,1\n3000,5330,900,0,0,1\n"
        "4000,4850,270,0,0,1\n3500,4600,0,0,0,1\n8000,3000,1500,-1,0,0\n";
    std::string rows;
    light_points(scene, test::cut_text(points, 1000), [&](std::string_view text) {
        rows += text;
        return true;
    });
    const std::vector<double> lux = sums_of(rows);
    const ParsedRays receivers = rays_of({.text = points}, point_header);
    ASSERT_EQ(lux.size(), receivers.rays.size());
    test::Random random(5);
    for (std::size_t i = 0; i < lux.size(); ++i) {
        const double truth = lux_by_rays(scene, receivers.rays[i], random);
        EXPECT_NEAR(lux[i], truth, 1e-4 * truth) << "point " << i;
    }
}

} // namespace
} // namespace keiko
