#include "fixtures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko::fixtures {
namespace {

/// The flat or skew patch between four corners.
Net quad(const gp_XYZ& a, const gp_XYZ& b, const gp_XYZ& c, const gp_XYZ& d) {
    Net net(2, 2);
    net(0, 0) = a, net(1, 0) = b, net(1, 1) = c, net(0, 1) = d;
    return net;
}

double area(const Net& net) {
    const gp_XYZ one = net(1, 0) - net(0, 0), other = net(0, 1) - net(0, 0);
    return one.Crossed(other).Modulus();
}

/// The four sides along x, y or z of a box, without its two ends.
void append_sides(std::vector<Net>& patches, const gp_XYZ& low, const gp_XYZ& high, int axis) {
    const int u = axis % 3 + 1, v = (axis + 1) % 3 + 1;
    const auto corner = [&](bool at_u, bool at_v, bool at_end) {
        gp_XYZ p = at_end ? high : low;
        p.SetCoord(u, (at_u ? high : low).Coord(u));
        p.SetCoord(v, (at_v ? high : low).Coord(v));
        return p;
    };
    constexpr bool around[5][2] = {
        {false, false}, {true, false}, {true, true}, {false, true}, {false, false}};
    for (int i = 0; i < 4; ++i) {
        const auto& a = around[i];
        const auto& b = around[i + 1];
        patches.push_back(quad(corner(a[0], a[1], false), corner(b[0], b[1], false),
                               corner(b[0], b[1], true), corner(a[0], a[1], true)));
    }
}

/// A rectangle of the plane x = at.
Net upright(double at, double y0, double y1, double z0, double z1) {
    return quad({at, y0, z0}, {at, y1, z0}, {at, y1, z1}, {at, y0, z1});
}

void append_box(std::vector<Net>& patches, const gp_XYZ& low, const gp_XYZ& high) {
    append_sides(patches, low, high, 1);
    for (const double x : {low.X(), high.X()})
        patches.push_back(upright(x, low.Y(), high.Y(), low.Z(), high.Z()));
}

/// Corners of a regular polygon across `along`, a direction in the plane y = 0.
std::vector<gp_XYZ> polygon(const gp_XYZ& middle, const gp_XYZ& along, double radius, int corners) {
    const gp_XYZ side(0, 1, 0), up = along.Normalized().Crossed(side);
    std::vector<gp_XYZ> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / corners;
        points.push_back(middle + side * (radius * std::cos(angle)) +
                         up * (radius * std::sin(angle)));
    }
    return points;
}

/// Eight flat sides between two octagons.
void append_tube(std::vector<Net>& patches, const gp_XYZ& from, double from_radius,
                 const gp_XYZ& to, double to_radius) {
    constexpr int sides = 8;
    const std::vector<gp_XYZ> a = polygon(from, to - from, from_radius, sides);
    const std::vector<gp_XYZ> b = polygon(to, to - from, to_radius, sides);
    for (std::size_t i = 0; i < sides; ++i) {
        const std::size_t next = (i + 1) % sides;
        patches.push_back(quad(a[i], a[next], b[next], b[i]));
    }
}

constexpr double kHalfWidth = 6000, kHeight = 4500, kThickness = 300;
constexpr double kWindowWidth = 1500, kSill = 900, kLintel = 3900;
constexpr double kWindowMiddles[] = {-4200, -1400, 1400, 4200};

/// One face of the wall: piers as high as it, and what is below and above each window.
void append_wall_face(std::vector<Net>& patches, double x) {
    double pier = -kHalfWidth;
    for (const double middle : kWindowMiddles) {
        const double left = middle - kWindowWidth / 2, right = middle + kWindowWidth / 2;
        patches.push_back(upright(x, pier, left, 0, kHeight));
        patches.push_back(upright(x, left, right, 0, kSill));
        patches.push_back(upright(x, left, right, kLintel, kHeight));
        pier = right;
    }
    patches.push_back(upright(x, pier, kHalfWidth, 0, kHeight));
}

/// One bar upright and two across, in the middle of the wall.
void append_bars(std::vector<Net>& patches, double middle) {
    constexpr double half_bar = 35, x = kThickness / 2;
    append_sides(patches, {x - half_bar, middle - half_bar, kSill},
                 {x + half_bar, middle + half_bar, kLintel}, 3);
    for (const double share : {1.0 / 3, 2.0 / 3}) {
        const double z = kSill + share * (kLintel - kSill);
        append_sides(patches, {x - half_bar, middle - kWindowWidth / 2, z - half_bar},
                     {x + half_bar, middle + kWindowWidth / 2, z + half_bar}, 2);
    }
}

double area_at(const std::vector<Net>& patches, double x) {
    double sum = 0;
    for (const Net& net : patches)
        if (net(0, 0).X() == x && net(1, 1).X() == x && net(1, 0).X() == x) sum += area(net);
    return sum;
}

double highest(const std::vector<Net>& patches) {
    double z = 0;
    for (const Net& net : patches)
        for (const int i : {0, 1})
            for (const int j : {0, 1}) z = std::max(z, net(i, j).Z());
    return z;
}

} // namespace

BptFixture facade() {
    BptFixture fixture{"facade.bpt", {}, {}};
    std::vector<Net>& patches = fixture.patches;
    for (const double x : {0.0, kThickness}) append_wall_face(patches, x);
    append_sides(patches, {0, -kHalfWidth, 0}, {kThickness, kHalfWidth, kHeight}, 1);
    for (const double middle : kWindowMiddles) {
        append_sides(patches, {0, middle - kWindowWidth / 2, kSill},
                     {kThickness, middle + kWindowWidth / 2, kLintel}, 1);
        append_bars(patches, middle);
    }
    fixture.truths = {{"patches", "", 94, static_cast<double>(patches.size()), 0},
                      {"area of the front", "mm^2", 36e6, area_at(patches, 0), 1e-6}};
    return fixture;
}

BptFixture wall() {
    BptFixture fixture{"wall.bpt", {}, {}};
    append_box(fixture.patches, {0, -4000, 0}, {200, 4000, 4000});
    fixture.truths = {{"patches", "", 6, static_cast<double>(fixture.patches.size()), 0},
                      {"area of the front", "mm^2", 32e6, area_at(fixture.patches, 0), 1e-6}};
    return fixture;
}

BptFixture mast() {
    BptFixture fixture{"mast.bpt", {}, {}};
    append_tube(fixture.patches, {0, 0, 0}, 95, {0, 0, 7700}, 60);
    append_tube(fixture.patches, {0, 0, 7600}, 45, {1450, 0, 7950}, 40);
    append_box(fixture.patches, {1400, -150, 7900}, {2100, 150, 8000});
    fixture.truths = {{"patches", "", 22, static_cast<double>(fixture.patches.size()), 0},
                      {"highest", "mm", 8000, highest(fixture.patches), 0}};
    return fixture;
}

BptFixture workshop_bay() {
    BptFixture fixture{"workshop-bay.bpt", {}, {}};
    append_box(fixture.patches, {-200, 6000, 0}, {8200, 6200, 3200});
    append_box(fixture.patches, {8000, 0, 0}, {8200, 6000, 3200});
    append_box(fixture.patches, {6900, 5400, 0}, {7900, 5990, 2000});
    fixture.truths = {{"patches", "", 18, static_cast<double>(fixture.patches.size()), 0},
                      {"highest", "mm", 3200, highest(fixture.patches), 0}};
    return fixture;
}

BptFixture workbench() {
    constexpr double half_length = 1300, half_depth = 625, leg = 80;
    BptFixture fixture{"workbench.bpt", {}, {}};
    append_box(fixture.patches, {-half_length, -half_depth, 840}, {half_length, half_depth, 900});
    append_box(fixture.patches, {-half_length + leg, -half_depth + leg, 240},
               {half_length - leg, half_depth - leg, 270});
    for (const double x : {-half_length, half_length - leg})
        for (const double y : {-half_depth, half_depth - leg})
            append_sides(fixture.patches, {x, y, 0}, {x + leg, y + leg, 840}, 3);
    fixture.truths = {{"patches", "", 28, static_cast<double>(fixture.patches.size()), 0},
                      {"highest", "mm", 900, highest(fixture.patches), 0}};
    return fixture;
}

} // namespace keiko::fixtures
