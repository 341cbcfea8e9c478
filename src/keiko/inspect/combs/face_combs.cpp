#include "keiko/inspect/combs/face_combs.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Shares of the body's size: the distance between trim tests on a curve; the largest distance from
/// a plane in which a place lies; the distance beside a curve within which it borders material.
/// Each applies to the body as a whole.
constexpr double trim_step = 1e-3, in_plane = 1e-9, border_width = 1e-9;
/// Length below which a curve is a point, as a share of the body's size.
constexpr double point_share = 1e-6;
/// Distance from a plane within which a place counts as touched, in units of `in_plane`.
constexpr double near_plane = 1000;

/// The steps in a patch's parameters across the zeros of a field and along them.
class FieldSlopes {
public:
    explicit FieldSlopes(const BernsteinField& f)
        : u_(f.derivative(true)),
          v_(f.derivative(false)),
          uu_(u_.derivative(true)),
          uv_(u_.derivative(false)),
          vv_(v_.derivative(false)) {}

    Vec2 across(const Vec2& at) const { return {u_(at), v_(at)}; }
    Vec2 along(const Vec2& at) const { return {v_(at), -u_(at)}; }
    /// Derivative of `along` in its own direction.
    Vec2 turning(const Vec2& at) const {
        const Vec2 way = along(at);
        const double mixed = uv_(at);
        return {mixed * way.x + vv_(at) * way.y, -uu_(at) * way.x - mixed * way.y};
    }

private:
    BernsteinField u_, v_, uu_, uv_, vv_;
};

/// Orients `towards` to the left of the direction of the samples.
void turn_left(std::vector<CombSample>& samples, const Vec3& plane) {
    if (samples.size() < 2) return;
    const Vec3 way = samples[1].place - samples[0].place;
    if (plane.cross(way).dot(samples[0].bend.towards) < 0)
        for (CombSample& sample : samples) turn_over(sample.bend);
}

double length_of(const CombPiece& piece) {
    double length = 0;
    for (std::size_t i = 1; i < piece.samples.size(); ++i)
        length += (piece.samples[i].place - piece.samples[i - 1].place).length();
    return length;
}

/// A place well inside of a line.
LinePoint middle_of(const FieldZeros& zeros, const PatchLine& line) {
    const std::size_t half = line.points.size() / 2;
    const LinePoint &a = line.points[half - 1], &b = line.points[half];
    return zeros.between(a, b, 0.5).value_or(b);
}

bool passes(const std::vector<CombPiece>& pieces, const Vec3& place, double reach) {
    return std::any_of(pieces.begin(), pieces.end(), [&](const CombPiece& piece) {
        return std::any_of(piece.samples.begin(), piece.samples.end(), [&](const CombSample& s) {
            return (s.place - place).length() <= reach;
        });
    });
}

/// Places that no piece passes; of several near each other only one.
std::vector<Vec3> beside(const std::vector<Vec3>& places, const std::vector<CombPiece>& pieces,
                         double reach) {
    std::vector<Vec3> found;
    for (const Vec3& place : places) {
        const bool known = std::any_of(found.begin(), found.end(), [&](const Vec3& other) {
            return (other - place).length() <= 2 * reach;
        });
        if (!known && !passes(pieces, place, reach)) found.push_back(place);
    }
    return found;
}

} // namespace

struct FaceCombs::PatchUse {
    PlacedPatch patch;
    BezierPatchView view;

    PatchUse(const SurfaceModel& model, std::uint32_t index, const Affine& placed)
        : patch(model, index, placed), view(model.patch(index)) {
        view.points = patch.points;
    }
    PatchUse(const PatchUse&) = delete;
    PatchUse& operator=(const PatchUse&) = delete;

    Vec3 place(const Vec2& uv) const { return patch.middle + evaluate(view, uv, 0).position(); }
    /// The step in parameters that is about `length` mm on the surface.
    Vec2 step(const Vec2& uv, const Vec2& direction, double length) const {
        const SurfaceDerivatives s = evaluate(view, uv, 1);
        const double speed = (s.du() * direction.x + s.dv() * direction.y).length();
        return speed > 0 ? direction * (length / speed) : Vec2(0);
    }
};

FaceCombs::FaceCombs(const SurfaceModel& model, const PlacedFace& placed,
                     const CombOptions& options, double size)
    : model_(model),
      placed_(placed),
      face_(model.faces[placed.face]),
      trims_(model, face_),
      options_(options),
      size_(size) {
    for (std::uint32_t p = 0; p < face_.patch_count; ++p)
        for (const Vec2& corner : {Vec2(0), Vec2(1)})
            domain_.extend(model.face_parameters(face_.first_patch + p, corner));
    const bool mirrored = model.instances[placed.instance].transform.mirrored();
    sign_ = face_.reversed != mirrored ? -1 : 1;
}

bool FaceCombs::is_material(std::uint32_t patch, const Vec2& uv) const {
    return trims_.untrimmed() || trims_.contains(model_.face_parameters(patch, uv));
}

FaceSection FaceCombs::section(const SectionPlane& plane) const {
    FaceSection section;
    const Affine& placed = model_.instances[placed_.instance].transform;
    for (std::uint32_t p = face_.first_patch; p < face_.first_patch + face_.patch_count; ++p)
        add_section({model_, p, placed}, plane, section);
    section.touched = beside(section.touched, section.pieces, trim_step * size_);
    return section;
}

void FaceCombs::add_section(const PatchUse& patch, const SectionPlane& plane,
                            FaceSection& section) const {
    const PlaneMeeting meeting = plane_meeting(patch.patch, patch.view, plane, in_plane * size_);
    section.within = section.within || meeting.within;
    for (const Vec2& uv : meeting.doubtful)
        if (std::abs(meeting.height(uv)) <= near_plane * meeting.tolerance &&
            is_material(patch.patch.index, uv))
            section.touched.push_back(patch.place(uv));
    for (const MeetingField& curve : meeting.fields)
        for (CombPiece& piece : meeting_pieces(patch, meeting, curve, plane)) {
            // Where the plane is tangent at a point, and at a pole, the result is only a place.
            const double least = curve.touching ? trim_step : point_share;
            if (length_of(piece) < least * size_) {
                section.touched.push_back(piece.samples.front().place);
                continue;
            }
            if (curve.touching) turn_left(piece.samples, plane.normal);
            section.pieces.push_back(std::move(piece));
        }
}

/// A curve may run along a trim: it is on material if there is material on either side of it.
std::vector<CombPiece> FaceCombs::meeting_pieces(const PatchUse& patch, const PlaneMeeting& meeting,
                                                 const MeetingField& curve,
                                                 const SectionPlane& plane) const {
    const FieldSlopes slopes(curve.field);
    const auto material_at = [&](const LinePoint& at, double side) {
        const Vec2 step = patch.step(at.uv, slopes.across(at.uv), side * border_width * size_);
        return is_material(patch.patch.index, at.uv + step);
    };
    CurveRules rules;
    rules.material = [&](const LinePoint& at) {
        if (curve.touching && std::abs(meeting.height(at.uv)) > meeting.tolerance) return false;
        if (curve.touching && !curve.on_side && curve.by_u != meeting.steep_by_u(at.uv))
            return false;
        return is_material(patch.patch.index, at.uv) || material_at(at, 1) || material_at(at, -1);
    };
    rules.on_border = [&](const LinePoint& at) {
        return curve.on_side || !material_at(at, 1) || !material_at(at, -1);
    };
    rules.bend = [&](const SurfaceDerivatives& s, const Vec2& uv, const Vec3& normal) {
        return curve.touching ? touching_bend(s, plane.normal, slopes.along(uv), slopes.turning(uv))
                              : section_bend(s, normal * sign_, plane.normal);
    };
    return pieces(patch, curve, rules);
}

std::vector<CombPiece> FaceCombs::pieces(const PatchUse& patch, const MeetingField& curve,
                                         const CurveRules& rules) const {
    const FieldZeros zeros(patch.patch, patch.view, curve.field);
    std::vector<CombPiece> found;
    for (const PatchLine& line : material_pieces(curve.cells, zeros, options_.chord_error,
                                                 trim_step * size_, rules.material)) {
        CombPiece piece{placed_.instance, placed_.face, patch.patch.index};
        piece.on_border = rules.on_border(middle_of(zeros, line));
        piece.touching = curve.touching;
        piece.samples = comb_samples(patch.view, zeros, line, rules.bend,
                                     {options_.tolerance, options_.chord_error, size_});
        if (piece.samples.size() > 1) found.push_back(std::move(piece));
    }
    return found;
}

std::vector<CombPiece> FaceCombs::iso_curve(bool by_u, double share) const {
    const Vec2 along = by_u ? Vec2(0, 1) : Vec2(1, 0);
    CurveRules rules;
    rules.on_border = [](const LinePoint&) { return false; };
    rules.bend = [&](const SurfaceDerivatives& s, const Vec2&, const Vec3& normal) {
        return normal_bend(s, normal * sign_, along);
    };
    std::vector<CombPiece> all;
    const Affine& placed = model_.instances[placed_.instance].transform;
    for (std::uint32_t p = face_.first_patch; p < face_.first_patch + face_.patch_count; ++p) {
        const auto at = iso_parameter(p, by_u, share);
        if (!at) continue;
        rules.material = [&](const LinePoint& point) { return is_material(p, point.uv); };
        const MeetingField curve{iso_field(by_u, *at), {{unit_square, 0, true, by_u}}};
        for (CombPiece& piece : pieces({model_, p, placed}, curve, rules))
            all.push_back(std::move(piece));
    }
    return all;
}

/// Parameter of the iso-curve in a patch; nullopt if it does not run through the patch.
std::optional<double> FaceCombs::iso_parameter(std::uint32_t patch, bool by_u, double share) const {
    const auto axis = [by_u](const Vec2& p) { return by_u ? p.x : p.y; };
    const double at = axis(domain_.lower) + share * (axis(domain_.upper) - axis(domain_.lower));
    const double begin = axis(model_.face_parameters(patch, Vec2(0))),
                 end = axis(model_.face_parameters(patch, Vec2(1)));
    // A border between patches belongs to the one beyond it.
    if (!(std::min(begin, end) <= at && at < std::max(begin, end))) return std::nullopt;
    return local_share(patch, by_u, at);
}

/// The patch parameter at which a parameter of the face is reached. Parameters rise or fall all
/// along a patch, not always uniformly.
double FaceCombs::local_share(std::uint32_t patch, bool by_u, double at) const {
    const auto reached = [&](double t) {
        const Vec2 p = model_.face_parameters(patch, Vec2(t));
        return by_u ? p.x : p.y;
    };
    const bool rising = reached(0) < reached(1);
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        ((reached(middle) < at) == rising ? low : high) = middle;
    }
    return (low + high) / 2;
}

} // namespace keiko
