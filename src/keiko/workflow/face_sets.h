#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/scene/face_selection.h"

#include <optional>
#include <string>
#include <vector>

namespace keiko {

/// True if a pattern, with * and ? as in file names, is the number or the name of a face.
bool names_face(const std::string& pattern, const Face& face);

/// True for each placed face, in the order of placed_faces(), that belongs to a set.
using FaceSet = std::vector<bool>;

/// A body whose faces are sought.
struct ZonedBody {
    const SurfaceModel& model;      ///< all models as one
    const Tracer* tracer = nullptr; ///< of the model; made if there is none and one is needed
    std::optional<double> ground{}; ///< mm, z of the floor; none: as of Framing
};

/// Finds faces of a body by conditions. Keeps references to the body and the job.
class FaceFinder {
public:
    FaceFinder(const ZonedBody& body, const Job& job);

    /// Number of placed faces.
    std::size_t size() const { return faces_.size(); }
    /// The faces that meet all conditions; all faces if there are none. Throws FieldError for a
    /// word that no face meets, of the field that holds it. Throws Cancelled.
    FaceSet selected(const FaceSelection& selection);
    /// The faces that standing views show to more than outer_skin_share.
    FaceSet outer_skin();

private:
    void keep_named(const FaceSelection& selection, FaceSet& faces) const;
    void keep_in_box(const Box3& box, FaceSet& faces) const;
    const std::vector<double>& shares();

    const ZonedBody body_;
    const Job& job_;
    std::vector<PlacedFace> faces_;
    std::vector<double> shares_; ///< visible, of each face; empty until they are needed
};

} // namespace keiko
