#include "tests/integration/opencascade_tracer.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IGESControl_Reader.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Lin.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace keiko::test {
namespace {

template <class Reader>
TopoDS_Shape read_exchange(const std::string& file) {
    Reader reader;
    if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) throw std::runtime_error(file);
    reader.TransferRoots();
    return reader.OneShape();
}

TopoDS_Shape read_shape(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".step") return read_exchange<STEPControl_Reader>(file.string());
    if (extension == ".igs") return read_exchange<IGESControl_Reader>(file.string());
    TopoDS_Shape shape;
    if (!BRepTools::Read(shape, file.c_str(), BRep_Builder())) throw std::runtime_error(file);
    return shape;
}

double border_tolerance(const TopoDS_Face& face) {
    double largest = BRep_Tool::Tolerance(face);
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next())
        largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Edge(e.Current())));
    return largest;
}

} // namespace

struct OpenCascadeTracer::Shape {
    struct FacePeer {
        TopoDS_Face face;
        Bnd_Box box;
        double tolerance;
        std::unique_ptr<IntCurvesFace_Intersector> intersector;
    };
    std::vector<FacePeer> faces;
};

OpenCascadeTracer::OpenCascadeTracer(const std::filesystem::path& file)
    : shape_(std::make_unique<Shape>()) {
    const TopoDS_Shape shape = read_shape(file);
    for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next()) {
        const TopoDS_Face face = TopoDS::Face(e.Current());
        Bnd_Box box;
        BRepBndLib::Add(face, box, false);
        shape_->faces.push_back({face, box, border_tolerance(face),
                                 std::make_unique<IntCurvesFace_Intersector>(face, 1e-9)});
    }
}

OpenCascadeTracer::~OpenCascadeTracer() = default;

std::vector<PeerHit> OpenCascadeTracer::all(const Ray& ray) {
    const gp_Lin line(gp_Pnt(ray.origin.x, ray.origin.y, ray.origin.z),
                      gp_Dir(ray.direction.x, ray.direction.y, ray.direction.z));
    std::vector<PeerHit> hits;
    for (Shape::FacePeer& peer : shape_->faces) {
        if (peer.box.IsOut(line)) continue;
        peer.intersector->Perform(line, 0, std::numeric_limits<double>::max());
        if (!peer.intersector->IsDone()) continue;
        for (int i = 1; i <= peer.intersector->NbPnt(); ++i) {
            const gp_Pnt& p = peer.intersector->Pnt(i);
            hits.push_back({peer.intersector->WParameter(i), Vec3(p.X(), p.Y(), p.Z()),
                            peer.intersector->State(i) == TopAbs_ON, peer.tolerance});
        }
    }
    std::sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
    return hits;
}

double OpenCascadeTracer::distance(const Vec3& point) const {
    const TopoDS_Shape vertex =
        BRepBuilderAPI_MakeVertex(gp_Pnt(point.x, point.y, point.z)).Shape();
    double nearest = std::numeric_limits<double>::infinity();
    Bnd_Box around;
    around.Add(gp_Pnt(point.x, point.y, point.z));
    for (const Shape::FacePeer& peer : shape_->faces) {
        if (around.Distance(peer.box) > nearest) continue;
        const BRepExtrema_DistShapeShape search(vertex, peer.face);
        if (search.IsDone() && search.NbSolution() > 0) nearest = std::min(nearest, search.Value());
    }
    return nearest;
}

} // namespace keiko::test
