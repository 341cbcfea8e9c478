#include "keiko/intersect/hit/refract_ray.h"

#include "keiko/intersect/hit/local_surface.h"
#include "keiko/math/refract.h"

namespace keiko {
namespace {

/// How a refracted direction changes, by Snell's law for the tangential part and the length kept.
class RefractedChange {
public:
    RefractedChange(const Vec3& direction, const Vec3& refracted, const Vec3& normal, double eta)
        : direction_(direction),
          normal_(normal),
          eta_(eta),
          along_(direction.dot(normal)),
          behind_(refracted.dot(normal)) {}

    Vec3 operator()(const Vec3& direction_change, const Vec3& normal_change) const {
        const double along_change = direction_change.dot(normal_) + direction_.dot(normal_change);
        const double behind_change = ((1 - eta_ * eta_) * direction_.dot(direction_change) +
                                      eta_ * eta_ * (along_ * along_change)) /
                                     behind_;
        return direction_change * eta_ + normal_ * (behind_change - eta_ * along_change) +
               normal_change * (behind_ - eta_ * along_);
    }

private:
    Vec3 direction_, normal_;
    double eta_;
    double along_, behind_; ///< components along the normal, before and behind the surface
};

/// The refracted direction, of the incoming one's length.
std::optional<Vec3> refracted_direction(const Vec3& direction, const Vec3& normal, double eta) {
    if (eta == 1) return direction;
    const double length = direction.length();
    const Vec3 before = direction.dot(normal) > 0 ? -normal : normal;
    const auto unit = refract(direction / length, before, eta);
    return unit ? std::optional(*unit * length) : std::nullopt;
}

} // namespace

std::optional<Ray> refract_ray(const Ray& incoming, const Hit& hit, double eta) {
    const auto direction = refracted_direction(incoming.direction, hit.normal, eta);
    if (!direction) return {};
    Ray refracted;
    refracted.origin = hit.position;
    refracted.direction = *direction;
    refracted.excluded = hit.root;
    if (!incoming.differentials || !hit.second || !is_regular(hit)) return refracted;

    const RayDifferentials& in = *incoming.differentials;
    const LocalSurface surface(hit);
    const RefractedChange change(incoming.direction, *direction, hit.normal, eta);
    RayDifferentials out;
    out.origin_dx = transfer(incoming, hit, in.origin_dx, in.direction_dx);
    out.origin_dy = transfer(incoming, hit, in.origin_dy, in.direction_dy);
    out.direction_dx = change(in.direction_dx, surface.normal_change(out.origin_dx));
    out.direction_dy = change(in.direction_dy, surface.normal_change(out.origin_dy));
    // At an exact silhouette, and where reflection just becomes total, the first order says
    // nothing.
    if (is_finite(out.origin_dx) && is_finite(out.origin_dy) && is_finite(out.direction_dx) &&
        is_finite(out.direction_dy))
        refracted.differentials = out;
    return refracted;
}

} // namespace keiko
