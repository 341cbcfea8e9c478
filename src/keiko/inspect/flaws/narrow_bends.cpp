#include "keiko/inspect/flaws/narrow_bends.h"

#include "keiko/base/parallel.h"
#include "keiko/base/units.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/inspect/flaws/face_surface.h"
#include "keiko/inspect/seams/face_strips.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace keiko {
namespace {

using FaceKey = std::pair<std::uint32_t, std::uint32_t>; ///< instance and face

/// A face with the sides of its seams.
struct SidedFace {
    SidedFace(const SurfaceModel& model, const FaceKey& key, const std::vector<SeamSide>& sides)
        : surface(model, key.first, key.second), strips(model, {key.first, key.second}, sides) {}

    FaceSurface surface;
    FaceStrips strips;
};

/// A place on the way square to a seam.
struct WayPoint {
    double s = 0;         ///< mm from the seam
    Vec3 normal{0};       ///< unit; all on one side of the surface
    double curvature = 0; ///< 1/mm, of the way
    PlacedFace face;
};

/// The surface at a place `distance` mm from a border, square to it.
class PlaceInside {
public:
    PlaceInside(const FaceSurface& face, const Vec2& from, const BoundaryFrame& frame)
        : face_(face), from_(from), frame_(frame) {}

    /// nullopt if material ends before, or bends by more than a right angle.
    std::optional<SurfaceDerivatives> at(double distance) const {
        const auto begin = face_.evaluate_beyond(from_, 1);
        if (!begin) return std::nullopt;
        const Vec2 step = solved(*begin, {1, 0});
        auto place = refined(from_ + step * distance, distance);
        if (!place) place = refined(from_ + step * reach(step, distance), distance);
        if (!place || !face_.has_material(*place)) return std::nullopt;
        return face_.evaluate_beyond(*place, 2);
    }

private:
    Vec2 flat(const Vec3& v) const { return {v.dot(frame_.inward), v.dot(frame_.tangent)}; }

    /// The step of the parameters that leads by `way` in the tangent plane of the border.
    Vec2 solved(const SurfaceDerivatives& s, const Vec2& way) const {
        const Vec2 u = flat(s.du()), v = flat(s.dv());
        return Vec2(way.cross(v), u.cross(way)) / u.cross(v);
    }

    /// Newton's method; nullopt if it does not converge at once.
    std::optional<Vec2> refined(Vec2 place, double distance) const {
        constexpr int most = 5;
        constexpr double close = 1e-3, farthest = 0.5; // shares of the distance
        for (int i = 0; i < most; ++i) {
            const auto s = face_.evaluate_beyond(place, 1);
            if (!s) return std::nullopt;
            const Vec2 off = Vec2(distance, 0) - flat(s->position() - frame_.position);
            if (off.length() < close * distance) return place;
            if (!(off.length() < farthest * distance)) return std::nullopt;
            place += solved(*s, off);
        }
        return std::nullopt;
    }

    /// How far to follow a direction of the parameters to be about `distance` mm away. Speeds may
    /// grow by orders of magnitude from where control points nearly coincide.
    double reach(const Vec2& step, double distance) const {
        const auto is_beyond = [&](double length) {
            const auto s = face_.evaluate_beyond(from_ + step * length, 0);
            return !s || flat(s->position() - frame_.position).x >= distance;
        };
        double below = 0, above = 1e-6 * distance;
        constexpr double growth = 4, enough = 1e-3;
        constexpr int most = 40;
        for (int i = 0; i < most && !is_beyond(above); ++i) below = above, above *= growth;
        while (above - below > enough * above) {
            const double middle = (below + above) / 2;
            (is_beyond(middle) ? above : below) = middle;
        }
        return above;
    }

    const FaceSurface& face_;
    Vec2 from_;
    const BoundaryFrame& frame_;
};

/// The turn of the normal between two places of a way, degrees, beyond what the curvatures at
/// either explain; 0 if that is less than these make. `run`: of the seam.
double unexplained_turn(const WayPoint& from, const WayPoint& into, const Vec3& run) {
    const double way = into.s - from.s;
    const double turn =
        -std::atan2(from.normal.cross(into.normal).dot(run), from.normal.dot(into.normal));
    const double low = way * std::min({0.0, from.curvature, into.curvature});
    const double high = way * std::max({0.0, from.curvature, into.curvature});
    const double beyond = std::max({0.0, turn - high, low - turn});
    return beyond >= std::max(high, -low) ? radians_to_degrees(beyond) : 0;
}

using SidedFaces = std::map<FaceKey, SidedFace>;

/// The ways over the surface that lead square away from seams.
class Ways {
public:
    explicit Ways(const SidedFaces& faces) : faces_(faces) {}

    /// The way into a face from a place of its border, up to `reach` mm; it ends where material
    /// does, or at a crease. `run`: of the seam, to whose left the material lies
    /// where seen against the normals.
    std::vector<WayPoint> from(PlacedFace face, SurfaceCurve border, double t, const Vec3& run,
                               double reach) const {
        std::vector<WayPoint> way;
        double begin = 0;
        constexpr int most_faces = 64;
        for (int i = 0; i < most_faces; ++i) {
            const auto next = over(face, border, t, run, begin, reach, way);
            if (!next) break;
            const SeamSide& side = faces_.at(key_of(face)).strips.sides()[next->side_far];
            if (!side.leads_on || side.is_inside) break;
            begin += next->width();
            t = parameter_beyond(side, next->t_far, next->far.position);
            face = side.neighbour, border = side.beyond.curve;
        }
        return way;
    }

private:
    static FaceKey key_of(const PlacedFace& face) { return {face.instance, face.face}; }

    /// Adds the places of a way on one face; the place of the next seam, if the way is complete up
    /// to it.
    std::optional<StripPlace> over(const PlacedFace& face, const SurfaceCurve& border, double t,
                                   const Vec3& run, double begin, double reach,
                                   std::vector<WayPoint>& way) const {
        const auto frame = border.frame(t);
        if (!frame) return std::nullopt;
        const SidedFace& sided = faces_.at(key_of(face));
        const double sign = frame->inward.cross(run).dot(frame->normal) > 0 ? 1 : -1;
        const auto add = [&](double s, const Vec3& normal, const SurfaceDerivatives& surface) {
            const double k = normal_curvature(surface, normal, run.cross(normal));
            way.push_back({s, normal, k, face});
        };
        add(begin, frame->normal * sign, frame->surface);
        auto next = sided.strips.nearest(border, t, reach - begin);
        const double end = next ? begin + next->width() : HUGE_VAL;
        const PlaceInside inside(sided.surface, sided.surface.place_of(border.parameters(t)),
                                 *frame);
        for (const double share : {0.125, 0.25, 0.5, 1.0}) {
            const double s = share * reach;
            if (!(s > begin && s < end)) continue;
            const auto surface = inside.at(s - begin);
            if (!surface) return std::nullopt;
            add(s, surface->du().cross(surface->dv()).normalized() * sign, *surface);
        }
        return next;
    }

    const SidedFaces& faces_;
};

/// The face of a way at a distance from the seam.
const PlacedFace& face_at(const std::vector<WayPoint>& way, double s) {
    const auto beyond = std::find_if(way.begin() + 1, way.end(),
                                     [&](const WayPoint& p) { return std::abs(p.s) > s; });
    return (beyond - 1)->face;
}

class BendSearch {
public:
    BendSearch(const ModelBorders& borders, std::span<const Seam> pieces, const FaceLimits& limits,
               const SidedFaces& faces)
        : borders_(borders), pieces_(pieces), limits_(limits), ways_(faces) {}

    /// The worst bend about a seam, with the length of all.
    std::optional<NarrowBend> about(const MeasuredSeam& seam) const {
        NarrowBend worst;
        for (const std::uint32_t i : seam.pieces) add_piece(seam.negligible, pieces_[i], worst);
        return worst.length > seam.negligible ? std::optional(worst) : std::nullopt;
    }

private:
    void add_piece(double negligible, const Seam& piece, NarrowBend& worst) const {
        constexpr int cells = 16;
        constexpr double end = 1e-6; // share of the piece: at its ends material may end, too
        const SeamProbe probe(borders_.curves, piece);
        std::vector<SeamStep> steps = probe.steps(cells);
        const double short_of_end = end * (probe.end() - probe.begin());
        steps.front().t += short_of_end, steps.back().t -= short_of_end;
        bool before = false;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const auto bend = bend_at(negligible, piece, probe.at(steps[i].t, steps[i].s));
            if (bend && before) worst.length += probe.length(steps[i - 1].t, steps[i].t);
            if (bend && bend->angle > worst.angle) {
                const double length = worst.length;
                worst = *bend, worst.length = length;
            }
            before = bend.has_value();
        }
    }

    /// The largest bend at a place of a seam, without length.
    std::optional<NarrowBend> bend_at(double negligible, const Seam& piece,
                                      const SeamPoint& at) const {
        const SurfaceCurve a = borders_.curves.curve(piece.a), b = borders_.curves.curve(piece.b);
        const PlacedFace on_a{piece.a.instance, piece.a.face}, on_b{piece.b.instance, piece.b.face};
        const CriteriaPreset& limits = limits_.between(on_a, on_b);
        const auto frame = a.frame(at.t);
        if (!frame) return std::nullopt;
        const Vec3& run = frame->tangent;
        const auto ahead = ways_.from(on_b, b, at.s, run, negligible);
        auto behind = ways_.from(on_a, a, at.t, -run, negligible);
        for (WayPoint& p : behind) p.s = -p.s;
        constexpr double rounding = 1e-9;
        NarrowBend worst;
        for (const WayPoint& from : behind)
            for (const WayPoint& into : ahead) {
                const double width = into.s - from.s, angle = unexplained_turn(from, into, run);
                const bool is_worse = angle > worst.angle * (1 + rounding) ||
                                      (angle >= worst.angle && width < worst.width);
                if (width > negligible * (1 + rounding) || !is_worse) continue;
                const double middle = (from.s + into.s) / 2;
                const auto& on = middle < 0 ? behind : ahead;
                worst = {face_at(on, std::abs(middle)),
                         {from.face, into.face},
                         {on_a, on_b},
                         width,
                         angle,
                         0,
                         at.place};
            }
        const double own = at.angle.value_or(0); // judged by itself where it does not pass
        const double least = limits.angle + (own > limits.angle ? own : 0);
        const bool bends = worst.angle > least && worst.angle < limits.feature_angle;
        return bends ? std::optional(worst) : std::nullopt;
    }

    const ModelBorders& borders_;
    std::span<const Seam> pieces_;
    const FaceLimits& limits_;
    Ways ways_;
};

bool is_smooth(const MeasuredSeam& seam) {
    return !seam.internal && !seam.scrap && seam.kind == SeamClass::smooth;
}

} // namespace

std::vector<NarrowBend> narrow_bends(const ModelBorders& borders,
                                     std::span<const MeasuredSeam> seams,
                                     std::span<const Seam> pieces, const FaceLimits& limits,
                                     const Job& job) {
    const SeamSides sides(borders, seams, pieces);
    SidedFaces faces;
    for (const auto& [key, of_face] : sides.by_face())
        faces.try_emplace(key, borders.model, key, of_face);
    const BendSearch search(borders, pieces, limits, faces);
    std::vector<std::optional<NarrowBend>> found(seams.size());
    parallel_for(seams.size(), job, "", [&](std::size_t i) {
        if (is_smooth(seams[i])) found[i] = search.about(seams[i]);
    });
    std::map<FaceKey, NarrowBend> worst;
    for (const auto& bend : found) {
        if (!bend) continue;
        NarrowBend& of_face = worst[{bend->face.instance, bend->face.face}];
        if (bend->angle > of_face.angle) of_face = *bend;
    }
    std::vector<NarrowBend> bends;
    for (const auto& [face, bend] : worst) bends.push_back(bend);
    return bends;
}

} // namespace keiko
