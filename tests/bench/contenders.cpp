#include "tests/bench/contenders.h"

#include "tests/bench/brep_mesh.h"
#include "tests/bench/grid_choice.h"
#include "tests/bench/keiko_contender.h"
#include "tests/bench/mesh_contender.h"
#include "tests/bench/opencascade_contender.h"
#include "tests/bench/progress.h"
#include "tests/bench/traversal_contender.h"
#include "tests/integration/opencascade_tracer.h"
#include <BRepBuilderAPI_Transform.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>

#include <cstdio>
#include <utility>

namespace keiko::bench {
namespace {

std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", x);
    return text;
}

/// Shape of the scene's body for OpenCASCADE; `model` is scaled already.
TopoDS_Shape shape_of(const SceneFile& scene, const SurfaceModel& model) {
    if (scene.file.extension() == ".bpt") return test::shape_of_patches(model);
    const TopoDS_Shape shape = test::read_shape(scene.file);
    if (scene.scale == 1) return shape;
    gp_Trsf larger;
    larger.SetScaleFactor(scene.scale);
    return BRepBuilderAPI_Transform(shape, larger, true).Shape();
}

void add_meshes(Contenders& contenders, const SceneFile& scene, const TopoDS_Shape& shape,
                const Box3& bounds, double finest) {
    std::vector<double> deflections{1, 0.1, 0.01};
    if (finest > 0) deflections.push_back(finest);
    for (const double deflection : deflections) {
        tell(scene.name, "mesh of " + number(deflection) + " mm");
        TriangleMesh mesh = brep_mesh(shape, deflection, bounds.center());
        ContenderFacts facts{.kind = Kind::mesh,
                             .name = "mesh " + number(deflection) + " mm",
                             .deflection = deflection};
        if (mesh.faces_without > 0)
            facts.remark = std::to_string(mesh.faces_without) + " faces without triangles";
        contenders.push_back(
            std::make_unique<MeshContender>(std::move(mesh), bounds, std::move(facts)));
    }
}

/// Adds Embree's hierarchies over Keiko's own boxes; Keiko itself holds one of them.
void add_traversal(Contenders& contenders, KeikoContender& keiko) {
    for (const bool end_at_hit : {false, true})
        contenders.push_back(
            std::make_unique<TraversalContender>(keiko.tracer().boxes(), end_at_hit));
    keiko.add_hierarchy(contenders.back()->facts().bytes);
}

} // namespace

Contenders contenders_of(const SceneFile& scene, const SurfaceModel& model, const RaySet& primary,
                         const TraceOptions& options) {
    Contenders contenders;
    auto owned = std::make_unique<KeikoContender>(model);
    KeikoContender& keiko = *owned;
    const Box3& bounds = keiko.tracer().bounds();
    contenders.push_back(std::move(owned));
    contenders.push_back(std::make_unique<CrossingContender>(keiko.tracer()));
    if (options.alone) return contenders;
    add_traversal(contenders, keiko);
    const TopoDS_Shape shape = shape_of(scene, model);
    contenders.push_back(
        std::make_unique<OpenCascadeContender>(shape, bounds.size(), options.slow_rays));
    add_meshes(contenders, scene, shape, bounds, options.finest);
    tell(scene.name, "grid per span");
    contenders.push_back(fitted_grid(model, bounds, primary, options.most_triangles));
    return contenders;
}

} // namespace keiko::bench
