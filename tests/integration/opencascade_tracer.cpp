#include "tests/integration/opencascade_tracer.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BVH_BoxSet.hxx>
#include <BVH_Traverse.hxx>
#include <Bnd_Box.hxx>
#include <Geom_BezierSurface.hxx>
#include <IGESControl_Reader.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <STEPControl_Reader.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
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
    // Its reader prints on stdout.
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
    Reader reader;
    if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) throw std::runtime_error(file);
    reader.TransferRoots();
    return reader.OneShape();
}

double border_tolerance(const TopoDS_Face& face) {
    double largest = BRep_Tool::Tolerance(face);
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next())
        largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Edge(e.Current())));
    return largest;
}

TopoDS_Face face_of(const BezierPatchView& patch) {
    TColgp_Array2OfPnt points(1, patch.degree_u + 1, 1, patch.degree_v + 1);
    TColStd_Array2OfReal weights(1, patch.degree_u + 1, 1, patch.degree_v + 1);
    for (int i = 0; i <= patch.degree_u; ++i)
        for (int j = 0; j <= patch.degree_v; ++j) {
            const Vec4& p = patch.point(i, j);
            points.SetValue(i + 1, j + 1, gp_Pnt(p.x / p.w, p.y / p.w, p.z / p.w));
            weights.SetValue(i + 1, j + 1, p.w);
        }
    const Handle(Geom_BezierSurface) surface =
        patch.rational() ? new Geom_BezierSurface(points, weights) : new Geom_BezierSurface(points);
    return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

using FaceBoxes = BVH_BoxSet<double, 3, int>;

BVH_Vec3d vector_of(const gp_Pnt& p) {
    return BVH_Vec3d(p.X(), p.Y(), p.Z());
}

/// Walks the hierarchy along a ray, near boxes first; `visit(face, reach)` returns how far the
/// ray is still of interest.
template <class Visit>
class FaceWalk final : public BVH_Traverse<double, 3, FaceBoxes, double> {
public:
    FaceWalk(FaceBoxes& boxes, const Ray& ray, const Visit& visit)
        : ray_(ray), visit_(visit), reach_(ray.t_max) {
        for (int i = 0; i < 3; ++i) inverse_[i] = 1 / ray.direction[i];
        SetBVHSet(&boxes);
    }

    Standard_Boolean RejectNode(const BVH_VecNt& lower, const BVH_VecNt& upper,
                                double& entry) const override {
        double leave = reach_;
        entry = ray_.t_min;
        for (int i = 0; i < 3; ++i) {
            const double a = (lower[i] - ray_.origin[i]) * inverse_[i];
            const double b = (upper[i] - ray_.origin[i]) * inverse_[i];
            entry = std::max(entry, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        return entry > leave;
    }
    Standard_Boolean IsMetricBetter(const double& a, const double& b) const override {
        return a < b;
    }
    Standard_Boolean RejectMetric(const double& entry) const override { return entry > reach_; }
    Standard_Boolean Accept(int index, const double&) override {
        const BVH_Box<double, 3> box = myBVHSet->Box(index);
        double entry = 0;
        if (RejectNode(box.CornerMin(), box.CornerMax(), entry)) return false;
        reach_ = visit_(static_cast<std::size_t>(myBVHSet->Element(index)), reach_);
        return true;
    }

private:
    Ray ray_;
    const Visit& visit_;
    Vec3 inverse_{0};
    double reach_;
};

} // namespace

TopoDS_Shape read_shape(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".step") return read_exchange<STEPControl_Reader>(file.string());
    if (extension == ".igs") return read_exchange<IGESControl_Reader>(file.string());
    TopoDS_Shape shape;
    if (!BRepTools::Read(shape, file.c_str(), BRep_Builder())) throw std::runtime_error(file);
    return shape;
}

TopoDS_Shape shape_of_patches(const SurfaceModel& model) {
    TopoDS_Compound compound;
    const BRep_Builder builder;
    builder.MakeCompound(compound);
    for (std::uint32_t p = 0; p < model.patches.size(); ++p)
        builder.Add(compound, face_of(model.patch(p)));
    return compound;
}

struct OpenCascadeTracer::Shape {
    struct FacePeer {
        TopoDS_Face face;
        Bnd_Box box;
        double tolerance;
        std::unique_ptr<IntCurvesFace_Intersector> intersector;
    };
    std::vector<FacePeer> faces;
    FaceBoxes boxes;

    PeerHit hit(std::size_t face, int point) const {
        const IntCurvesFace_Intersector& found = *faces[face].intersector;
        const gp_Pnt& p = found.Pnt(point);
        return {found.WParameter(point),
                Vec3(p.X(), p.Y(), p.Z()),
                found.State(point) == TopAbs_ON,
                faces[face].tolerance,
                face,
                Vec2(found.UParameter(point), found.VParameter(point))};
    }
};

OpenCascadeTracer::OpenCascadeTracer(const std::filesystem::path& file)
    : OpenCascadeTracer(read_shape(file)) {}

OpenCascadeTracer::OpenCascadeTracer(const TopoDS_Shape& shape)
    : shape_(std::make_unique<Shape>()) {
    for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next()) {
        const TopoDS_Face face = TopoDS::Face(e.Current());
        Bnd_Box box;
        BRepBndLib::Add(face, box, false);
        shape_->faces.push_back({face, box, border_tolerance(face),
                                 std::make_unique<IntCurvesFace_Intersector>(face, 1e-9)});
        shape_->boxes.Add(static_cast<int>(shape_->faces.size()) - 1,
                          {vector_of(box.CornerMin()), vector_of(box.CornerMax())});
    }
    shape_->boxes.Build();
}

OpenCascadeTracer::~OpenCascadeTracer() = default;

std::vector<PeerHit> OpenCascadeTracer::all(const Ray& ray) {
    const gp_Lin line(gp_Pnt(ray.origin.x, ray.origin.y, ray.origin.z),
                      gp_Dir(ray.direction.x, ray.direction.y, ray.direction.z));
    std::vector<PeerHit> hits;
    for (std::size_t face = 0; face < shape_->faces.size(); ++face) {
        Shape::FacePeer& peer = shape_->faces[face];
        if (peer.box.IsOut(line)) continue;
        peer.intersector->Perform(line, 0, std::numeric_limits<double>::max());
        if (!peer.intersector->IsDone()) continue;
        for (int i = 1; i <= peer.intersector->NbPnt(); ++i) hits.push_back(shape_->hit(face, i));
    }
    std::sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
    return hits;
}

std::optional<PeerHit> OpenCascadeTracer::nearest(const Ray& ray) {
    const gp_Lin line(gp_Pnt(ray.origin.x, ray.origin.y, ray.origin.z),
                      gp_Dir(ray.direction.x, ray.direction.y, ray.direction.z));
    std::optional<PeerHit> best;
    const auto visit = [&](std::size_t face, double reach) {
        IntCurvesFace_Intersector& search = *shape_->faces[face].intersector;
        search.Perform(line, ray.t_min, std::min(reach, std::numeric_limits<double>::max()));
        if (!search.IsDone()) return reach;
        for (int i = 1; i <= search.NbPnt(); ++i)
            if (const double t = search.WParameter(i); t > ray.t_min && t < reach) {
                reach = t;
                best = shape_->hit(face, i);
            }
        return reach;
    };
    FaceWalk(shape_->boxes, ray, visit).Select();
    return best;
}

Vec3 OpenCascadeTracer::normal(const PeerHit& hit) const {
    gp_Pnt p;
    gp_Vec u, v;
    BRepAdaptor_Surface(shape_->faces[hit.face].face, false).D1(hit.uv.x, hit.uv.y, p, u, v);
    const gp_Vec n = u.Crossed(v);
    return Vec3(n.X(), n.Y(), n.Z()).normalized();
}

std::size_t OpenCascadeTracer::face_count() const {
    return shape_->faces.size();
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
