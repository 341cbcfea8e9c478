#include "car_greenhouse.h"

#include <array>

namespace keiko::fixtures {
namespace {

constexpr int kColumns = 5;
constexpr int kRows = 5;
constexpr int kDegree = 5;
constexpr int kControls = kColumns + kDegree;

/// A control section across the car: x and z of its middle in mm, its width as a share.
struct Station {
    double x;
    double z;
    double width;
};
constexpr std::array<Station, kControls> kStations{{{-1460, -1040, 1.00},
                                                    {-600, -405, 1.0},
                                                    {260, 213, 1.0},
                                                    {1120, 790, 1.0},
                                                    {1980, 1211, 0.985},
                                                    {2840, 1348, 0.955},
                                                    {3700, 1190, 0.90},
                                                    {4560, 838, 0.82},
                                                    {5420, 422, 0.72},
                                                    {6280, -10, 0.60}}};

/// The right half of the control section: distance from the middle and drop below it, in mm.
struct SectionPoint {
    double y;
    double drop;
};
constexpr std::array<SectionPoint, 5> kSection{
    {{200, 0}, {540, 62}, {775, 480}, {915, 1050}, {1010, 1650}}};

} // namespace

gp_XY mirrored_on_greenhouse(gp_XY uv) {
    return {uv.X(), kRows - uv.Y()};
}

Skin car_greenhouse() {
    const Net net = sample_net(kControls, kRows + kDegree, [](int i, int j) {
        const bool right = j >= 5;
        const SectionPoint section = kSection[static_cast<std::size_t>(right ? j - 5 : 4 - j)];
        const Station station = kStations[static_cast<std::size_t>(i)];
        const double y = section.y * station.width;
        return gp_XYZ(station.x, right ? y : -y, station.z - section.drop);
    });
    return skin_of({kDegree, kDegree, net}, false);
}

} // namespace keiko::fixtures
