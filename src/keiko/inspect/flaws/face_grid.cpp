#include "keiko/inspect/flaws/face_grid.h"

#include "keiko/base/job.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Places in the middles of equal parts of each span, at most `spacing` apart.
std::vector<double> spread(const std::vector<double>& lengths, double spacing) {
    constexpr double most = 1000; // of one span
    std::vector<double> places;
    for (std::size_t span = 0; span < lengths.size(); ++span) {
        const auto parts =
            static_cast<std::size_t>(std::clamp(std::ceil(lengths[span] / spacing), 1.0, most));
        for (std::size_t k = 0; k < parts; ++k)
            places.push_back(static_cast<double>(span) +
                             (static_cast<double>(k) + 0.5) / static_cast<double>(parts));
    }
    return places;
}

FaceSample sampled(const FaceSurface& face, const Vec2& place) {
    FaceSample sample;
    const auto s = face.evaluate(place, 2);
    if (!s) return sample;
    const Vec3 cross = s->du().cross(s->dv());
    const double area = cross.length(), u2 = s->du().length2(), v2 = s->dv().length2();
    constexpr double beside_a_pole = 1e-3;
    if (!(area > beside_a_pole * std::max(u2, v2))) return sample;
    const Vec3 normal = cross * (face.sign() / area);
    sample.position = s->position();
    sample.bend_u = s->duu().dot(normal) / u2;
    sample.bend_v = s->dvv().dot(normal) / v2;
    sample.material = true;
    return sample;
}

} // namespace

FaceGrid::FaceGrid(const FaceSurface& face, double spacing)
    : u_(spread(face.span_lengths_u(), spacing)), v_(spread(face.span_lengths_v(), spacing)) {
    samples_.reserve(u_.size() * v_.size());
    for (std::size_t row = 0; row < v_.size(); ++row) {
        check_stop();
        for (std::size_t column = 0; column < u_.size(); ++column)
            samples_.push_back(sampled(face, place(column, row)));
    }
}

} // namespace keiko
