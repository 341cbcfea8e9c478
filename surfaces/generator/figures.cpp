#include "fixtures.h"
#include "revolved.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko::fixtures {
namespace {

gp_XYZ in_plane(double x, double z) {
    return {x, 0, z};
}

/// A unit vector of the plane y = 0 that is `degrees` above the x axis.
gp_XYZ upwards(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return in_plane(std::cos(angle), std::sin(angle));
}

/// The wall of the pot up to its rim, its lid and the knob, as one profile.
const std::vector<ProfilePoint> kPot{
    {0, 0},    {25, 0},   {55, 0},   {64, 3},   {82, 10},  {100, 34}, {100, 66}, {100, 98},
    {84, 116}, {68, 126}, {62, 130}, {40, 141}, {22, 144}, {12, 146}, {8, 148},  {8, 152},
    {8, 158},  {17, 158}, {17, 167}, {17, 174}, {9, 178},  {0, 178}};

/// Tea that fills the pot to a little over its middle, 2 mm from the wall.
const std::vector<ProfilePoint> kTea{{0, 3},   {25, 3},  {54, 3},  {62, 6},  {79, 12},
                                     {97, 35}, {97, 66}, {97, 72}, {96, 78}, {95, 84},
                                     {64, 84}, {32, 84}, {0, 84}};

/// A spout that leaves the wall on the side of x > 0.
const std::vector<PipePoint> kSpout{
    {in_plane(88, 48), upwards(110), 30, 24},  {in_plane(125, 55), upwards(115), 24, 20},
    {in_plane(128, 92), upwards(150), 15, 14}, {in_plane(140, 116), upwards(140), 11, 11},
    {in_plane(147, 130), upwards(135), 9, 10}, {in_plane(156, 138), upwards(125), 9, 10},
    {in_plane(166, 141), upwards(115), 10, 10}};

/// A handle on the other side, from the wall below the rim to that above the foot.
const std::vector<PipePoint> kHandle{
    {in_plane(-84, 112), upwards(95), 7, 9},   {in_plane(-130, 122), upwards(100), 7, 9},
    {in_plane(-158, 112), upwards(135), 7, 9}, {in_plane(-158, 84), upwards(180), 7, 9},
    {in_plane(-158, 56), upwards(225), 7, 9},  {in_plane(-135, 38), upwards(240), 7, 9},
    {in_plane(-90, 26), upwards(250), 7, 9}};

/// A figure as of a board game, as tall as a man.
const std::vector<ProfilePoint> kFigure{
    {0, 0},      {90, 0},     {180, 0},    {210, 20},   {250, 50},   {150, 500},
    {140, 800},  {134, 980},  {180, 1080}, {215, 1220}, {250, 1360}, {215, 1440},
    {120, 1470}, {70, 1486},  {60, 1490},  {64, 1510},  {90, 1540},  {118, 1580},
    {118, 1640}, {118, 1710}, {66, 1760},  {0, 1760}};

double highest(const std::vector<Net>& patches) {
    double z = 0;
    for (const Net& net : patches)
        for (int i = 0; i < net.size_u(); ++i)
            for (int j = 0; j < net.size_v(); ++j) z = std::max(z, net(i, j).Z());
    return z;
}

/// Distance from the z axis in the middle of the lower edge of a bicubic patch.
double radius_of_edge(const Net& net) {
    const gp_XYZ p = (net(0, 0) + net(1, 0) * 3 + net(2, 0) * 3 + net(3, 0)) / 8;
    return std::hypot(p.X(), p.Y());
}

GroundTruth count_of(const BptFixture& fixture, double promised) {
    return {"patches", "", promised, static_cast<double>(fixture.patches.size()), 0};
}

} // namespace

BptFixture teapot() {
    BptFixture fixture{"teapot.bpt", {}, {}};
    append_revolved(fixture.patches, kPot);
    append_pipe(fixture.patches, kSpout);
    append_pipe(fixture.patches, kHandle);
    fixture.truths = {count_of(fixture, 44),
                      {"highest", "mm", 178, highest(fixture.patches), 0},
                      {"radius of the belly", "mm", 100, radius_of_edge(fixture.patches[8]), 0.03}};
    return fixture;
}

BptFixture tea() {
    BptFixture fixture{"tea.bpt", {}, {}};
    append_revolved(fixture.patches, kTea);
    fixture.truths = {count_of(fixture, 16), {"highest", "mm", 84, highest(fixture.patches), 0}};
    return fixture;
}

BptFixture figure() {
    BptFixture fixture{"figure.bpt", {}, {}};
    append_revolved(fixture.patches, kFigure);
    fixture.truths = {count_of(fixture, 28), {"highest", "mm", 1760, highest(fixture.patches), 0}};
    return fixture;
}

} // namespace keiko::fixtures
