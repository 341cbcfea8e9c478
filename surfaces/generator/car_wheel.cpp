#include "car_wheel.h"

#include "car_trims.h"
#include "circle_arc.h"
#include "trimmed_skin.h"

#include <array>
#include <numbers>

namespace keiko::fixtures {
namespace {

/// Radius about the axle and offset from the wheel's outer plane towards the car, in mm.
struct ProfilePoint {
    double radius;
    double inwards;
};

/// A part of the right front wheel: a cubic Bezier profile, turned about the axle by a ring of
/// patches from the angle `start` on (radians, from rearwards upwards).
struct Part {
    const char* name;
    std::array<ProfilePoint, 4> profile;
    double start;
    double sweep_of_patch;
    int patches;
    /// Stands further out where the flank does.
    bool follows_flank;
};

constexpr double kPi = std::numbers::pi;
constexpr Part kRim{"rim", {{{8, 24}, {110, 6}, {190, 12}, {232, 16}}}, 0.0, 2.0 * kPi / 3.0, 3,
                    false};
constexpr Part kTyre{
    "tyre", {{{232, 16}, {296, -10}, {317, 16}, {312, 210}}}, 0.0, 2.0 * kPi / 3.0, 3, false};
/// A bowl over the wheel, so that no daylight shows between tyre and arch.
constexpr Part kLiner{"liner", {{{372, 0}, {354, 260}, {345, 345}, {20, 375}}}, -0.3, kPi + 0.6, 1,
                      true};

/// One patch of a part, on the right of the car (side = 1) or on the left (-1).
Net part_net(const Part& part, int patch, WheelPlace place, double side) {
    constexpr double kOuterPlane = 815.0;
    // In front of and behind the wheel the flank stands out further than above it.
    constexpr double kSwing = 25.0;
    const auto directions =
        circle_arc(part.start + patch * part.sweep_of_patch, part.sweep_of_patch);
    return sample_net(kArcDegree + 1, 4, [&](int i, int j) {
        const gp_XY direction = directions[static_cast<std::size_t>(i)];
        const ProfilePoint point = part.profile[static_cast<std::size_t>(j)];
        const double rearwards = direction.X() * point.radius;
        const double outwards =
            place.flank_slant * rearwards + kSwing * direction.X() * direction.X();
        const double y = kOuterPlane - point.inwards + (part.follows_flank ? outwards : 0.0);
        return gp_XYZ(place.x + rearwards, side * y, place.z + direction.Y() * point.radius);
    });
}

std::vector<NamedFace> part_faces(const Part& part, std::size_t axle, double side,
                                  ShapePool& pool) {
    const Skin skin(part.patches, 1, part.patches > 1,
                    [&](Cell cell) { return part_net(part, cell.column, kWheels[axle], side); });
    const std::string name = std::string(part.name) + (axle == 0 ? "-front" : "-rear") +
                             (side > 0.0 ? "-right" : "-left");
    // du x dv points away from the axle on the right; a liner shows the side that faces it.
    const bool outward = (side > 0.0) != part.follows_flank;
    TrimmedSkin whole(skin, {}, outward, pool);
    return whole.faces({name, {}, [](Cell) { return true; }});
}

} // namespace

std::vector<NamedFace> car_wheels(ShapePool& pool) {
    std::vector<NamedFace> faces;
    for (const double side : {1.0, -1.0})
        for (std::size_t axle = 0; axle < kWheels.size(); ++axle)
            for (const Part& part : {kRim, kTyre, kLiner})
                for (const NamedFace& face : part_faces(part, axle, side, pool))
                    faces.push_back(face);
    return faces;
}

} // namespace keiko::fixtures
