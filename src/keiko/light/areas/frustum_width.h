#pragma once

#include "keiko/light/areas/frustum_view.h"
#include "keiko/light/penumbra/source_width.h"
#include "keiko/math/interval_set.h"

#include <optional>
#include <vector>

namespace keiko {

/// The generators of the lateral surface of a cylinder or a cone that face a surface element. All
/// half-planes are bounded by the line through the point and the apex, or along a cylinder's axis.
/// A place is uniform in the angle around the axis.
class FrustumWidth final : public SourceWidth {
public:
    /// nullopt if no part of the surface faces the element, or the element is in the apex.
    static std::optional<FrustumWidth> of(const FrustumLight& light, const Vec3& point,
                                          const Vec3& normal);
    SubAxis sub_axis(double place) const override;
    /// A generator, a millionth of its distance before the surface.
    Segment line_of(const SubAxis& axis) const override;
    Prism around() const override;
    double lit(const SubAxis& axis, double begin, double end) const override;
    /// Both ends, and where the horizon crosses a rim.
    std::vector<double> cuts() const override;
    double place_in(const Vec3& way) const override;
    /// Unit direction at an elevation, given by its half tangent, in the half-plane of a line.
    Vec3 direction(const SubAxis& axis, double half_tangent) const;
    /// Unit vector along the line that bounds the half-planes.
    const Vec3& along() const { return pole_; }
    /// Elevations, by half tangents, of a generator above the horizon, and from t = `begin` to
    /// `end`, 0 to 1 along line_of().
    std::vector<ParameterInterval> elevations(const SubAxis& axis, double begin = 0,
                                              double end = 1) const;
    /// Projected solid angle, by the wedge angle and the half tangent of an elevation.
    double light_rate(const SubAxis& axis, double half_tangent) const;
    /// Place of the source at an elevation, given by its half tangent, in the half-plane of a line.
    Vec3 place(const SubAxis& axis, double half_tangent) const;

private:
    FrustumWidth(const FrustumView& view, const Vec3& pole, const Vec3& point, const Vec3& normal);
    double angle_at(double place) const { return view_.half * turn_ * place; }
    Vec3 middle(double angle) const;
    Vec3 level(const SubAxis& axis) const;
    Vec2 in_half_plane(const SubAxis& axis, const Vec3& way) const;
    double half_tangent_at(const SubAxis& axis, double t) const;

    FrustumView view_;
    Vec3 pole_, point_, normal_;
    Vec3 ahead_{0}, across_{0}; ///< unit, of wedge angles 0 and pi / 2
    double turn_ = 1;           ///< 1 if wedge angles rise with angles around the axis, else -1
};

/// Lines of a light; nullopt if it sends none to the surface element.
inline std::optional<FrustumWidth> width_of(const FrustumLight& light, const Vec3& point,
                                            const Vec3& normal) {
    return FrustumWidth::of(light, point, normal);
}

} // namespace keiko
