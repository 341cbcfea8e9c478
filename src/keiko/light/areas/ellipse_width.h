#pragma once

#include "keiko/light/areas/area_width.h"
#include "keiko/light/areas/ellipse.h"

#include <optional>
#include <variant>
#include <vector>

namespace keiko {

/// Lines across the elliptic outline of a disc, a sphere or an ellipsoid above the horizon,
/// parallel to the horizon. A place is uniform in the angle around the outline.
class EllipseWidth final : public AreaWidth {
public:
    /// nullopt if the light sends none to the surface element.
    static std::optional<EllipseWidth> of(const DiscLight& light, const Vec3& point,
                                          const Vec3& normal);
    /// nullopt if the sphere sends no light to the surface element.
    static std::optional<EllipseWidth> of(const SphereLight& light, const Vec3& point,
                                          const Vec3& normal);
    /// nullopt if the ellipsoid sends no light to the surface element.
    static std::optional<EllipseWidth> of(const EllipsoidLight& light, const Vec3& point,
                                          const Vec3& normal);
    SubAxis sub_axis(double place) const override;
    std::vector<double> cuts() const override { return {-1, 1}; }
    double place_in(const Vec3& way) const override;
    Vec3 place(const SubAxis& axis, double half_tangent) const override;

private:
    using Light = std::variant<DiscLight, SphereLight, EllipsoidLight>;

    static std::optional<EllipseWidth> of(const Light& light, const Ellipse& outline,
                                          const Vec3& point, const Vec3& normal);
    EllipseWidth(const Light& light, const Ellipse& outline, const Vec3& plane_normal,
                 const Vec3& along, const Vec3& point, const Vec3& normal);
    std::vector<ParameterInterval> chords(double v) const override;

    Light light_;
    Vec2 center_{0};               ///< of the outline
    double high_ = 0;              ///< largest v from the center
    double aslant_ = 0;            ///< u from the center where v is largest
    double wide_ = 0;              ///< half of the line through the center
    double middle_ = 0, half_ = 0; ///< angle of place 0, and from there to place 1
};

/// Lines of a light; nullopt if it sends none to the surface element.
inline std::optional<EllipseWidth> width_of(const SphereLight& light, const Vec3& point,
                                            const Vec3& normal) {
    return EllipseWidth::of(light, point, normal);
}
inline std::optional<EllipseWidth> width_of(const DiscLight& light, const Vec3& point,
                                            const Vec3& normal) {
    return EllipseWidth::of(light, point, normal);
}
inline std::optional<EllipseWidth> width_of(const EllipsoidLight& light, const Vec3& point,
                                            const Vec3& normal) {
    return EllipseWidth::of(light, point, normal);
}

} // namespace keiko
