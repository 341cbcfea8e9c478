#include "keiko/visibility/contours/body_contour.h"

#include "keiko/geometry/model/outward_side.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/visibility/contours/contour_border.h"
#include "keiko/visibility/contours/contour_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace keiko {
namespace {

/// Shares of a border's parameter at which borders are compared.
constexpr std::array places{0.0, 0.21, 0.5, 0.79, 1.0};
/// rad, between the normals of faces that join smoothly.
constexpr double smooth = 1e-6;

Vec3 normal_of(const Vec4& plane) {
    return Vec3(plane.x, plane.y, plane.z).normalized();
}

/// The patches of a body, and their tangent planes.
class ContourPatches {
public:
    ContourPatches(const SurfaceModel& model, const Silhouettes& silhouettes, const Vec3& center)
        : model_(model), center_(center) {
        for (const OccluderPatch& patch : silhouettes.patches) {
            const double side =
                outward_side(model, patch.instance, patch.patch, patch.patch_parameters(Vec2(0.5)));
            const TrimRegion& region = silhouettes.regions[patch.face];
            const TrimSide material = side_of(patch, region);
            all_.emplace_back(patch, side, material == TrimSide::mixed ? &region : nullptr);
            is_material_.push_back(material != TrimSide::outside);
        }
    }

    /// Outer tangent plane at a place of a placed patch, as weights of homogeneous coordinates
    /// relative to the center.
    Vec4 plane(std::uint32_t instance, std::uint32_t patch, const Vec2& uv) const {
        const auto key = [](const ContourPatch& p) {
            return std::pair(p.patch().instance, p.patch().patch);
        };
        const std::pair asked(instance, patch);
        auto p = std::lower_bound(all_.begin(), all_.end(), asked,
                                  [&](const ContourPatch& a, const auto& b) { return key(a) < b; });
        while (!p->patch().uv.contains(uv) && p + 1 != all_.end() && key(p[1]) == asked) ++p;
        return p->outer_plane(uv, center_);
    }
    /// Outer tangent plane at parameters of the face, likewise.
    Vec4 plane_at_face(std::uint32_t instance, std::uint32_t patch, const Vec2& parameters) const {
        const Patch& of = model_.patches[patch];
        const Vec2 uv(of.map_u.to_patch(parameters.x), of.map_v.to_patch(parameters.y));
        return plane(instance, patch, uv);
    }

    void append_arcs(const Vec3& point, double allowed, ContourArcs& arcs) const {
        for (std::size_t i = 0; i < all_.size(); ++i)
            if (is_material_[i]) all_[i].append_arcs(point, allowed, arcs);
    }

private:
    static TrimSide side_of(const OccluderPatch& patch, const TrimRegion& region) {
        if (region.untrimmed()) return TrimSide::inside;
        constexpr double within = 1e-6; // of the patch: trim curves along its sides do not count
        Box2 box;
        box.extend(patch.face_parameters(Vec2(within)));
        box.extend(patch.face_parameters(Vec2(1 - within)));
        return region.classify(box);
    }

    const SurfaceModel& model_;
    Vec3 center_;
    std::vector<ContourPatch> all_; ///< by instance, then by patch
    std::vector<bool> is_material_; ///< a patch
};

/// A border of a face, by places along it.
struct FaceBorder {
    BoundaryInterval interval;
    SurfaceCurve curve;
    std::array<Vec3, places.size()> points{Vec3(0), Vec3(0), Vec3(0), Vec3(0), Vec3(0)};
    bool is_used = false;

    /// True for one that runs along this one backwards.
    bool runs_back(const FaceBorder& other, double near) const {
        for (std::size_t i = 0; i < places.size(); ++i)
            if ((points[i] - other.points[places.size() - 1 - i]).length() > near) return false;
        return true;
    }
};

/// Makes the borders of a body's faces: those that join two smoothly are none.
class BorderMaker {
public:
    BorderMaker(const BoundaryCurves& curves, const ContourPatches& patches, const Vec3& center,
                double size)
        : curves_(curves), patches_(patches), center_(center), size_(size) {}

    std::vector<ContourBorder> all() const {
        constexpr double deviation = 1e-7, near = 1e-8; // of the size
        std::vector<FaceBorder> borders = face_borders();
        std::vector<ContourBorder> all;
        for (auto border = borders.begin(); border != borders.end(); ++border) {
            if (border->is_used) continue;
            const auto partner = std::find_if(border + 1, borders.end(), [&](const FaceBorder& o) {
                return !o.is_used && border->runs_back(o, near * size_);
            });
            const bool is_edge = partner != borders.end();
            if (is_edge) partner->is_used = true;
            if (is_edge && joins_smoothly(*border, *partner)) continue;
            all.emplace_back(curve_of(*border, is_edge ? &*partner : nullptr), deviation * size_);
        }
        return all;
    }

private:
    std::vector<FaceBorder> face_borders() const {
        constexpr double point = 1e-9; // of the size: what is shorter is one
        std::vector<FaceBorder> borders;
        for (const BoundaryInterval& interval : curves_.all()) {
            FaceBorder border{interval, curves_.curve(interval)};
            if (!(border.curve.length(0, 1) > point * size_)) continue;
            for (std::size_t i = 0; i < places.size(); ++i)
                border.points[i] = border.curve.at(places[i]).position;
            borders.push_back(std::move(border));
        }
        return borders;
    }

    std::function<Vec4(double)> plane_along(const FaceBorder& border, bool backwards) const {
        return [patches = &patches_, border, backwards](double t) {
            const double own = backwards ? 1 - t : t;
            return patches->plane_at_face(border.interval.instance, border.curve.patch_at(own),
                                          border.curve.parameters(own));
        };
    }

    BorderSide side_of(const FaceBorder& border, bool backwards) const {
        BorderSide side{plane_along(border, backwards)};
        for (const double t : {0.5, 0.21, 0.79})
            if (const auto frame = border.curve.frame(t)) {
                const Vec3 along = backwards ? -frame->tangent : frame->tangent;
                const Vec3 normal = normal_of(side.plane(backwards ? 1 - t : t));
                side.sense = normal.cross(along).dot(frame->inward) > 0 ? 1 : -1;
                break;
            }
        return side;
    }

    bool joins_smoothly(const FaceBorder& a, const FaceBorder& b) const {
        const auto own = plane_along(a, false), other = plane_along(b, true);
        return std::all_of(places.begin(), places.end(), [&](double t) {
            return angle_between(normal_of(own(t)), normal_of(other(t))) <= smooth;
        });
    }

    /// True if a border goes on with another direction after its end, or before its begin.
    bool turns(const FaceBorder& border, bool after) const {
        const SurfaceCurve next = curves_.curve(curves_.beside(border.interval, after));
        const Vec3 own = border.curve.at(after ? 1 : 0).first, other = next.at(after ? 0 : 1).first;
        return !(angle_between(own, other) <= smooth);
    }

    BorderCurve curve_of(const FaceBorder& border, const FaceBorder* partner) const {
        BorderCurve curve;
        curve.at = [of = border.curve, center = center_](double t) {
            const SurfaceCurve::Point at = of.at(t);
            return BorderCurve::Point{at.position - center, at.first};
        };
        curve.kinks = border.curve.patch_changes(0, 1);
        curve.own = side_of(border, false);
        curve.turns_at_begin = turns(border, false), curve.turns_at_end = turns(border, true);
        if (!partner) return curve;
        curve.other = side_of(*partner, true);
        for (const double t : partner->curve.patch_changes(0, 1)) curve.kinks.push_back(1 - t);
        std::sort(curve.kinks.begin(), curve.kinks.end());
        const auto same = [](double a, double b) { return b - a < 1e-9; };
        curve.kinks.erase(std::unique(curve.kinks.begin(), curve.kinks.end(), same),
                          curve.kinks.end());
        return curve;
    }

    const BoundaryCurves& curves_;
    const ContourPatches& patches_;
    Vec3 center_;
    double size_;
};

/// True if the patches of a placed face join smoothly, as far as six places on their sides tell.
bool is_smooth(const SurfaceModel& model, std::uint32_t instance, const Face& face,
               const TrimRegion& region, const ContourPatches& patches) {
    constexpr double out = 1e-3; // of a patch, beyond its side
    const std::array sides{Vec2(0, 0.31), Vec2(1, 0.57), Vec2(0.31, 0),
                           Vec2(0.57, 1), Vec2(0, 0.83), Vec2(0.83, 0)};
    const PatchGrid grid(model, face);
    for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p)
        for (const Vec2& uv : sides) {
            const Vec2 at = model.face_parameters(p, uv);
            const Vec2 from_middle = at - model.face_parameters(p, Vec2(0.5));
            const std::uint32_t next = grid.locate(at, from_middle * out);
            if (next == p || !(region.untrimmed() || region.contains(at))) continue;
            const Vec3 own = normal_of(patches.plane(instance, p, uv));
            const Vec3 other = normal_of(patches.plane_at_face(instance, next, at));
            if (!(angle_between(own, other) <= smooth)) return false;
        }
    return true;
}

/// True if no face has a crease inside.
bool are_smooth(const SurfaceModel& model, const Silhouettes& silhouettes,
                const ContourPatches& patches) {
    for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
        const Part& part = model.parts[model.instances[i].part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f)
            if (!is_smooth(model, i, model.faces[f], silhouettes.regions[f], patches)) return false;
    }
    return true;
}

} // namespace

struct BodyContour::Body {
    Box3 box;
    Silhouettes silhouettes;
    BoundaryCurves curves;
    ContourPatches patches;
    std::vector<ContourBorder> borders;
    bool is_known;

    Body(const SurfaceModel& model, const Job& job)
        : box(hull_bounds(model)),
          silhouettes(silhouettes_of(model, job)),
          curves(model),
          patches(model, silhouettes, box.center()),
          borders(BorderMaker(curves, patches, box.center(), box.size()).all()),
          is_known(are_smooth(model, silhouettes, patches)) {}
};

BodyContour::BodyContour(const SurfaceModel& model, const Job& job)
    : body_(std::make_unique<const Body>(model, job)) {}
BodyContour::BodyContour(BodyContour&&) noexcept = default;
BodyContour::~BodyContour() = default;

bool BodyContour::is_known() const {
    return body_->is_known;
}

ContourArcs BodyContour::arcs_from(const Vec3& point, double error) const {
    constexpr double least = 1e-10, aside = 1e-9;
    const double size = body_->box.size();
    const Vec3 eye = point + Vec3(0.267, 0.535, 0.802) * (aside * size);
    const double away = (body_->box.center() - eye).length();
    const double allowed = std::max(least, error / 5 * std::min(1.0, size / (2 * away)));
    ContourArcs arcs;
    body_->patches.append_arcs(eye, allowed, arcs);
    for (const ContourBorder& border : body_->borders)
        border.append_arcs(eye - body_->box.center(), arcs.all);
    return arcs;
}

} // namespace keiko
