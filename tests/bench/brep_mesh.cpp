#include "tests/bench/brep_mesh.h"

#include "keiko/math/nearest_rank.h"

#include "tests/bench/cpu_clock.h"
#include <BRepAdaptor_Surface.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include <cmath>
#include <utility>

namespace keiko::bench {
namespace {

/// 0 at a pole: its triangles decide.
Vec3 surface_normal(const BRepAdaptor_Surface& surface, const gp_Pnt2d& uv) {
    BRepLProp_SLProps properties(surface, uv.X(), uv.Y(), 1, 1e-9);
    if (!properties.IsNormalDefined()) return Vec3(0);
    const gp_Dir n = properties.Normal();
    return {n.X(), n.Y(), n.Z()};
}

void complete_poles(TriangleMesh& mesh, std::size_t first_triangle) {
    std::vector<std::pair<std::uint32_t, Imath::V3f>> found;
    for (std::size_t t = first_triangle; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const Imath::V3f facet =
            (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
        for (const std::uint32_t v : {a, b, c})
            if (mesh.normals[v] == Imath::V3f(0)) found.emplace_back(v, facet);
    }
    for (const auto& [vertex, facet] : found) mesh.normals[vertex] += facet;
    for (const auto& [vertex, facet] : found) mesh.normals[vertex].normalize();
}

/// Appends what there is of the faces one after the other.
class MeshBuilder {
public:
    explicit MeshBuilder(const Vec3& center) : center_(center) {
        // OpenCASCADE counts from 1: an unused vertex stands before all faces.
        mesh_.positions.emplace_back(0.0F);
        mesh_.normals.emplace_back(Imath::V3f(1, 0, 0));
    }

    void append(const TopoDS_Face& face) {
        TopLoc_Location location;
        const Handle(Poly_Triangulation) part = BRep_Tool::Triangulation(face, location);
        if (part.IsNull() || part->NbTriangles() == 0) {
            ++mesh_.faces_without;
            return;
        }
        const BRepAdaptor_Surface surface(face);
        const auto offset = static_cast<std::uint32_t>(mesh_.positions.size()) - 1;
        const std::size_t first_triangle = mesh_.triangles.size();
        for (int i = 1; i <= part->NbNodes(); ++i) {
            const gp_Pnt p = part->Node(i).Transformed(location.Transformation());
            mesh_.positions.emplace_back(Vec3(p.X(), p.Y(), p.Z()) - center_);
            mesh_.normals.emplace_back(surface_normal(surface, part->UVNode(i)));
        }
        for (int i = 1; i <= part->NbTriangles(); ++i) append(*part, i, offset, surface);
        complete_poles(mesh_, first_triangle);
    }

    TriangleMesh finish() {
        mesh_.positions.emplace_back(0.0F);
        mesh_.deviation = nearest_rank(deviations_, 0.999);
        return std::move(mesh_);
    }

private:
    void append(const Poly_Triangulation& part, int index, std::uint32_t offset,
                const BRepAdaptor_Surface& surface) {
        constexpr int probed = 8; // one triangle in so many
        int a = 0, b = 0, c = 0;
        part.Triangle(index).Get(a, b, c);
        mesh_.triangles.push_back({offset + static_cast<std::uint32_t>(a),
                                   offset + static_cast<std::uint32_t>(b),
                                   offset + static_cast<std::uint32_t>(c)});
        if (index % probed != 0) return;
        const gp_XY middle = (part.UVNode(a).XY() + part.UVNode(b).XY() + part.UVNode(c).XY()) / 3;
        const gp_Pnt p = surface.Value(middle.X(), middle.Y());
        deviations_.push_back(distance_to(mesh_.triangles.back(), Vec3(p.X(), p.Y(), p.Z())));
    }

    /// From the plane of a triangle, mm.
    double distance_to(const std::array<std::uint32_t, 3>& triangle, const Vec3& point) const {
        const Vec3 a(mesh_.positions[triangle[0]]), b(mesh_.positions[triangle[1]]),
            c(mesh_.positions[triangle[2]]);
        const Vec3 normal = (b - a).cross(c - a).normalized();
        return std::abs((point - center_ - a).dot(normal));
    }

    Vec3 center_;
    TriangleMesh mesh_;
    std::vector<double> deviations_; ///< mm
};

} // namespace

TriangleMesh brep_mesh(const TopoDS_Shape& shape, double deflection, const Vec3& center) {
    BRepTools::Clean(shape); // a finer triangulation would be kept
    const double seconds = process_seconds([&] { BRepMesh_IncrementalMesh(shape, deflection); });
    MeshBuilder builder(center);
    for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next())
        builder.append(TopoDS::Face(e.Current()));
    TriangleMesh mesh = builder.finish();
    mesh.mesh_seconds = seconds;
    return mesh;
}

} // namespace keiko::bench
