#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/basics/verdict.h"
#include "keiko/inspect/seams/model_borders.h"

#include <map>
#include <optional>
#include <utility>

namespace keiko {

/// An instance and a face of it, into the model's arrays.
using FaceKey = std::pair<std::uint32_t, std::uint32_t>;

/// The shortest edge of every placed face that has one, held to `limit` mm. An edge is what the
/// file has as one, on one side; edges that the file states to be points, and what closes loops
/// without an edge, are left out. Faces without loops have the sides of their domain that are not
/// points. Throws Cancelled.
std::map<FaceKey, MeasuredValue> shortest_edges(const ModelBorders& borders, double limit,
                                                const Job& job = {});

/// Size of a placed face held to `limit` mm: the diagonal of the box of five places on each of its
/// border curves. `place`: one of the face; nullopt if the face has no borders.
std::optional<MeasuredValue> face_size(const ModelBorders& borders, const FaceKey& face,
                                       const Vec3& place, double limit);

} // namespace keiko
