#include "tests/support/shapes.h"

#include <cmath>

namespace keiko::test {
namespace {

constexpr double pi = std::numbers::pi;
const double half_sqrt2 = std::sqrt(0.5);

/// Homogeneous points of the quarter arc of the unit circle that begins at quadrant `q`.
std::vector<Vec3> quarter(int q) {
    const double c[] = {1, 0, -1, 0}, s[] = {0, 1, 0, -1};
    const int a = q % 4, b = (q + 1) % 4;
    return {Vec3(c[a], s[a], 1), Vec3(c[a] + c[b], s[a] + s[b], 1) * half_sqrt2,
            Vec3(c[b], s[b], 1)};
}

ParameterMap angles(double begin) {
    return {ParameterMap::Kind::circular, begin, begin + pi / 2};
}

/// Patch of the surface that a half-plane curve (distance to the axis, height), given by
/// homogeneous points, sweeps over one quarter turn about the z axis.
PatchData swept(const std::vector<Vec3>& profile, int quadrant, const Vec3& center) {
    PatchData patch{2, static_cast<int>(profile.size()) - 1, {}, angles(quadrant * pi / 2), {}};
    for (const Vec3& turn : quarter(quadrant))
        for (const Vec3& p : profile) {
            const double w = turn.z * p.z;
            patch.points.emplace_back(turn.x * p.x + center.x * w, turn.y * p.x + center.y * w,
                                      turn.z * p.y + center.z * w, w);
        }
    return patch;
}

} // namespace

ShapeBuilder::ShapeBuilder() {
    model_.parts.push_back({"part", 0, 0});
    model_.instances.push_back({0, "part", {}});
}

ShapeBuilder& ShapeBuilder::face(const std::vector<PatchData>& patches,
                                 const std::vector<LoopData>& loops) {
    const auto size = [](const auto& v) { return static_cast<std::uint32_t>(v.size()); };
    Face face;
    face.id = size(model_.faces) + 1;
    face.first_patch = size(model_.patches);
    face.patch_count = size(patches);
    face.first_loop = size(model_.trim_loops);
    face.loop_count = size(loops);
    for (const PatchData& p : patches) {
        model_.patches.push_back({size(model_.faces), size(model_.control_points),
                                  static_cast<std::uint16_t>(p.degree_u),
                                  static_cast<std::uint16_t>(p.degree_v), p.map_u, p.map_v});
        model_.control_points.insert(model_.control_points.end(), p.points.begin(), p.points.end());
    }
    for (const LoopData& loop : loops) {
        model_.trim_loops.push_back({size(model_.trim_curves), size(loop)});
        for (const CurveData& c : loop) {
            model_.trim_curves.push_back({size(model_.trim_points),
                                          static_cast<std::uint16_t>(c.points.size() - 1), c.edge});
            model_.trim_points.insert(model_.trim_points.end(), c.points.begin(), c.points.end());
        }
    }
    model_.faces.push_back(face);
    model_.parts[0].face_count = size(model_.faces);
    return *this;
}

std::uint32_t ShapeBuilder::edge(double tolerance) {
    model_.edges.push_back({tolerance, 2, false});
    return static_cast<std::uint32_t>(model_.edges.size()) - 1;
}

ShapeBuilder& ShapeBuilder::place(const std::vector<Affine>& transforms) {
    model_.instances.clear();
    for (const Affine& t : transforms) model_.instances.push_back({0, "part", t});
    return *this;
}

PatchData bilinear(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    PatchData patch;
    for (const Vec3& p : {a, c, b, d}) patch.points.emplace_back(p.x, p.y, p.z, 1);
    return patch;
}

PatchData rectangle(double x0, double x1, double y0, double y1, double z) {
    PatchData patch = bilinear({x0, y0, z}, {x1, y0, z}, {x0, y1, z}, {x1, y1, z});
    patch.map_u = {ParameterMap::Kind::affine, x0, x1};
    patch.map_v = {ParameterMap::Kind::affine, y0, y1};
    return patch;
}

std::vector<PatchData> sphere(const Vec3& center, double radius) {
    std::vector<PatchData> patches;
    for (int half = 0; half < 2; ++half) {
        std::vector<Vec3> profile = quarter(half == 0 ? 3 : 0);
        for (Vec3& p : profile) p = {p.x * radius, p.y * radius, p.z};
        for (int q = 0; q < 4; ++q) {
            patches.push_back(swept(profile, q, center));
            patches.back().map_v = angles(half == 0 ? -pi / 2 : 0);
        }
    }
    return patches;
}

std::vector<PatchData> cylinder(double radius, double height) {
    std::vector<PatchData> patches;
    for (int q = 0; q < 4; ++q) {
        patches.push_back(swept({Vec3(radius, 0, 1), Vec3(radius, height, 1)}, q, Vec3(0)));
        patches.back().map_v = {ParameterMap::Kind::affine, 0, height};
    }
    return patches;
}

std::vector<PatchData> torus(double major, double minor) {
    std::vector<PatchData> patches;
    for (int tube = 0; tube < 4; ++tube) {
        std::vector<Vec3> profile = quarter(tube);
        for (Vec3& p : profile) p = {p.x * minor + major * p.z, p.y * minor, p.z};
        for (int q = 0; q < 4; ++q) {
            patches.push_back(swept(profile, q, Vec3(0)));
            patches.back().map_v = angles(tube * pi / 2);
        }
    }
    return patches;
}

CurveData line(const Vec2& from, const Vec2& to, std::uint32_t edge) {
    return {{Vec3(from.x, from.y, 1), Vec3(to.x, to.y, 1)}, edge};
}

LoopData polygon(const std::vector<Vec2>& corners, std::uint32_t edge) {
    LoopData loop;
    for (std::size_t i = 0; i < corners.size(); ++i)
        loop.push_back(line(corners[i], corners[(i + 1) % corners.size()], edge));
    return loop;
}

LoopData circle(const Vec2& center, double radius, std::uint32_t edge) {
    LoopData loop;
    for (int q = 0; q < 4; ++q) {
        CurveData arc{{}, edge};
        for (const Vec3& p : quarter(q))
            arc.points.emplace_back(p.x * radius + center.x * p.z, p.y * radius + center.y * p.z,
                                    p.z);
        loop.push_back(arc);
    }
    return loop;
}

} // namespace keiko::test
