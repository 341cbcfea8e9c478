#include "keiko/base/units.h"
#include "keiko/inspect/seam_measure.h"
#include "keiko/io/load_model.h"

#include "tests/support/paths.h"
#include <Adaptor3d_CurveOnSurface.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_ExtPC.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <LocalAnalysis_SurfaceContinuity.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <optional>

/// The angles of seams of real panels against OpenCASCADE's LocalAnalysis, place by place, on the
/// file's own surfaces.
namespace keiko::cad {
namespace {

/// A face of a file with its border as curves on its surface.
class FileFace {
public:
    explicit FileFace(const TopoDS_Face& face) : surface_(BRep_Tool::Surface(face)) {
        const Handle(GeomAdaptor_Surface) adaptor = new GeomAdaptor_Surface(surface_);
        for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
            double first = 0, last = 0;
            const Handle(Geom2d_Curve) curve =
                BRep_Tool::CurveOnSurface(TopoDS::Edge(e.Current()), face, first, last);
            if (curve.IsNull()) continue;
            curves_.push_back(curve);
            borders_.emplace_back(new Geom2dAdaptor_Curve(curve, first, last), adaptor);
        }
    }

    const Handle(Geom_Surface) & surface() const { return surface_; }

    /// Parameters of the border's point that is nearest to a place, and its distance in mm.
    struct Foot {
        gp_Pnt2d at;
        double distance = 1e9;
    };
    Foot foot(const gp_Pnt& place) const {
        Foot nearest;
        for (std::size_t i = 0; i < borders_.size(); ++i) {
            const auto consider = [&](double t) {
                const double distance = borders_[i].Value(t).Distance(place);
                if (distance < nearest.distance) nearest = {curves_[i]->Value(t), distance};
            };
            consider(borders_[i].FirstParameter()), consider(borders_[i].LastParameter());
            const Extrema_ExtPC extrema(place, borders_[i]);
            if (!extrema.IsDone()) continue;
            for (int k = 1; k <= extrema.NbExt(); ++k) consider(extrema.Point(k).Parameter());
        }
        return nearest;
    }

private:
    Handle(Geom_Surface) surface_;
    std::vector<Handle(Geom2d_Curve)> curves_;
    std::vector<Adaptor3d_CurveOnSurface> borders_;
};

/// The faces of a BREP file in the order of their ids.
std::vector<FileFace> faces_of(const std::filesystem::path& path) {
    TopoDS_Shape shape;
    BRepTools::Read(shape, path.c_str(), BRep_Builder());
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(shape, TopAbs_FACE, map);
    std::vector<FileFace> faces;
    for (int i = 1; i <= map.Extent(); ++i) faces.emplace_back(TopoDS::Face(map(i)));
    return faces;
}

/// What OpenCASCADE has to say of a place of a seam.
struct Continuity {
    double gap = 0;              ///< mm, to the border of the second face
    std::optional<double> angle; ///< degrees, 0 to 90
};

Continuity continuity_at(const FileFace& a, const FileFace& b, const Vec3& place) {
    const gp_Pnt point(place.x, place.y, place.z);
    const FileFace::Foot on_a = a.foot(point), on_b = b.foot(point);
    Continuity found{on_b.distance, std::nullopt};
    constexpr double any_gap = 10; // mm
    LocalAnalysis_SurfaceContinuity local(a.surface(), on_a.at.X(), on_a.at.Y(), b.surface(),
                                          on_b.at.X(), on_b.at.Y(), GeomAbs_G1, 1e-12, any_gap,
                                          1e-3, 1e-3, 1e-3, 0.1, 1e9);
    if (local.IsDone()) found.angle = radians_to_degrees(local.G1Angle());
    return found;
}

struct Agreement {
    int places = 0, seams = 0;
    double angle_over = 0, gap_over = 0; ///< of a place over the seam's maximum and its bound
    double angle_at_worst = 0, gap_at_worst = 0; ///< the difference at the worst place
};

void compare(const MeasuredSeam& seam, const FileFace& a, const FileFace& b, Agreement& found) {
    ++found.seams;
    const auto over = [](double value, const Worst& worst) {
        return value - worst.value - worst.bound;
    };
    for (const std::vector<Vec3>& piece : seam.course)
        for (std::size_t i = 1; i + 1 < piece.size(); ++i) {
            const Continuity there = continuity_at(a, b, piece[i]);
            ++found.places;
            found.gap_over = std::max(found.gap_over, over(there.gap, seam.gap));
            if (there.angle)
                found.angle_over = std::max(found.angle_over, over(*there.angle, *seam.angle));
        }
    const Continuity widest = continuity_at(a, b, seam.gap.place);
    found.gap_at_worst = std::max(found.gap_at_worst, std::abs(widest.gap - seam.gap.value));
    const Continuity sharpest = continuity_at(a, b, seam.angle->place);
    if (sharpest.angle)
        found.angle_at_worst =
            std::max(found.angle_at_worst, std::abs(*sharpest.angle - seam.angle->value));
}

Agreement agreement_on(const std::string& name) {
    const std::filesystem::path path = test::shared_model(name);
    const SurfaceModel model = load_model(path);
    const std::vector<FileFace> faces = faces_of(path);
    constexpr double join = 0.5;
    Agreement found;
    for (const MeasuredSeam& seam : measure_seams(model, pair_seams(model, join), {}, join).seams)
        if (seam.angle && seam.angle->value < 80 && seam.id_a != seam.id_b)
            compare(seam, faces[seam.id_a - 1], faces[seam.id_b - 1], found);
    std::printf(
        "%s: %d stretches, %d places; over the maximum by %.1e degrees, %.1e mm; at the "
        "worst place %.1e degrees, %.1e mm\n",
        name.c_str(), found.seams, found.places, found.angle_over, found.gap_over,
        found.angle_at_worst, found.gap_at_worst);
    return found;
}

TEST(SeamAgreement, NoPlaceOfRealPanelsIsSharperForOpenCascade) {
    KEIKO_NEEDS_SHARED_MODEL("car-hood.brep");
    for (const char* name :
         {"car-hood.brep", "car-front-fender.brep", "car-rear-deck-half-panel.brep"}) {
        SCOPED_TRACE(name);
        const Agreement found = agreement_on(name);
        EXPECT_GE(found.places, 31 * found.seams);
        EXPECT_LT(found.angle_over, 1e-6);
        EXPECT_LT(found.gap_over, 1e-6);
        EXPECT_LT(found.angle_at_worst, 1e-6);
        EXPECT_LT(found.gap_at_worst, 1e-6);
    }
}

} // namespace
} // namespace keiko::cad
