#pragma once

#include "keiko/light/rig/light_id.h"
#include "keiko/light/rig/light_rig.h"

#include <concepts>
#include <optional>
#include <variant>
#include <vector>

namespace keiko {

/// A row of lamps with the frame of its plane.
struct LampRow {
    CPlane plane;
    CPlaneFrame frame; ///< of `plane`

    /// Computes the frame.
    explicit LampRow(const CPlane& row) : plane(row), frame(row) {}
    /// The model for light on surfaces: the row's own, or `asked` where it leaves the choice.
    TubeModel diffuse_model(TubeModel asked) const {
        return plane.diffuse == TubeModel::automatic ? asked : plane.diffuse;
    }
};

/// A light source with what its light on surfaces needs of it and no point changes. LightSource and
/// each of its kinds convert to one.
class PreparedSource {
public:
    /// Kinds of sources in the order of LightSource.
    using Kind =
        std::variant<LampRow, Spotlight, Luminaire, Sun, PolygonLight, SphereLight, PointSource,
                     LineLight, SkyLight, DiscLight, FrustumLight, EllipsoidLight, ContourLight>;

    template <std::convertible_to<LightSource> Source>
    PreparedSource(const Source& source) : kind_(prepare(source)) {}

    /// The source of its own kind.
    const Kind& kind() const { return kind_; }
    /// Numbers of its lamps, from 0, or of the panels of a sky; only 0 for any other source.
    std::vector<int> lamp_numbers() const;

private:
    static Kind prepare(const LightSource& source);

    Kind kind_;
};

/// A rig prepared for light on surfaces, once for all points.
struct PreparedRig {
    std::vector<PreparedSource> sources; ///< in the order of the rig
    std::vector<LightId> lights;         ///< all, by source, then by lamp
    const std::optional<Medium>& medium; ///< the rig's own, which must outlive this

    explicit PreparedRig(const LightRig& rig);
    PreparedRig(LightRig&&) = delete;
};

/// True if the light of a source is undefined at a point (mm). That is inside the glass of one of
/// its tubes, inside a body, on a panel, a disc or a line, and at a point light. The glass itself
/// is outside.
bool within_lamp(const PreparedSource& source, const Vec3& point);

} // namespace keiko
