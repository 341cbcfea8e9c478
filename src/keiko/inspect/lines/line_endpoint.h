#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/geometry/seam/seam.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/lines/line_geometry.h"
#include "keiko/inspect/lines/surface_lines.h"

#include <map>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

namespace KEIKO_API keiko {

/// Shared border of two patches: a chain of seams, or a line between the patches of one face.
struct LineBorder {
    std::uint32_t seam = no_index;        ///< number of the chain; no_index: inside a face
    std::uint32_t instance = 0, face = 0; ///< into the model's arrays; of a line inside a face
    bool constant_u = false;              ///< of a line inside a face
    double at = 0;                        ///< the face parameter that is constant there

    /// Key by which borders are ordered.
    auto order() const { return std::tie(seam, instance, face, constant_u, at); }
    /// By order().
    bool operator<(const LineBorder& other) const { return order() < other.order(); }
    /// By order().
    bool operator==(const LineBorder& other) const { return order() == other.order(); }
};

/// The end of a piece on such a border, and the reflection on the other side there. All values are
/// limits from the piece's own side unless stated otherwise.
struct LineEndpoint {
    /// Index of the piece, and those of its C-plane and lamp.
    std::uint32_t piece = 0, plane = 0, lamp = 0;
    bool head = false;                    ///< the piece begins here, else it ends here
    LineBorder border;                    ///< where the piece ends
    bool second = false;                  ///< of the border's two sides
    std::uint32_t instance = 0, face = 0; ///< of the piece, into the model's arrays
    Vec3 place{0};                        ///< world, mm
    Vec3 along{0};              ///< unit, along the border, the same direction for both sides
    SurfaceDerivatives surface; ///< derivatives by patch parameters
    int degree = 1;             ///< the larger one of the patch
    LineGeometry course;        ///< of the line
    double off = 0;             ///< mm, error of the place along the border

    double gap = 0;   ///< mm, to the nearest place of the other side
    double angle = 0; ///< degrees, between the normals towards the viewpoint
    double jump =
        0; ///< field there less the level; NaN if the other side does not reflect the lamps
    SurfaceDerivatives other; ///< of the other side there
    int other_degree = 1;     ///< the larger one of the other side's patch

    /// Slope of the field along the border.
    double slope() const { return course.gradient().dot(along); }
};

/// Finds the borders of a model on which ends of lines lie. Keeps references.
class LineBorders {
public:
    /// `chains`: groups of the seams that form one border each, as returned by seam_chains.
    LineBorders(const SurfaceModel& model, const BoundaryCurves& curves,
                std::span<const Seam> seams, const std::vector<std::vector<std::uint32_t>>& chains);

    /// An end of a piece: its meetings, and whether it lies on the border of its face's material.
    struct End {
        std::vector<LineEndpoint> meetings; ///< one for each border that meets there
        bool on_border = false;             ///< of its face's material
    };
    /// The end of a piece with number `index`, at its head or its tail.
    End end_of(const SurfaceLine& piece, std::uint32_t index, bool head,
               const LampLevels& lamps) const;

private:
    /// A side of one of the seams.
    struct SeamSide {
        std::uint32_t seam = 0;
        bool second = false;
    };
    struct BorderPlace {
        BoundaryInterval curve; ///< whole
        double t = 0, distance = 0;
    };
    struct Asked {
        const SurfaceLine& piece;
        LinePoint point;
        LineEndpoint meeting; ///< the values that are the same for all borders
        const LampLevels& lamps;
    };

    std::optional<BorderPlace> border_at(const Asked& end) const;
    std::optional<LineEndpoint> at_seam(const Asked& end, const BorderPlace& border,
                                        const SeamSide& side) const;
    std::optional<LineEndpoint> at_knot(const Asked& end, bool constant_u) const;
    int degree(std::uint32_t patch) const;

    const SurfaceModel& model_;
    const BoundaryCurves& curves_;
    std::span<const Seam> seams_;
    std::vector<std::uint32_t> chain_of_; ///< by seam
    std::vector<TrimRegion> trims_;       ///< by face
    std::vector<PatchGrid> grids_;        ///< by face
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::vector<SeamSide>>
        sides_; ///< by instance, face and curve
};

/// Reason why a line ends.
enum class LineEnd {
    closed,      ///< no end: it runs back into itself
    lamp,        ///< end of the lamp
    silhouette,  ///< the surface turns away from the viewpoint
    hidden,      ///< hidden by something, or its lamp's light is
    free_border, ///< end of the material
    crease,      ///< at a seam with more than the feature angle
    seam,        ///< at a seam beyond which it does not continue
    patch        ///< at a line inside a face, where the search lost it
};
/// The reason as a word in files.
std::string_view name_of(LineEnd end);

/// Reason why a line ends at the head or tail of a piece; `end`: what it meets there. Angles of
/// more than `feature_angle` degrees are creases.
LineEnd line_end(const SurfaceModel& model, const SurfaceLine& piece, bool head,
                 const LineBorders::End& end, const LineField& field, double feature_angle);

} // namespace keiko
