#include "keiko/base/units.h"
#include "keiko/inspect/seam_measure.h"
#include "keiko/io/load_model.h"

#include "tests/support/paths.h"
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <LocalAnalysis_SurfaceContinuity.hxx>
#include <TopExp.hxx>
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

/// The faces of a BREP file in the order of their ids.
class FileFaces {
public:
    explicit FileFaces(const std::filesystem::path& path) {
        BRepTools::Read(shape_, path.c_str(), BRep_Builder());
        TopExp::MapShapes(shape_, TopAbs_FACE, faces_);
    }

    Handle(Geom_Surface) surface(std::uint32_t id) const {
        return BRep_Tool::Surface(TopoDS::Face(faces_(static_cast<int>(id))));
    }

private:
    TopoDS_Shape shape_;
    TopTools_IndexedMapOfShape faces_;
};

/// Degrees between the normals of two surfaces at the feet of a place, 0 to 90; nullopt where
/// OpenCASCADE finds no foot within `reach` mm or no normal.
std::optional<double> angle_at(const Handle(Geom_Surface) & a, const Handle(Geom_Surface) & b,
                               const Vec3& place, double reach) {
    const gp_Pnt point(place.x, place.y, place.z);
    GeomAPI_ProjectPointOnSurf on_a(point, a), on_b(point, b);
    if (on_a.NbPoints() == 0 || on_b.NbPoints() == 0) return std::nullopt;
    if (on_a.LowerDistance() > reach || on_b.LowerDistance() > reach) return std::nullopt;
    double ua = 0, va = 0, ub = 0, vb = 0;
    on_a.LowerDistanceParameters(ua, va), on_b.LowerDistanceParameters(ub, vb);
    LocalAnalysis_SurfaceContinuity local(a, ua, va, b, ub, vb, GeomAbs_G1, 1e-12, reach + 1, 1e-3,
                                          1e-3, 1e-3, 0.1, 1e9);
    if (!local.IsDone()) return std::nullopt;
    return radians_to_degrees(local.G1Angle());
}

struct Agreement {
    int places = 0, skipped = 0, seams = 0;
    double most_over = 0;     ///< degrees, of a place over the seam's maximum and its bound
    double most_at_worst = 0; ///< degrees, at the place that is told to be the worst
};

Agreement agreement_on(const std::string& name) {
    const std::filesystem::path path = test::shared_model(name);
    const SurfaceModel model = load_model(path);
    const FileFaces faces(path);
    constexpr double join = 0.5;
    Agreement found;
    for (const MeasuredSeam& seam : measure_seams(model, pair_seams(model, join), {}, join).seams) {
        if (!seam.angle || seam.kind == SeamClass::fold || seam.angle->value > 80) continue;
        ++found.seams;
        const auto a = faces.surface(seam.id_a), b = faces.surface(seam.id_b);
        const double reach = seam.gap.value + 1e-3;
        for (const std::vector<Vec3>& piece : seam.course)
            for (std::size_t i = 1; i + 1 < piece.size(); ++i) {
                const auto angle = angle_at(a, b, piece[i], reach);
                ++(angle ? found.places : found.skipped);
                if (!angle) continue;
                const double over = *angle - seam.angle->value - seam.angle->bound;
                found.most_over = std::max(found.most_over, over);
            }
        if (const auto worst = angle_at(a, b, seam.angle->place, reach))
            found.most_at_worst =
                std::max(found.most_at_worst, std::abs(*worst - seam.angle->value));
    }
    std::printf(
        "%s: %d stretches, %d places (%d without a foot), over the maximum by %.2e, at the "
        "worst place %.2e degrees\n",
        name.c_str(), found.seams, found.places, found.skipped, found.most_over,
        found.most_at_worst);
    return found;
}

TEST(SeamAgreement, NoPlaceOfRealPanelsIsSharperForOpenCascade) {
    KEIKO_NEEDS_SHARED_MODEL("car-hood.brep");
    for (const char* name :
         {"car-hood.brep", "car-front-fender.brep", "car-rear-deck-half-panel.brep"}) {
        SCOPED_TRACE(name);
        const Agreement found = agreement_on(name);
        EXPECT_GT(found.places, 20 * found.seams);
        // The feet of a place on both surfaces lie up to the gap apart along a curved surface.
        EXPECT_LT(found.most_over, 2e-3);
        EXPECT_LT(found.most_at_worst, 2e-3);
    }
}

} // namespace
} // namespace keiko::cad
