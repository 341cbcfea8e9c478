#pragma once

#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/seams/knot_piece.h"
#include "keiko/inspect/seams/seam_measure.h"

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <span>
#include <vector>

namespace keiko {

/// A side of a piece of a seam, and what lies beyond it: lines that run in the same direction.
struct SeamSide {
    /// A part of a border, or of a line inside a face.
    struct Line {
        SurfaceCurve curve;   ///< in world coordinates, mm
        ParameterInterval on; ///< begin > end: it is run backwards

        /// Lower end of `on`.
        double low() const { return std::min(on.begin, on.end); }
        /// Upper end of `on`.
        double high() const { return std::max(on.begin, on.end); }
        /// The parameter at a share of the run, 0 at its begin and 1 at its end.
        double at(double share) const { return on.begin + share * (on.end - on.begin); }
    };
    Line own;               ///< of the face that the side belongs to
    Line beyond;            ///< the other side
    PlacedFace neighbour;   ///< the face of `beyond`; the face itself for lines inside it
    bool is_crease = false; ///< or a run-out
    bool leads_on = false;  ///< smooth; of a line inside the face, its angle passes, too
    bool is_inside = false; ///< of a line inside the face
    double negligible = 0;  ///< mm, of the seam
};

/// The sides of measured seams, by their placed faces. Lines inside a face have two sides of it.
/// Keeps references to the borders.
class SeamSides {
public:
    /// Sides by the instance and the index of their face.
    using ByFace = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<SeamSide>>;

    /// Without scraps. `pieces`: those of the seams, MeasuredSeams::pieces.
    SeamSides(const ModelBorders& borders, std::span<const MeasuredSeam> seams,
              std::span<const Seam> pieces);
    SeamSides(const SeamSides&) = delete;
    SeamSides& operator=(const SeamSides&) = delete;

    /// The sides of every face that has any, in the order of the seams.
    const ByFace& by_face() const { return sides_; }

private:
    void add(const MeasuredSeam& seam, const Seam& piece);
    void add(const MeasuredSeam& seam, const KnotPiece& piece);
    void add_both(const MeasuredSeam& seam, const SeamSide::Line& a, const SeamSide::Line& b);

    const ModelBorders& borders_;
    std::map<std::uint32_t, KnottedFace> knotted_;
    std::deque<std::array<Vec3, 2>> lines_; ///< p-curves of lines inside faces
    ByFace sides_;
};

} // namespace keiko
