#pragma once

#include "keiko/math/polygon.h"
#include "keiko/radiosity/exchange_area.h"
#include "keiko/radiosity/exchange_areas.h"

#include <array>
#include <vector>

namespace keiko::test {

/// Corners of a parallelogram, anticlockwise about u x v.
inline std::vector<Vec3> parallelogram(const Vec3& corner, const Vec3& u, const Vec3& v) {
    return {corner, corner + u, corner + u + v, corner + v};
}

/// The inner faces x0, x1, y0, y1, z0, z1 of a box with a corner in the origin, n x n equal
/// rectangles each, the second axis the faster.
inline std::vector<std::vector<Vec3>> box_room(const Vec3& size, int n = 1) {
    std::vector<std::vector<Vec3>> elements;
    for (unsigned axis = 0; axis < 3; ++axis)
        for (const bool far : {false, true}) {
            const unsigned first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
            Vec3 u(0), v(0), inwards(0);
            u[first] = size[first] / n, v[second] = size[second] / n;
            inwards[axis] = far ? -1 : 1;
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    Vec3 corner = u * i + v * j;
                    if (far) corner[axis] = size[axis];
                    elements.push_back(u.cross(v).dot(inwards) > 0 ? parallelogram(corner, u, v)
                                                                   : parallelogram(corner, v, u));
                }
        }
    return elements;
}

inline double area_of(const std::vector<Vec3>& corners) {
    return polygon_normal(corners).length() / 2;
}

/// Exchange areas of polygons with nothing between them.
inline ExchangeAreas open_exchange(const std::vector<std::vector<Vec3>>& elements) {
    std::vector<double> areas;
    for (const std::vector<Vec3>& corners : elements) areas.push_back(area_of(corners));
    return {areas, [&](std::size_t i, std::size_t j) {
                return i == j ? 0 : direct_exchange_area(elements[i], elements[j]);
            }};
}

} // namespace keiko::test
