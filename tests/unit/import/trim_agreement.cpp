#include "tests/unit/import/trim_agreement.h"

#include "keiko/geometry/trim/trim_region.h"
#include "keiko/import/cad/surface_patches.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include <optional>
#include <random>

namespace keiko::cad {
namespace {

/// The patch of a face that holds a place of its parameters, if any.
const Patch* patch_at(const SurfaceModel& model, const Face& face, const Vec2& at) {
    for (const Patch& p : model.patches_of(face))
        if (p.map_u.begin <= at.x && at.x <= p.map_u.end && p.map_v.begin <= at.y &&
            at.y <= p.map_v.end)
            return &p;
    return nullptr;
}

/// mm per unit of u and v at a place of a patch.
Vec2 lengths_at(const SurfaceModel& model, const Patch& patch, const Vec2& at) {
    const auto index = static_cast<std::uint32_t>(&patch - model.patches.data());
    const Vec2 uv(patch.map_u.to_patch(at.x), patch.map_v.to_patch(at.y));
    const SurfaceDerivatives s = evaluate(model.patch(index), uv, 1);
    return {s.du().length() / patch.map_u.derivative(uv.x),
            s.dv().length() / patch.map_v.derivative(uv.y)};
}

/// u where the chord from a to b crosses the line of constant v, if it does.
std::optional<double> crossing(const gp_Pnt2d& a, const gp_Pnt2d& b, double v) {
    if ((a.Y() <= v) == (b.Y() <= v)) return std::nullopt;
    return a.X() + (b.X() - a.X()) * (v - a.Y()) / (b.Y() - a.Y());
}

/// Whether a ray to rising u crosses the file's own p-curves an odd number of times, each curve
/// taken as many short chords. On a closed surface a curve counts wherever whole periods move it.
bool material_by_curves(const TopoDS_Face& face, const Vec2& at) {
    constexpr int chords = 20000, most_turns = 2;
    const Vec2 period = periods(*untrimmed(BRep_Tool::Surface(face)));
    bool inside = false;
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
        double first = 0, last = 0;
        const auto curve = BRep_Tool::CurveOnSurface(TopoDS::Edge(e.Current()), face, first, last);
        if (curve.IsNull()) continue;
        gp_Pnt2d a = curve->Value(first);
        for (int i = 1; i <= chords; ++i) {
            const gp_Pnt2d b =
                curve->Value(i == chords ? last : first + (last - first) * i / chords);
            for (int j = period.y > 0 ? -most_turns : 0; j <= (period.y > 0 ? most_turns : 0); ++j)
                if (const auto u = crossing(a, b, at.y + j * period.y))
                    for (int k = period.x > 0 ? -most_turns : 0;
                         k <= (period.x > 0 ? most_turns : 0); ++k)
                        if (at.x + k * period.x < *u) inside = !inside;
            a = b;
        }
    }
    return inside;
}

class FaceComparison {
public:
    FaceComparison(const SurfaceModel& model, const Face& face, const TopoDS_Face& shape,
                   TrimTally& tally)
        : model_(model),
          face_(face),
          shape_(TopoDS::Face(shape.Oriented(TopAbs_FORWARD))),
          material_(model, face),
          classifier_(shape_, 1e-9),
          tally_(tally) {}

    void sample(std::size_t count) {
        const Box2 box = material_.bounds();
        const Vec2 extent = box.extent();
        std::mt19937_64 random(face_.id);
        std::uniform_real_distribution<double> unit(0, 1);
        for (std::size_t i = 0; i < count; ++i)
            compare({box.lower.x + extent.x * unit(random), box.lower.y + extent.y * unit(random)});
    }

private:
    static constexpr double anywhere = 1e9; // mm

    void compare(const Vec2& at) {
        const Patch* patch = patch_at(model_, face_, at);
        if (!patch) return; // beyond the end of the surface there is nothing to trim
        ++tally_.samples;
        const bool ours = material_.contains(at);
        const TopAbs_State state = classifier_.Perform(gp_Pnt2d(at.x, at.y), true);
        const bool decided = state == TopAbs_IN || state == TopAbs_OUT;
        if (decided && (state == TopAbs_IN) == ours) return;
        const ParameterMetric lengths(lengths_at(model_, *patch, at));
        if (material_.nearest_edge(at, lengths, anywhere)) {
            ++tally_.at_border;
        } else if (!decided) {
            ++tally_.undecided;
        } else {
            const auto near = material_.nearest_curve(at, lengths, anywhere);
            tally_.disagreements.push_back({model_.describe(face_), at, ours, valid(),
                                            material_by_curves(shape_, at) == ours,
                                            near ? near->distance : anywhere});
        }
    }

    bool valid() const { return BRepCheck_Analyzer(shape_).IsValid(); }

    const SurfaceModel& model_;
    const Face& face_;
    TopoDS_Face shape_;
    TrimRegion material_;
    BRepTopAdaptor_FClass2d classifier_;
    TrimTally& tally_;
};

} // namespace

TrimTally compare_trims(const CadDocument& document, const SurfaceModel& model,
                        std::size_t samples) {
    std::vector<TopoDS_Face> shapes;
    for (const CadPart& part : document.parts) {
        TopTools_IndexedMapOfShape map;
        TopExp::MapShapes(part.shape, TopAbs_FACE, map);
        for (int i = 1; i <= map.Extent(); ++i) shapes.push_back(TopoDS::Face(map(i)));
    }
    std::size_t trimmed = 0;
    for (const Face& face : model.faces) trimmed += face.loop_count > 0;
    TrimTally tally;
    for (const Face& face : model.faces)
        if (face.loop_count > 0)
            FaceComparison(model, face, shapes.at(face.id - 1), tally)
                .sample((samples + trimmed - 1) / trimmed);
    return tally;
}

} // namespace keiko::cad
