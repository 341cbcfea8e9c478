#pragma once

#include "keiko/compare/alignment/closest_point_query.h"
#include "keiko/compare/shape/deviation.h"
#include "keiko/film/film.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/math/disjoint_sets.h"
#include "keiko/scene/camera.h"

#include <functional>
#include <map>

namespace keiko {

/// Deviation of a surface from another, as viewed by an eye.
struct DeviationMap {
    /// mm, signed as Deviation: 1 channel. Infinity: nothing within reach; no number: no body,
    /// or a place without a value.
    Image distance;
    Image facing; ///< 1 channel: cosine between view and normal, 0 to 1
};

/// Value of a place that a pixel shows.
using HitValue = std::function<float(const Hit&)>;

/// Follows the ray of every pixel's centre to the body and maps the value of the hit. `begin_row`
/// makes the function that is called along a row of pixels, from the left. The same for any number
/// of threads. Reports stage "deviation map". Throws Cancelled.
DeviationMap surface_map(const Tracer& body, const Camera& camera,
                         const std::function<HitValue()>& begin_row, const Job& job = {});

/// Follows the ray of every pixel's centre to the body and finds the nearest point of the other, up
/// to `reach` mm. The same for any number of threads. Reports stage "deviation map". Throws
/// Cancelled.
DeviationMap deviation_map(const Tracer& body, const Camera& camera, const ClosestPointQuery& other,
                           double reach, const Job& job = {});

/// Names for the faces of two revisions that pictures of both can be compared by: faces that lie
/// on each other have the same, also where one divides what the other has in one.
class SharedFaces {
public:
    /// The bodies and how each lies to the other.
    SharedFaces(const PlacedModel& before, const Deviation& from_before, const PlacedModel& after,
                const Deviation& from_after);

    /// Puts the shared names in place of Face::id in the layer of faces of a picture of the body
    /// before. A picture without that layer stays as it is.
    void rename_before(Film& film) { rename(film, before_); }
    /// Puts the shared names into a picture of the body after, as rename_before.
    void rename_after(Film& film) { rename(film, after_); }
    /// The shared name of a face of the body before, by its Face::id; 0: the ground. Throws
    /// std::out_of_range for another number.
    std::size_t name_before(std::uint32_t id) { return sets_.root(before_.at(id)); }
    /// The shared name of a face of the body after, as name_before.
    std::size_t name_after(std::uint32_t id) { return sets_.root(after_.at(id)); }

private:
    using Numbers = std::map<std::uint32_t, std::size_t>; ///< Face::id to a number of both

    void rename(Film& film, const Numbers& numbers);
    void join(const PlacedModel& from, const Numbers& numbers_from, const Deviation& deviation,
              const PlacedModel& to, const Numbers& numbers_to);

    Numbers before_, after_;
    DisjointSets sets_{0};
};

} // namespace keiko
