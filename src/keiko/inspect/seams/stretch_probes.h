#pragma once

#include "keiko/inspect/seams/seam_measure.h"

#include <array>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A piece of a stretch, in its place along it.
struct PlacedProbe {
    SeamProbe probe;        ///< of the exact geometry
    bool backwards = false; ///< the stretch runs against side a
};

/// Order in which pieces follow each other along a stretch: every piece goes on with the nearest
/// end of those that are left, from an end that no other piece touches. A closed stretch starts
/// with its first piece. Pieces may run either way. Of several at one vertex the shortest is first.
std::vector<PlacedProbe> in_order(std::vector<SeamProbe> probes);

/// The probes of a stretch that has been measured, in their order along it. The nearest point of
/// the other side is searched along all of a piece that the stretch is cut from, as for its
/// verdict. Keeps references to the borders and to itself.
class StretchProbes {
public:
    /// Probes of the seam number `index`. The span holds all stretches of its line. `pieces`:
    /// those of the seams, MeasuredSeams::pieces.
    StretchProbes(const ModelBorders& borders, std::span<const MeasuredSeam> seams,
                  std::uint32_t index, std::span<const Seam> pieces);
    StretchProbes(const StretchProbes&) = delete;
    StretchProbes& operator=(const StretchProbes&) = delete;

    /// At least one.
    const std::vector<PlacedProbe>& probes() const { return probes_; }

private:
    SeamProbe knot_probe(const ModelBorders& borders, const MeasuredSeam& seam,
                         const KnotPiece& piece, const KnotPiece& whole);

    std::optional<KnottedFace> face_;          ///< of a line inside a face
    std::deque<std::array<Vec3, 2>> p_curves_; ///< sides of such lines
    std::vector<PlacedProbe> probes_;
};

} // namespace keiko
