#include "keiko/render/shading/lamp_places.h"

#include "keiko/render/shading/direct_lighting.h"

#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <utility>
#include <variant>

namespace keiko {
namespace {

/// The middles of the cells of a grid in the segment, rectangle or box of 2, 4 or 8 corners, those
/// of the last coordinate side by side; or the one corner.
std::vector<LampPlace> grid_of(std::vector<Vec3> places) {
    constexpr std::array<std::size_t, 4> cells_a_side{1, 8, 4, 2};
    const std::size_t side =
        cells_a_side.at(static_cast<std::size_t>(std::countr_zero(places.size())));
    for (std::size_t filled = 1; places.size() > filled; filled *= side) {
        std::vector<Vec3> between;
        for (std::size_t group = 0; group < places.size(); group += 2 * filled)
            for (std::size_t cell = 0; cell < side; ++cell) {
                const double share = (static_cast<double>(cell) + 0.5) / static_cast<double>(side);
                for (std::size_t i = group; i < group + filled; ++i)
                    between.push_back(places[i] + (places[i + filled] - places[i]) * share);
            }
        places = std::move(between);
    }
    std::vector<LampPlace> lit;
    lit.reserve(places.size());
    for (const Vec3& place : places) lit.push_back({place, 1});
    return lit;
}

/// 16 places in each triangle of a fan over a polygon, by their solid angles from a point.
std::vector<LampPlace> fan_of(std::span<const Vec3> corners, const Vec3& point) {
    constexpr int side = 4;
    std::vector<LampPlace> lit;
    for (std::size_t c = 1; c + 1 < corners.size(); ++c) {
        const Vec3 u = corners[c] - corners[0], v = corners[c + 1] - corners[0];
        for (int row = 0; row < side; ++row)
            for (int cell = 0; cell < 2 * (side - row) - 1; ++cell) {
                // Cells of a row point to either side in turn.
                const double third = cell % 2 == 0 ? 1 / 3.0 : 2 / 3.0;
                const int column = cell / 2;
                const Vec3 place =
                    corners[0] + u * ((column + third) / side) + v * ((row + third) / side);
                const Vec3 way = place - point;
                const double r = way.length();
                lit.push_back({place, std::abs(u.cross(v).dot(way)) / (r * r * r)});
            }
    }
    return lit;
}

} // namespace

std::vector<LampPlace> lamp_places(const PreparedSource& source, int lamp, const Vec3& point) {
    std::vector<Vec3> corners = lamp_corners(source, lamp, point, TubeModel::preview);
    return std::holds_alternative<SkyLight>(source.kind()) ? fan_of(corners, point)
                                                           : grid_of(std::move(corners));
}

} // namespace keiko
