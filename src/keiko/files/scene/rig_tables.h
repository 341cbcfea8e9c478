#pragma once

#include "keiko/geometry/model/primitive.h"
#include "keiko/light/areas/area_lights.h"
#include "keiko/light/areas/sign.h"
#include "keiko/light/fog/medium.h"
#include "keiko/light/fog/voxel_density.h"
#include "keiko/light/lines/line_light.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/light/spotlight/luminaire.h"
#include "keiko/light/spotlight/point_source.h"
#include "keiko/light/spotlight/spotlight.h"
#include "keiko/light/tubes/c_plane.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace keiko {

class TomlTable;

/// The row of lamps of a [[c_plane]]. Throws Error with file, line and column.
CPlane c_plane_from(const TomlTable& table);
/// A [[c_plane]] that reads back as the same row.
std::string table_text(const CPlane& plane);

/// Reads how the intensity of a [[spotlight]] goes with direction into it: edge, q, exponent,
/// coefficients, table or file, half_angle, half_angle_across, pattern. Throws Error with file,
/// line and column.
void take_beam(const TomlTable& table, Spotlight& light);

/// Lines that read back as the same.
std::string beam_text(const Spotlight& light);

/// The lamp of a [[spotlight]]. Throws Error with file, line and column.
Spotlight spotlight_from(const TomlTable& table);
/// A [[spotlight]] that reads back as the same lamp.
std::string table_text(const Spotlight& light);

/// The lamp of a [[point]]. Throws Error with file, line and column.
PointSource point_from(const TomlTable& table);
/// A [[point]] that reads back as the same lamp.
std::string table_text(const PointSource& light);

/// The light of a [[line]]. Throws Error with file, line and column.
LineLight line_from(const TomlTable& table);
/// A [[line]] that reads back as the same light.
std::string table_text(const LineLight& light);

/// The lamp of a [[luminaire]], with its file read. Throws Error with file, line and column.
Luminaire luminaire_from(const TomlTable& table);
/// A [[luminaire]] that reads back as the same lamp from a rig in `folder`, which its file is named
/// relative to.
std::string table_text(const Luminaire& luminaire, const std::filesystem::path& folder);

/// The corners of a [[polygon]] or a [[window]], mm. Throws Error with file, line and column.
std::vector<Vec3> corners_from(const TomlTable& table);
/// Throws Error at the corners unless they are 3 or more, in a plane, and enclose an area.
void require_polygon(const TomlTable& table, const std::vector<Vec3>& corners);
/// Throws Error at the corners unless they are a polygon of at most 1000, whose outline neither
/// crosses nor touches itself. The message counts corners and sides from 1.
void require_ring(const TomlTable& table, const std::vector<Vec3>& corners);
/// The line of corners that reads back as the same.
std::string corners_line(const std::vector<Vec3>& corners);

/// The shape of a [[primitive]], by its kind. Throws Error with file, line and column.
PrimitiveShape primitive_shape_from(const TomlTable& table);
/// The lights of a [[primitive]] that is a lamp. Throws Error with file, line and column.
std::vector<LightSource> primitive_lights_from(const TomlTable& table);
/// The six faces of a [[box]], which shine outwards. Throws Error with file, line and column.
std::vector<LightSource> box_lights_from(const TomlTable& table);
/// A [[primitive]] that reads back as the same light.
std::string table_text(const DiscLight& light);
std::string table_text(const FrustumLight& light);
std::string table_text(const EllipsoidLight& light);

/// Luminance in cd/m2 of a diffuse source, by `luminance`, or by `luminous_flux` in lm, for which
/// `of_flux` returns it, times the color; `otherwise` if the table has neither. Throws Error with
/// file, line and column.
Rgb luminance_from(const TomlTable& table, const Rgb& otherwise,
                   const std::function<double(double)>& of_flux);

/// The panel of a [[polygon]] without maps. Throws Error with file, line and column.
PolygonLight polygon_light_from(const TomlTable& table);
/// The panel by the keys of a [[polygon]], which may have others. Throws Error as above.
PolygonLight polygon_keys_from(const TomlTable& table);
/// A [[polygon]] that reads back as the same panel.
std::string table_text(const PolygonLight& light);

/// The sign of a [[sign]] with its [[sign.legend]]. Throws Error with file, line and column.
LuminousSign sign_from(const TomlTable& table);
/// A [[sign]] that reads back as the same sign.
std::string table_text(const LuminousSign& sign);
/// Throws Error at the corners of a part of a legend unless it lies inside of the sign, in its
/// plane, and apart from the parts that the sign has.
void require_legend(const TomlTable& table, const PolygonLight& part, const LuminousSign& sign);

/// The globe of a [[sphere]]. Throws Error with file, line and column.
SphereLight sphere_light_from(const TomlTable& table);
/// A [[sphere]] that reads back as the same globe.
std::string table_text(const SphereLight& light);

/// Unit vector towards the sun from the place and at the time of a [place]. Throws Error with file,
/// line and column, for a sun below the horizon too.
Vec3 direction_to_sun_from(const TomlTable& place);

/// The light of a [sun], without windows; `towards`: the direction to it by a [place]. Throws Error
/// with file, line and column.
Sun sun_from(const TomlTable& table, const std::optional<Vec3>& towards);
/// A [sun] that reads back as the same light, without windows.
std::string table_text(const Sun& sun);

/// The light of a [sky], without windows; `sun`: the direction to the sun, for a clear one. Throws
/// Error with file, line and column.
SkyLight sky_light_from(const TomlTable& table, const std::optional<Vec3>& sun);
/// A [sky] that reads back as the same light, without windows.
std::string table_text(const SkyLight& sky);

/// The openings of all [[window]]; `sun`: the direction to a sun that shines through them. Throws
/// Error with file, line and column.
std::vector<Window> windows_from(const std::vector<TomlTable>& tables,
                                 const std::optional<Vec3>& sun);
/// A [[window]] for each.
std::string windows_text(const std::vector<Window>& windows);

/// The phase function of a table `phase`. Throws Error with file, line and column.
PhaseFunction phase_from(const TomlTable& table);

/// The medium of [fog]. Throws Error with file, line and column.
Medium medium_from(const TomlTable& table);
/// A [fog] that reads back as the same medium from a rig in `folder`, which the file of a density
/// is named relative to.
std::string table_text(const Medium& medium, const std::filesystem::path& folder);

/// Reads a grid of densities (keiko-density/1, docs/scene-format.md). Throws Error with file and
/// reason.
VoxelDensity read_density(const std::filesystem::path& path);
/// Parses the text of a grid of densities; `source` is the file name for messages.
VoxelDensity parse_density(std::string_view text, const std::string& source);

} // namespace keiko
