#include "keiko/inspect/lines/contour_curves.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/basics/face_curves.h"
#include "keiko/inspect/basics/patch_fields.h"
#include "keiko/inspect/basics/visible_pieces.h"

#include <algorithm>

namespace keiko {
namespace {

BernsteinField constant(double value) {
    return BernsteinField(0, 0, {value}, 0);
}

/// The normal times the line of sight, and powers of the weight: 0 on the contour.
BernsteinField sight_field(const PlacedPatch& patch, const BezierPatchView& view,
                           const LineEye& eye) {
    const FieldTriple normal = without_zero_sides(normal_field(view, patch.rounding));
    FieldTriple sight{constant(eye.direction.x), constant(eye.direction.y),
                      constant(eye.direction.z)};
    if (!eye.parallel) {
        const HomogeneousField s = homogeneous_field(view, patch.rounding);
        const Vec3 from_eye = patch.middle - eye.point;
        for (unsigned k = 0; k < 3; ++k) sight[k] = s.p[k] + s.w * constant(from_eye[k]);
    }
    return dot(sight, normal);
}

/// The zeros of a field on a placed patch, with copies of all that they depend on.
class OwnedZeros : public ZeroFunction {
public:
    OwnedZeros(PlacedPatch patch, const BezierPatchView& view, BernsteinField field)
        : patch_(std::move(patch)),
          view_{view.degree_u, view.degree_v, patch_.points},
          field_(std::move(field)),
          zeros_(patch_, view_, field_) {}
    OwnedZeros(const OwnedZeros&) = delete;
    OwnedZeros& operator=(const OwnedZeros&) = delete;

    double operator()(const Vec2& uv) const override { return zeros_(uv); }
    LinePoint point(const Vec2& uv) const override { return zeros_.point(uv); }

private:
    PlacedPatch patch_;
    BezierPatchView view_;
    BernsteinField field_;
    FieldZeros zeros_;
};

/// Search for the contours of one placed face.
class FaceContours {
public:
    FaceContours(const SurfaceModel& model, const PlacedFace& placed, double chord_error)
        : search_(model, placed), placed_(placed), chord_error_(chord_error) {}

    std::vector<PatchContour> run(const LineEye& eye) {
        for (const PlacedPatch& patch : search_.patches()) {
            BernsteinField field = sight_field(patch, search_.view_of(patch), eye);
            const double magnitude = field.magnitude();
            if (!(magnitude > field.rounding())) continue; // all of it is viewed edge-on
            constexpr double edge_on = 1e-12; // of the field: what counts as 0 along a side
            for (const BoundaryFactor& side : divide_sides(field, edge_on * magnitude))
                if (side.times % 2 == 1) add_side(patch, iso_field(side.by_u, side.upper ? 1 : 0));
            add(patch, std::move(field));
        }
        return std::move(found_);
    }

private:
    void add(const PlacedPatch& patch, BernsteinField field) {
        const std::vector<LineCell> cells = field_cells(field).cells;
        std::vector<PatchLine> lines = search_.pieces(patch, field, cells, chord_error_);
        if (lines.empty()) return;
        const auto function =
            std::make_shared<const OwnedZeros>(patch, search_.view_of(patch), std::move(field));
        for (PatchLine& line : lines)
            found_.push_back(
                {placed_.instance, placed_.face, patch.index, std::move(line), function});
    }

    /// The side of a patch, unless its neighbour on the face had it already.
    void add_side(const PlacedPatch& patch, BernsteinField side) {
        const std::size_t known = found_.size();
        add(patch, std::move(side));
        for (std::size_t i = known; i < found_.size();)
            if (is_known(found_[i].line, known))
                found_.erase(found_.begin() + static_cast<std::ptrdiff_t>(i));
            else
                ++i;
    }

    bool is_known(const PatchLine& line, std::size_t known) const {
        for (std::size_t i = 0; i < known; ++i)
            if (is_same(line, found_[i].line)) return true;
        return false;
    }

    /// True if two lines have the same ends and the same middle.
    static bool is_same(const PatchLine& a, const PatchLine& b) {
        const auto meet = [](const LinePoint& p, const LinePoint& q) {
            return (p.place - q.place).length() <= same_curve_end;
        };
        const auto &p = a.points, &q = b.points;
        const bool alike = meet(p.front(), q.front()) && meet(p.back(), q.back());
        const bool turned = meet(p.front(), q.back()) && meet(p.back(), q.front());
        return (alike || turned) &&
               meet(p[p.size() / 2], q[alike ? q.size() / 2 : (q.size() - 1) / 2]);
    }

    FaceCurveSearch search_;
    PlacedFace placed_;
    double chord_error_;
    std::vector<PatchContour> found_;
};

/// The contours of one face as curves.
std::vector<ContourLine> joined_contours(std::span<const PatchContour> of_face) {
    std::vector<PatchLine> pieces;
    for (const PatchContour& contour : of_face) pieces.push_back(contour.line);
    std::vector<ContourLine> contours;
    for (FaceCurve& curve : joined_pieces(pieces))
        contours.push_back({of_face.front().instance, of_face.front().face, curve.closed,
                            curve.proved, curve.length, curve.deviation, std::move(curve.points)});
    return contours;
}

} // namespace

std::vector<PatchContour> patch_contours(const SurfaceModel& model, const LineEye& eye,
                                         double chord_error, const Job& job) {
    const std::vector<PlacedFace> faces = placed_faces(model);
    std::vector<std::vector<PatchContour>> found(faces.size());
    parallel_for(faces.size(), job, "contours", [&](std::size_t i) {
        found[i] = FaceContours(model, faces[i], chord_error).run(eye);
    });
    std::vector<PatchContour> contours;
    for (std::vector<PatchContour>& of_face : found)
        std::move(of_face.begin(), of_face.end(), std::back_inserter(contours));
    return contours;
}

std::vector<ContourLine> contour_curves(const SurfaceModel& model, const LineEye& eye,
                                        double chord_error, const Job& job) {
    const std::vector<PatchContour> pieces = patch_contours(model, eye, chord_error, job);
    std::vector<ContourLine> curves;
    for (auto first = pieces.begin(); first != pieces.end();) {
        const auto last = std::find_if(first, pieces.end(), [&](const PatchContour& piece) {
            return piece.instance != first->instance || piece.face != first->face;
        });
        for (ContourLine& curve : joined_contours({first, last}))
            curves.push_back(std::move(curve));
        first = last;
    }
    return curves;
}

} // namespace keiko
