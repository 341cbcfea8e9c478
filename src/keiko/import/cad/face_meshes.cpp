#include "keiko/import/cad/face_meshes.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/import/cad/occt_face.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Face.hxx>

#include <algorithm>

namespace keiko::cad {
namespace {

/// Largest distance of the surface from the triangles at their middles and those of their edges.
double deviation_of(const FaceMesh& mesh, const ModelSurface& surface) {
    std::vector<Vec3> corners;
    for (const Vec2& uv : mesh.uv) corners.push_back(surface.position(uv));
    double largest = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        for (const auto& [i, j] : {std::pair(a, b), {b, c}, {c, a}}) {
            const Vec3 middle = surface.position((mesh.uv[i] + mesh.uv[j]) * 0.5);
            largest = std::max(largest, segment_distance(corners[i], corners[j], middle));
        }
        const Vec3 middle = surface.position((mesh.uv[a] + mesh.uv[b] + mesh.uv[c]) / 3);
        const Vec3 normal = (corners[b] - corners[a]).cross(corners[c] - corners[a]);
        if (normal.length() > 0)
            largest =
                std::max(largest, std::abs((middle - corners[a]).dot(normal)) / normal.length());
    }
    return largest;
}

FaceMesh triangles_of(const TopoDS_Face& face) {
    TopLoc_Location location;
    const auto triangulation = BRep_Tool::Triangulation(face, location);
    FaceMesh mesh;
    if (triangulation.IsNull() || triangulation->NbTriangles() == 0 ||
        !triangulation->HasUVNodes()) {
        mesh.problem = "OpenCASCADE makes no triangles of it";
        return mesh;
    }
    for (int i = 1; i <= triangulation->NbNodes(); ++i) {
        const gp_Pnt2d uv = triangulation->UVNode(i);
        mesh.uv.emplace_back(uv.X(), uv.Y());
    }
    for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
        int a = 0, b = 0, c = 0;
        triangulation->Triangle(i).Get(a, b, c);
        const auto index = [](int node) { return static_cast<std::uint32_t>(node - 1); };
        mesh.triangles.push_back({index(a), index(b), index(c)});
    }
    return mesh;
}

FaceMesh meshed(const TopoDS_Face& face, double deflection) {
    constexpr double turn = 0.35; // radians between neighbouring edges and normals, for shading
    IMeshTools_Parameters parameters;
    parameters.Deflection = deflection, parameters.Angle = turn;
    BRepMesh_IncrementalMesh mesher(face, parameters);
    FaceMesh mesh = triangles_of(face);
    if (!mesh.problem.empty())
        mesh.problem += " (status " + std::to_string(mesher.GetStatusFlags()) + ")";
    return mesh;
}

FaceMesh mesh_of(const SurfaceModel& model, const Face& face, double deviation) {
    constexpr int most_trials = 6;
    const opencascade::handle<ModelSurface> surface = new ModelSurface(model, face);
    FaceMesh best;
    double deflection = deviation;
    for (int trial = 0; trial < most_trials; ++trial, deflection /= 2) {
        FaceMesh mesh = meshed(occt_face(surface, model, face), deflection);
        if (!mesh.problem.empty()) return trial == 0 ? mesh : best;
        mesh.deviation = deviation_of(mesh, *surface);
        if (trial == 0 || mesh.deviation < best.deviation) best = std::move(mesh);
        if (best.deviation <= deviation) break;
    }
    return best;
}

} // namespace

ModelMesh mesh_faces(const SurfaceModel& model, double deviation, const Job& job) {
    ModelMesh mesh(model.faces.size());
    parallel_for(mesh.size(), job, "mesh", [&](std::size_t f) {
        try {
            mesh[f] = mesh_of(model, model.faces[f], deviation);
        } catch (const Standard_Failure& failure) {
            mesh[f].problem = std::string("OpenCASCADE: ") + failure.GetMessageString();
        }
    });
    return mesh;
}

} // namespace keiko::cad
