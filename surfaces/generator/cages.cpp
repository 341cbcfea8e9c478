#include "fixtures.h"

#include <cmath>
#include <map>
#include <utility>

namespace keiko::fixtures {
namespace {

/// Edges by the number of faces at each.
std::map<std::pair<int, int>, int> edges(const CageFixture& cage) {
    std::map<std::pair<int, int>, int> uses;
    for (const CageFixture::Face& face : cage.faces)
        for (std::size_t k = 0; k < face.corners.size(); ++k)
            ++uses[std::minmax(face.corners[k], face.corners[(k + 1) % face.corners.size()])];
    return uses;
}

double border_edges(const CageFixture& cage) {
    double count = 0;
    for (const auto& [edge, uses] : edges(cage)) count += uses == 1;
    return count;
}

double euler_characteristic(const CageFixture& cage) {
    return double(cage.vertices.size()) - double(edges(cage).size()) + double(cage.faces.size());
}

} // namespace

CageFixture cage_cube() {
    CageFixture cage{"cage-cube.obj", {}, {}, {}, {}};
    constexpr double half = 50;
    for (const double z : {-half, half})
        for (const auto& [x, y] :
             {std::pair(-half, -half), {half, -half}, {half, half}, {-half, half}})
            cage.vertices.emplace_back(x, y, z);
    cage.faces = {{"bottom", {3, 2, 1, 0}}, {"top", {4, 5, 6, 7}},  {"side", {0, 1, 5, 4}},
                  {"side", {1, 2, 6, 5}},   {"side", {2, 3, 7, 6}}, {"side", {3, 0, 4, 7}}};
    cage.tags = {"crease 5/1/0 4 5 6 7 4 10", "crease 5/1/0 0 1 2 3 0 2.5", "corner 1/1/0 0 1.5"};
    cage.truths = {{"Euler characteristic", "", 2, euler_characteristic(cage), 0}};
    return cage;
}

CageFixture cage_panel() {
    CageFixture cage{"cage-panel.obj", {}, {}, {}, {}};
    constexpr int size = 5;
    constexpr double step = 60, middle = step * (size - 1) / 2;
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) {
            const double x = step * i - middle, y = step * j - middle;
            cage.vertices.emplace_back(x, y, 40 - x * x / 600 - y * y / 900 + x * y / 1500);
        }
    const auto at = [](int i, int j) { return i * size + j; };
    const auto quad = [&](int i, int j) {
        return std::vector{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
    };
    for (int i = 0; i + 1 < size; ++i)
        for (int j = 0; j + 1 < size; ++j)
            if (i == 0 || j == 0 || j == 3 || (i == 3 && j == 1))
                cage.faces.push_back({"skin", quad(i, j)});
    cage.faces.push_back({"hexagon", {at(1, 1), at(2, 1), at(2, 2), at(2, 3), at(1, 3), at(1, 2)}});
    cage.faces.push_back({"triangle", {at(2, 1), at(3, 1), at(3, 2)}});
    cage.faces.push_back({"triangle", {at(2, 1), at(3, 2), at(2, 2)}});
    cage.faces.push_back({"pentagon", {at(2, 2), at(3, 2), at(4, 2), at(3, 3), at(2, 3)}});
    cage.faces.push_back({"triangle", {at(4, 2), at(4, 3), at(3, 3)}});
    cage.tags = {"interpolateboundary 1/0/0 1", "hole 1/0/0 3"};
    cage.truths = {{"Euler characteristic", "", 1, euler_characteristic(cage), 0},
                   {"edges of one face", "", 16, border_edges(cage), 0}};
    return cage;
}

CageFixture cage_icosahedron() {
    CageFixture cage{"cage-icosahedron.obj", {}, {}, {}, {}};
    const double golden = (1 + std::sqrt(5.0)) / 2, scale = 100 / std::sqrt(1 + golden * golden);
    for (const double a : {-scale, scale})
        for (const double b : {-scale * golden, scale * golden}) {
            cage.vertices.emplace_back(0, a, b);
            cage.vertices.emplace_back(a, b, 0);
            cage.vertices.emplace_back(b, 0, a);
        }
    // Three vertices make a face when each is an edge length, 2 scale, from the others.
    const auto& v = cage.vertices;
    const auto near = [&](int a, int b) {
        return (v[static_cast<std::size_t>(a)] - v[static_cast<std::size_t>(b)]).Modulus() <
               2.1 * scale;
    };
    for (int a = 0; a < 12; ++a)
        for (int b = a + 1; b < 12; ++b)
            for (int c = b + 1; c < 12; ++c) {
                if (!near(a, b) || !near(b, c) || !near(c, a)) continue;
                const gp_XYZ &p = v[static_cast<std::size_t>(a)],
                             &q = v[static_cast<std::size_t>(b)],
                             &r = v[static_cast<std::size_t>(c)];
                const bool outward = p.Dot(q.Crossed(r)) > 0;
                cage.faces.push_back({"", outward ? std::vector{a, b, c} : std::vector{a, c, b}});
            }
    cage.tags = {"scheme 0/0/1 loop"};
    cage.truths = {{"Euler characteristic", "", 2, euler_characteristic(cage), 0},
                   {"radius of the cage", "mm", 100, v.front().Modulus(), 1e-12}};
    return cage;
}

} // namespace keiko::fixtures
