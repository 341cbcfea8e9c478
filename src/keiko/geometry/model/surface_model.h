#pragma once

#include "keiko/base/error.h"
#include "keiko/base/export.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/bezier/parameter_map.h"
#include "keiko/geometry/model/repair.h"
#include "keiko/math/affine.h"
#include "keiko/math/rgb.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// No index: "none" wherever an index may be missing.
constexpr std::uint32_t no_index = 0xffffffff;

/// A Bezier patch of a face: one knot span of the face's surface.
struct Patch {
    std::uint32_t face = 0;                   ///< into SurfaceModel::faces
    std::uint32_t first_point = 0;            ///< into SurfaceModel::control_points
    std::uint16_t degree_u = 1, degree_v = 1; ///< of the two parameters
    ParameterMap map_u, map_v;                ///< patch parameters to face parameters
};

/// A Bezier piece of a p-curve, in face parameters.
struct TrimCurve {
    std::uint32_t first_point = 0; ///< into SurfaceModel::trim_points
    std::uint16_t degree = 1;      ///< of the piece
    std::uint32_t edge = no_index; ///< into SurfaceModel::edges, the file's own hint
};

/// A closed chain of trim curves.
struct TrimLoop {
    std::uint32_t first_curve = 0, curve_count = 0; ///< into SurfaceModel::trim_curves
};

/// A trimmed surface. A point is material if it is inside an odd number of loops; a face without
/// loops is whole.
struct Face {
    std::uint32_t id = 0;     ///< position in the file, stable between loads, from 1
    std::string name;         ///< of the face, or empty
    std::string layer;        ///< name of its layer, or empty
    std::optional<Rgb> color; ///< as the file has it
    std::string surface_kind; ///< as named in the file: "plane", "b-spline", "torus", ...
    std::uint32_t part = 0;   ///< into SurfaceModel::parts
    std::uint32_t first_patch = 0, patch_count = 0; ///< into SurfaceModel::patches
    std::uint32_t first_loop = 0, loop_count = 0;   ///< into SurfaceModel::trim_loops
    bool reversed = false;                          ///< the file's outward normal is -(du x dv)
    double approximated = 0; ///< mm, tolerance of an approximation; 0 if the patches are exact
    std::uint32_t line = 0;  ///< of its entity in a STEP file, from 1; 0 if unknown
    std::uint32_t file = 0;  ///< into files_of(model)
};

/// An edge that the file shares between faces.
struct Edge {
    double tolerance = 0;        ///< mm, as claimed by the file; never hides a gap
    std::uint32_t use_count = 0; ///< trim curves that lie on it
    bool degenerate = false;     ///< a point in space, e.g. at a pole
};

/// Geometry that is stored once, however often it is placed.
struct Part {
    std::string name;                             ///< or empty
    std::uint32_t first_face = 0, face_count = 0; ///< into SurfaceModel::faces
};

/// A placed part.
struct Instance {
    std::uint32_t part = 0; ///< into SurfaceModel::parts
    std::string name;       ///< or empty
    Affine transform;       ///< part to world, may mirror
};

/// A face of the file that could not be converted. Nothing disappears silently.
struct LostFace {
    std::uint32_t id = 0; ///< as Face::id
    std::string name;     ///< of the face, or empty
    std::string reason;   ///< why it could not be converted
};

/// A patch in the last ring around an irregular point of a subdivision surface: it replaces a
/// surface that has no curvature there.
struct IrregularPatch {
    std::uint32_t face = 0; ///< into SurfaceModel::faces
    Vec3 center{0};         ///< of a ball around the patch, as control points
    double radius = 0;      ///< mm
};

/// Geometry read from a CAD file, a cage or a patch file: rational Bezier patches with trim loops,
/// in millimetres, in flat arrays.
struct SurfaceModel {
    std::string source; ///< path it was read from
    std::string format; ///< "STEP", "IGES", "BREP", "BPT"
    std::string unit;   ///< of the file, or empty if it names none (read as mm)

    std::vector<Vec4> control_points;              ///< homogeneous, mm
    std::vector<Vec3> trim_points;                 ///< homogeneous, face parameters
    std::vector<Patch> patches;                    ///< grouped by face
    std::vector<TrimCurve> trim_curves;            ///< grouped by loop
    std::vector<TrimLoop> trim_loops;              ///< grouped by face
    std::vector<Face> faces;                       ///< grouped by part
    std::vector<Edge> edges;                       ///< in the order of the file
    std::vector<Part> parts;                       ///< in the order of the file
    std::vector<Instance> instances;               ///< in the order of the file
    std::vector<LostFace> lost_faces;              ///< in the order of the file
    std::vector<IrregularPatch> irregular_patches; ///< by face
    std::vector<Repair> repairs;                   ///< by face, in the order of the faces
    Diagnostics diagnostics;                       ///< other remarks of the import
    std::vector<std::string> files; ///< of a merged model: the sources of its models in order

    /// View of a patch's control points.
    BezierPatchView patch(std::uint32_t index) const;
    /// View of a trim curve's control points.
    BezierCurveView trim_curve(std::uint32_t index) const;
    /// The patches of a face.
    std::span<const Patch> patches_of(const Face& face) const;
    /// The trim loops of a face.
    std::span<const TrimLoop> loops_of(const Face& face) const;
    /// The trim curves of a loop.
    std::span<const TrimCurve> curves_of(const TrimLoop& loop) const;
    /// "face 12 (fender-outer)"
    std::string describe(const Face& face) const;
    /// Face parameters of a point of a patch.
    Vec2 face_parameters(std::uint32_t patch, const Vec2& uv) const;
};

/// Box of the control points of all placed patches, world, mm. It holds the material and may be
/// much larger: material_bounds() measures sizes.
Box3 hull_bounds(const SurfaceModel& model);

/// Paths of the files that a model was read from, in the order of Face::file: `files`, or `source`
/// of a model that is not merged.
std::vector<std::string> files_of(const SurfaceModel& model);

/// Merged model of several models; faces keep their order, ids are made unique by renumbering.
SurfaceModel merge(std::span<const SurfaceModel> models);

/// Trim curves that follow each other along one side of an edge.
struct EdgeUse {
    std::uint32_t face = 0, first_curve = 0, curve_count = 0; ///< into the model's arrays
};

/// The uses of each edge of a model, in file order.
std::vector<std::vector<EdgeUse>> edge_uses(const SurfaceModel& model);

/// A level square at height `z` below, above or beside a body, its normal up. It is one bilinear
/// patch that extends a hundred times the body's size from the middle of its box, and at least 100
/// m. Lengths in mm.
SurfaceModel ground_plane(double z, const Box3& body);

} // namespace keiko
