#include "tests/unit/import/limit_oracle.h"

#include "keiko/import/subdivision/limit_table.h"
#include "keiko/intersect/traversal/tracer.h"

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/ptexIndices.h>

#include <array>
#include <cstdio>
#include <functional>
#include <map>

namespace keiko::test {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Bfr = OpenSubdiv::Bfr;
using subdivision::Cage;
using subdivision::Scheme;

struct Value {
    Vec3 v;
    Value() : v(0) {}
    void Clear() { v = Vec3(0); }
    void AddWithWeight(const Value& other, double weight) { v += other.v * weight; }
};

double size_of(const Cage& cage) {
    Box3 box;
    for (const Vec3& p : cage.vertices) box.extend(p);
    return box.size();
}

/// One point of the limit surface on a base face. No normal: none to compare.
struct Sample {
    std::uint32_t base = 0;
    Vec2 uv{0};
    Vec3 position{0}, normal{0};
};
using Samples = std::vector<Sample>;

/// A face of a refined level on its base face.
struct Traced {
    std::uint32_t base = 0;
    std::array<Vec2, 4> corners;
};

std::array<Vec2, 4> child(const std::array<Vec2, 4>& c, std::size_t k) {
    const std::size_t before = (k + 3) % 4, after = (k + 1) % 4;
    std::array<Vec2, 4> result;
    result[k] = c[k];
    result[after] = (c[k] + c[after]) / 2;
    result[(k + 2) % 4] = (c[0] + c[1] + c[2] + c[3]) / 4;
    result[before] = (c[k] + c[before]) / 2;
    return result;
}

constexpr std::array<std::array<double, 2>, 4> unit{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

std::array<Vec2, 4> unit_square() {
    std::array<Vec2, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = Vec2(unit[k][0], unit[k][1]);
    return corners;
}

/// The faces of the last level by index; hole faces are absent.
std::map<int, Traced> traced_faces(const Far::TopologyRefiner& refiner) {
    const Far::PtexIndices ptex(refiner);
    const Far::TopologyLevel& base = refiner.GetLevel(0);
    std::map<int, Traced> faces;
    for (int f = 0; f < base.GetNumFaces(); ++f) {
        if (base.IsFaceHole(f)) continue;
        const auto children = base.GetFaceChildFaces(f);
        const auto first = static_cast<std::uint32_t>(ptex.GetFaceId(f));
        const bool quad = base.GetFaceVertices(f).size() == 4;
        for (int k = 0; k < children.size(); ++k) {
            const auto i = static_cast<std::size_t>(k);
            faces[children[k]] = quad
                                     ? Traced{first, child(unit_square(), i)}
                                     : Traced{first + static_cast<std::uint32_t>(k), unit_square()};
        }
    }
    for (int level = 1; level < refiner.GetMaxLevel(); ++level) {
        std::map<int, Traced> next;
        for (const auto& [f, traced] : faces) {
            const auto children = refiner.GetLevel(level).GetFaceChildFaces(f);
            for (int k = 0; k < children.size(); ++k)
                next[children[k]] = {traced.base,
                                     child(traced.corners, static_cast<std::size_t>(k))};
        }
        faces = std::move(next);
    }
    return faces;
}

struct Limits {
    std::unique_ptr<Far::TopologyRefiner> refiner;
    std::vector<Value> position, du, dv;

    Limits(const Cage& cage, int level) : refiner(subdivision::make_refiner(cage)) {
        Far::TopologyRefiner::UniformOptions options(level);
        options.fullTopologyInLastLevel = true;
        refiner->RefineUniform(options);
        const Far::PrimvarRefinerReal<double> values(*refiner);
        std::vector<Value> points(cage.vertices.size());
        for (std::size_t i = 0; i < points.size(); ++i) points[i].v = cage.vertices[i];
        for (int l = 1; l <= level; ++l) {
            std::vector<Value> finer(count(l));
            values.Interpolate(l, points, finer);
            points = std::move(finer);
        }
        for (auto* list : {&position, &du, &dv}) list->resize(count(level));
        values.Limit(points, position, du, dv);
    }

    /// Whether the mask is exact. It is not where sharpness is still to wear off or a crease for
    /// ever ends (the mask is that of a smooth vertex), nor at an inner vertex of two faces.
    bool final(int vertex) const {
        const auto& last = refiner->GetLevel(refiner->GetMaxLevel());
        if (last.GetVertexRule(vertex) == OpenSubdiv::Sdc::Crease::RULE_DART) return false;
        if (last.GetVertexFaces(vertex).size() == 2 && !last.IsVertexBoundary(vertex)) return false;
        for (const int edge : last.GetVertexEdges(vertex))
            if (last.IsEdgeSemiSharp(edge)) return false;
        return !last.IsVertexSemiSharp(vertex);
    }
    std::size_t count(int level) const {
        return static_cast<std::size_t>(refiner->GetLevel(level).GetNumVertices());
    }
    /// Zero where the vertex is sharp, or the surface stands still.
    Vec3 normal(int vertex) const {
        const auto& last = refiner->GetLevel(refiner->GetMaxLevel());
        if (last.GetVertexRule(vertex) != OpenSubdiv::Sdc::Crease::RULE_SMOOTH) return Vec3(0);
        const auto i = static_cast<std::size_t>(vertex);
        return du[i].v.cross(dv[i].v).normalized();
    }
};

Samples mask_samples(const Cage& cage, int level) {
    const Limits limits(cage, level);
    const auto& last = limits.refiner->GetLevel(level);
    Samples samples;
    for (const auto& [f, traced] : traced_faces(*limits.refiner)) {
        const auto vertices = last.GetFaceVertices(f);
        for (int k = 0; k < vertices.size(); ++k)
            if (limits.final(vertices[k]))
                samples.push_back({traced.base, traced.corners[static_cast<std::size_t>(k)],
                                   limits.position[static_cast<std::size_t>(vertices[k])].v,
                                   limits.normal(vertices[k])});
    }
    return samples;
}

/// Vertices of the last level, once each, that lie on a face which is no hole.
Samples smooth_vertices(const Cage& cage, int level) {
    const Limits limits(cage, level);
    const auto& last = limits.refiner->GetLevel(level);
    Samples samples;
    for (int v = 0; v < last.GetNumVertices(); ++v)
        if (const Vec3 normal = limits.normal(v); normal != Vec3(0) && !last.IsVertexBoundary(v) &&
                                                  !last.IsFaceHole(last.GetVertexFaces(v)[0]))
            samples.push_back({0, Vec2(0), limits.position[static_cast<std::size_t>(v)].v, normal});
    return samples;
}

Samples bfr_samples(const Cage& cage, int steps) {
    const auto refiner = subdivision::make_refiner(cage);
    const Far::PtexIndices ptex(*refiner);
    Bfr::SurfaceFactory::Options options;
    options.SetApproxLevelSmooth(10).SetApproxLevelSharp(10);
    const Bfr::RefinerSurfaceFactory<> factory(*refiner, options);
    Bfr::Surface<double> surface;
    std::vector<double> mesh, points;
    for (const Vec3& p : cage.vertices) mesh.insert(mesh.end(), {p.x, p.y, p.z});
    Samples samples;
    for (int f = 0; f < refiner->GetLevel(0).GetNumFaces(); ++f) {
        if (!factory.FaceHasLimitSurface(f)) continue;
        factory.InitVertexSurface(f, &surface);
        points.resize(3 * static_cast<std::size_t>(surface.GetNumPatchPoints()));
        surface.PreparePatchPoints(mesh.data(), {3, 3}, points.data(), {3, 3});
        const int n = refiner->GetLevel(0).GetFaceVertices(f).size();
        const bool regular = n == (cage.scheme == Scheme::loop ? 3 : 4);
        for (int k = 0; k < (regular ? 1 : n); ++k)
            for (int i = 0; i < steps; ++i)
                for (int j = 0; j < steps; ++j) {
                    // Off the dyadic lines, where pieces meet.
                    const Vec2 uv((i + 0.37) / steps, (j + 0.41) / steps);
                    if (cage.scheme == Scheme::loop && uv.x + uv.y >= 1) continue;
                    double at[2] = {uv.x, uv.y}, p[3], du[3], dv[3];
                    if (!regular) {
                        const double own[2] = {uv.x, uv.y};
                        surface.GetParameterization().ConvertNormalizedSubFaceToCoord(k, own, at);
                    }
                    surface.Evaluate(at, points.data(), {3, 3}, p, du, dv);
                    const Vec3 normal =
                        Vec3(du[0], du[1], du[2]).cross(Vec3(dv[0], dv[1], dv[2])).normalized();
                    samples.push_back({static_cast<std::uint32_t>(ptex.GetFaceId(f) + k), uv,
                                       Vec3(p[0], p[1], p[2]), normal});
                }
    }
    return samples;
}

void take(Deviation& deviation, const Sample& sample, const Vec3& position, const Vec3& normal,
          double size) {
    ++deviation.points;
    deviation.position = std::max(deviation.position, (position - sample.position).length() / size);
    if (sample.normal == Vec3(0)) return;
    ++deviation.normals;
    deviation.normal = std::max(deviation.normal, angle_between(normal, sample.normal));
}

bool covers(const Patch& patch, const Vec2& uv) {
    return patch.map_u.begin <= uv.x && uv.x <= patch.map_u.end && patch.map_v.begin <= uv.y &&
           uv.y <= patch.map_v.end;
}

Deviation by_parameters(const Samples& samples, const Cage& cage, const SurfaceModel& model) {
    std::map<std::uint32_t, const Face*> faces;
    for (const Face& face : model.faces) faces[face.id - 1] = &face;
    const double size = size_of(cage);
    Deviation deviation;
    for (const Sample& sample : samples) {
        const auto face = faces.find(sample.base);
        std::size_t found = 0;
        for (std::uint32_t k = 0; face != faces.end() && k < face->second->patch_count; ++k) {
            const std::uint32_t index = face->second->first_patch + k;
            const Patch& patch = model.patches[index];
            if (!covers(patch, sample.uv)) continue;
            const Vec2 own(patch.map_u.to_patch(sample.uv.x), patch.map_v.to_patch(sample.uv.y));
            const SurfaceDerivatives s = evaluate(model.patch(index), own, 1);
            take(deviation, sample, s.position(), s.du().cross(s.dv()), size);
            ++found;
        }
        deviation.missed += found == 0;
    }
    return deviation;
}

Deviation by_rays(const Samples& samples, const Cage& cage, const SurfaceModel& model) {
    const Tracer tracer(model);
    const double size = size_of(cage);
    Deviation deviation;
    for (const Sample& sample : samples) {
        Ray ray;
        ray.origin = sample.position + sample.normal * (1e-3 * size);
        ray.direction = -sample.normal;
        ray.t_max = 2e-3 * size;
        const Hit* nearest = nullptr;
        const std::vector<Hit> hits = tracer.all(ray);
        for (const Hit& hit : hits)
            if (!nearest || (hit.position - sample.position).length() <
                                (nearest->position - sample.position).length())
                nearest = &hit;
        if (!nearest)
            ++deviation.missed;
        else
            take(deviation, sample, nearest->position, nearest->normal, size);
    }
    return deviation;
}

} // namespace

std::string Deviation::text() const {
    char line[160];
    std::snprintf(line, sizeof line, "position %.1e of the size, normal %.1e rad (%zu, %zu)",
                  position, normal, points, normals);
    return line;
}

Deviation from_limit_masks(const Cage& cage, const SurfaceModel& model, int level) {
    return by_parameters(mask_samples(cage, level), cage, model);
}

Deviation rays_from_limit_masks(const Cage& cage, const SurfaceModel& model, int level) {
    return by_rays(smooth_vertices(cage, level), cage, model);
}

Deviation from_bfr(const Cage& cage, const SurfaceModel& model, int steps) {
    return by_parameters(bfr_samples(cage, steps), cage, model);
}

Deviation rays_from_bfr(const Cage& cage, const SurfaceModel& model, int steps) {
    return by_rays(bfr_samples(cage, steps), cage, model);
}

} // namespace keiko::test
