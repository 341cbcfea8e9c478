#include "face_maker.h"
#include "fixtures.h"
#include "skin.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko::fixtures {
namespace {

constexpr int kSixths = 6;
constexpr int kArcPolynomial = 7; ///< degree in which a sixth of a circle is right to 1e-9
constexpr double kTurn = 2.0 * std::numbers::pi;

/// A point of the profile of a body of revolution about the z axis.
struct ProfilePoint {
    double radius;
    double height;
};

/// The patches that an edge of the profile sweeps out.
void add_swept(ProfilePoint from, ProfilePoint to, std::vector<Net>& patches) {
    for (int sixth = 0; sixth < kSixths; ++sixth)
        patches.push_back(polynomial_net(kArcPolynomial, 1, [&](double u, double v) {
            const double angle = kTurn * (sixth + u) / kSixths;
            const double radius = from.radius + (to.radius - from.radius) * v;
            return gp_XYZ(radius * std::cos(angle), radius * std::sin(angle),
                          from.height + (to.height - from.height) * v);
        }));
}

std::vector<Net> swept(const std::vector<ProfilePoint>& profile) {
    std::vector<Net> patches;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i)
        add_swept(profile[i], profile[i + 1], patches);
    return patches;
}

/// Largest distance of the first patches, those of one edge of the profile, from its circle of
/// this radius at its lower end.
double circle_error(const std::vector<Net>& patches, double radius) {
    double largest = 0.0;
    for (int sixth = 0; sixth < kSixths; ++sixth)
        for (double u = 0.0; u <= 1.0; u += 0.0625) {
            const gp_Pnt p =
                bezier_surface(patches[static_cast<std::size_t>(sixth)])->Value(u, 0.0);
            largest = std::max(largest, std::abs(std::hypot(p.X(), p.Y()) - radius));
        }
    return largest;
}

BptFixture revolved(const std::string& file, const std::vector<ProfilePoint>& profile) {
    BptFixture fixture{file, swept(profile), {}};
    const double radius = profile.front().radius;
    fixture.truths = {{"circle error", "mm", 0.0, circle_error(fixture.patches, radius), 1e-6}};
    return fixture;
}

constexpr double kPond = 400.0; ///< half the side of the water

double ripple(double x, double y, double wavelength, double angle, double phase) {
    const double along = x * std::cos(angle) + y * std::sin(angle);
    return std::sin(kTurn * along / wavelength + phase);
}

/// Waves of three lengths in directions that are no multiples of each other.
double water_height(double x, double y) {
    return 3.0 * ripple(x, y, 310.0, 0.4, 0.3) + 1.6 * ripple(x, y, 170.0, 1.9, 1.1) +
           0.7 * ripple(x, y, 97.0, 2.7, 2.0);
}

} // namespace

BptFixture ring() {
    constexpr double inner = 100.0, outer = 104.0, height = 45.0;
    return revolved("ring.bpt", {{inner, 0.0}, {inner, height}, {outer, height}, {outer, 0.0}});
}

BptFixture water_glass() {
    constexpr double foot = 31.0, rim = 38.0, height = 110.0;
    return revolved("water-glass.bpt", {{foot, 0.0}, {rim, height}, {0.0, height}});
}

BptFixture ripples() {
    constexpr int cells = 12, degree = 6;
    constexpr double cell = 2.0 * kPond / cells;
    BptFixture fixture{"ripples.bpt", {}, {}};
    double largest = 0.0;
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
            const double x0 = -kPond + cell * i, y0 = -kPond + cell * j;
            fixture.patches.push_back(polynomial_net(degree, degree, [&](double u, double v) {
                const double x = x0 + cell * u, y = y0 + cell * v;
                return gp_XYZ(x, y, water_height(x, y));
            }));
            const gp_Pnt p = bezier_surface(fixture.patches.back())->Value(0.3, 0.4);
            largest = std::max(largest, std::abs(p.Z() - water_height(p.X(), p.Y())));
        }
    fixture.truths = {{"height error", "mm", 0.0, largest, 1e-3}};
    return fixture;
}

} // namespace keiko::fixtures
