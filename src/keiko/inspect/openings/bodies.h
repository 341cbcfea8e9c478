#pragma once

#include "keiko/geometry/seam/seam.h"
#include "keiko/inspect/basics/placed_face.h"

#include <map>
#include <span>
#include <utility>
#include <vector>

namespace keiko {

/// The placed faces of a model, grouped by the seams that join them.
class Bodies {
public:
    /// Groups all placed faces. The two faces of a seam are in one group, which goes on from face
    /// to face; a face without seams is a group of its own.
    Bodies(const SurfaceModel& model, std::span<const Seam> seams);

    /// Number of groups.
    std::size_t count() const { return faces_.size(); }
    /// The faces of a body; bodies are in the order of their first faces.
    const std::vector<PlacedFace>& faces(std::size_t body) const { return faces_[body]; }
    /// The body of a face. Throws std::out_of_range for a face that the model does not place.
    std::size_t of(const PlacedFace& face) const { return of_.at({face.instance, face.face}); }

private:
    std::vector<std::vector<PlacedFace>> faces_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> of_;
};

/// A model of some placed faces of another, without its edges: each is a part of its own, placed
/// once, in the order given.
SurfaceModel placed_subset(const SurfaceModel& model, std::span<const PlacedFace> faces);

} // namespace keiko
