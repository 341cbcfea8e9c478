#include "keiko/compare/shape/shared_faces.h"

namespace keiko {

SharedFaces::SharedFaces(const PlacedModel& before, const Deviation& from_before,
                         const PlacedModel& after, const Deviation& from_after) {
    // 0 is the ground, which both have.
    std::size_t next = 1;
    before_[0] = after_[0] = 0;
    for (const Face& face : before.model.faces) next += before_.emplace(face.id, next).second;
    for (const Face& face : after.model.faces) next += after_.emplace(face.id, next).second;
    sets_ = DisjointSets(next);
    join(before, before_, from_before, after, after_);
    join(after, after_, from_after, before, before_);
}

void SharedFaces::join(const PlacedModel& from, const Numbers& numbers_from,
                       const Deviation& deviation, const PlacedModel& to,
                       const Numbers& numbers_to) {
    for (std::size_t f = 0; f < deviation.faces.size(); ++f) {
        const FaceDeviation& face = deviation.faces[f];
        if (face.partner == no_index || face.alone()) continue;
        sets_.join(numbers_from.at(from.model.faces[f].id),
                   numbers_to.at(to.model.faces[face.partner].id));
    }
}

void SharedFaces::rename(Film& film, const Numbers& numbers) {
    const auto layer = film.aovs.find(Aov::face);
    if (layer == film.aovs.end()) return;
    for (float& value : layer->second.values) {
        if (value < 0) continue;
        const auto found = numbers.find(static_cast<std::uint32_t>(value));
        if (found != numbers.end()) value = static_cast<float>(sets_.root(found->second));
    }
}

} // namespace keiko
