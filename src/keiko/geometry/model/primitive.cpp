#include "keiko/geometry/model/primitive.h"

#include "keiko/math/axes.h"
#include "keiko/math/bounds.h"
#include "keiko/math/polygon.h"
#include "keiko/math/quadrature.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;

template <class T>
std::uint32_t size_of(const std::vector<T>& all) {
    return static_cast<std::uint32_t>(all.size());
}

/// Homogeneous points (x w, y w, w) of the quarter of the unit circle that begins at quadrant q.
std::array<Vec3, 3> quarter(int q) {
    constexpr std::array<int, 5> cosines{1, 0, -1, 0, 1}, sines{0, 1, 0, -1, 0};
    const auto i = static_cast<std::size_t>(q);
    const Vec3 a(cosines[i], sines[i], 1), b(cosines[i + 1], sines[i + 1], 1);
    return {a, Vec3(a.x + b.x, a.y + b.y, 1) * std::sqrt(0.5), b};
}

ParameterMap affine(double begin, double end) {
    return {ParameterMap::Kind::affine, begin, end};
}
ParameterMap circular(double begin) {
    return {ParameterMap::Kind::circular, begin, begin + pi / 2};
}

/// Unit vectors across a direction, right-handed with it.
struct Across {
    Vec3 x, y;

    explicit Across(const Vec3& along)
        : x(any_perpendicular(along).normalized()), y(along.cross(x)) {}
};

/// A model of one part to which faces are added.
class Builder {
public:
    explicit Builder(const std::string& name) {
        model_.source = model_.format = "primitive";
        model_.parts.push_back({name, 0, 0});
        model_.instances.push_back({0, name, {}});
    }
    SurfaceModel model() && { return std::move(model_); }

    void add(const PlaneShape& shape) {
        begin_face("plane");
        const Vec3 &o = shape.origin, far = o + shape.v;
        add_patch(1, 1, affine(0, 1), affine(0, 1),
                  std::array{point(o), point(far), point(o + shape.u), point(far + shape.u)});
        end_face();
    }
    void add(const BoxShape& shape) {
        for (const PlaneShape& face : shape.faces()) add(face);
    }
    /// The square around it, trimmed by a circle.
    void add(const DiscShape& shape) {
        begin_face("plane");
        const Across across(shape.normal);
        const Vec3 x = across.x * shape.radius, y = across.y * shape.radius, &c = shape.center;
        add_patch(
            1, 1, affine(-1, 1), affine(-1, 1),
            std::array{point(c - x - y), point(c - x + y), point(c + x - y), point(c + x + y)});
        model_.trim_loops.push_back({size_of(model_.trim_curves), 4});
        model_.faces.back().loop_count = 1;
        for (int q = 0; q < 4; ++q) {
            model_.trim_curves.push_back({size_of(model_.trim_points), 2, no_index});
            for (const Vec3& at : quarter(q)) model_.trim_points.push_back(at);
        }
        end_face();
    }
    /// The rectangle around it, trimmed by its sides.
    void add(const PolygonShape& shape) {
        const PlaneShape around = shape.around();
        add(around);
        const Vec3 u = around.u / around.u.length2(), v = around.v / around.v.length2();
        const auto place = [&](const Vec3& corner) {
            const Vec3 way = corner - around.origin;
            return Vec3(u.dot(way), v.dot(way), 1);
        };
        model_.faces.back().loop_count = 1;
        model_.trim_loops.push_back({size_of(model_.trim_curves), size_of(shape.corners)});
        Vec3 from = shape.corners.back();
        for (const Vec3& corner : shape.corners) {
            model_.trim_curves.push_back({size_of(model_.trim_points), 1, no_index});
            model_.trim_points.push_back(place(from));
            model_.trim_points.push_back(place(corner));
            from = corner;
        }
    }
    /// Quarters of the lateral surface, then the discs of the ends that have a size.
    void add(const FrustumShape& shape) {
        begin_face(shape.radius == shape.to_radius ? "cylinder" : "cone");
        const Vec3 along = (shape.to - shape.from).normalized();
        const Across across(along);
        for (int q = 0; q < 4; ++q) {
            std::vector<Vec4> points;
            for (const Vec3& turn : quarter(q)) {
                const Vec3 out = across.x * turn.x + across.y * turn.y;
                points.push_back(weighted(shape.from * turn.z + out * shape.radius, turn.z));
                points.push_back(weighted(shape.to * turn.z + out * shape.to_radius, turn.z));
            }
            add_patch(2, 1, circular(q * pi / 2), affine(0, 1), points);
        }
        end_face();
        if (shape.open) return;
        if (shape.radius > 0) add(DiscShape{shape.from, -along, shape.radius});
        if (shape.to_radius > 0) add(DiscShape{shape.to, along, shape.to_radius});
    }
    /// Octants; parameters are longitude and latitude.
    void add(const EllipsoidShape& shape) {
        begin_face("ellipsoid");
        const bool mirrored = shape.u.cross(shape.v).dot(shape.w) < 0;
        const Vec3& u = mirrored ? shape.v : shape.u;
        const Vec3& v = mirrored ? shape.u : shape.v;
        for (int q = 0; q < 4; ++q)
            for (const int half : {3, 0}) {
                std::vector<Vec4> points;
                for (const Vec3& turn : quarter(q))
                    for (const Vec3& rise : quarter(half)) {
                        const double w = turn.z * rise.z;
                        const Vec3 at =
                            (u * turn.x + v * turn.y) * rise.x + shape.w * (turn.z * rise.y);
                        points.push_back(weighted(shape.center * w + at, w));
                    }
                add_patch(2, 2, circular(q * pi / 2), circular(half == 3 ? -pi / 2 : 0), points);
            }
        end_face();
    }

private:
    static Vec4 weighted(const Vec3& at, double w) { return {at.x, at.y, at.z, w}; }
    static Vec4 point(const Vec3& at) { return weighted(at, 1); }

    void begin_face(const std::string& kind) {
        Face face;
        face.id = size_of(model_.faces) + 1;
        face.name = model_.parts[0].name;
        face.surface_kind = kind;
        face.first_patch = size_of(model_.patches);
        face.first_loop = size_of(model_.trim_loops);
        model_.faces.push_back(face);
    }
    void end_face() {
        Face& face = model_.faces.back();
        face.patch_count = size_of(model_.patches) - face.first_patch;
        model_.parts[0].face_count = size_of(model_.faces);
    }
    void add_patch(std::uint16_t degree_u, std::uint16_t degree_v, const ParameterMap& map_u,
                   const ParameterMap& map_v, std::span<const Vec4> points) {
        model_.patches.push_back({size_of(model_.faces) - 1, size_of(model_.control_points),
                                  degree_u, degree_v, map_u, map_v});
        model_.control_points.insert(model_.control_points.end(), points.begin(), points.end());
    }

    SurfaceModel model_;
};

double area_of(const PlaneShape& shape) {
    return shape.u.cross(shape.v).length();
}
double area_of(const DiscShape& shape) {
    return pi * shape.radius * shape.radius;
}
double area_of(const PolygonShape& shape) {
    return polygon_normal(shape.corners).length() / 2;
}
double area_of(const BoxShape& shape) {
    double sum = 0;
    for (const PlaneShape& face : shape.faces()) sum += area_of(face);
    return sum;
}
double area_of(const FrustumShape& shape) {
    const double r = shape.radius, s = shape.to_radius;
    const double slant = std::hypot((shape.to - shape.from).length(), r - s);
    return pi * (r + s) * slant + (shape.open ? 0 : pi * (r * r + s * s));
}
/// Gauss's rule over the unit sphere, by longitude and latitude.
double area_of(const EllipsoidShape& shape) {
    const Vec3 vw = shape.v.cross(shape.w), wu = shape.w.cross(shape.u),
               uv = shape.u.cross(shape.v);
    constexpr int order = 64;
    double sum = 0;
    for (int q = 0; q < 4; ++q)
        sum += integrate(
            [&](double turn) {
                const Vec3 level = vw * std::cos(turn) + wu * std::sin(turn);
                return integrate(
                    [&](double rise) {
                        const double cosine = std::cos(rise);
                        return (level * cosine + uv * std::sin(rise)).length() * cosine;
                    },
                    -pi / 2, pi / 2, order);
            },
            q * pi / 2, (q + 1) * pi / 2, order);
    return sum;
}

} // namespace

PlaneShape PolygonShape::around() const {
    const Vec3& first = corners[0];
    const Vec3 along = (corners[1] - first).normalized();
    const Vec3 across = polygon_normal(corners).cross(along).normalized();
    Box2 box;
    for (const Vec3& corner : corners)
        box.extend(Vec2(along.dot(corner - first), across.dot(corner - first)));
    return {first + along * box.lower.x + across * box.lower.y, along * box.extent().x,
            across * box.extent().y};
}

std::vector<PlaneShape> BoxShape::faces() const {
    std::vector<PlaneShape> faces;
    const auto add_pair = [&](const Vec3& a, const Vec3& b, const Vec3& across) {
        faces.push_back({origin, b, a});
        faces.push_back({origin + across, a, b});
    };
    add_pair(u, v, w), add_pair(v, w, u), add_pair(w, u, v);
    return faces;
}

double surface_area(const PrimitiveShape& shape) {
    return std::visit([](const auto& kind) { return area_of(kind); }, shape);
}

SurfaceModel primitive_model(const PrimitiveShape& shape, const std::string& name) {
    Builder builder(name);
    std::visit([&](const auto& kind) { builder.add(kind); }, shape);
    return std::move(builder).model();
}

} // namespace keiko
