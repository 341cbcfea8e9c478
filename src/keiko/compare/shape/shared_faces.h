#pragma once

#include "keiko/compare/shape/deviation.h"
#include "keiko/film/film.h"
#include "keiko/math/disjoint_sets.h"

#include <map>

namespace keiko {

/// Names for the faces of two revisions that pictures of both can be compared by: faces that lie
/// on each other have the same, also where one divides what the other has in one.
class SharedFaces {
public:
    /// The bodies and how each lies to the other.
    SharedFaces(const PlacedModel& before, const Deviation& from_before, const PlacedModel& after,
                const Deviation& from_after);

    /// Puts the shared names in place of the faces' numbers in the layer of faces.
    void rename_before(Film& film) { rename(film, before_); }
    void rename_after(Film& film) { rename(film, after_); }
    /// The shared name of a face by its Face::id; 0: the ground.
    std::size_t name_before(std::uint32_t id) { return sets_.root(before_.at(id)); }
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
