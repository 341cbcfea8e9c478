#include "keiko/compare/shape/face_deviation.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace keiko {
namespace {

/// What is added up of a face.
struct FaceSums {
    FaceDeviation face;
    double turned = 0, beyond = 0, beside = 0, squares = 0;
    std::map<std::uint32_t, double> votes; ///< area by the other's face

    void add(const DeviationSample& sample, double noise) {
        face.area += sample.area;
        const double d = sample.deviation();
        if (std::abs(d) > std::abs(face.worst.value))
            face.worst = {d, sample.point.position, sample.point.face};
        if (!sample.foot) {
            beyond += sample.area;
            return;
        }
        if (sample.turned()) turned += sample.area;
        if (sample.beside(noise)) beside += sample.area;
        squares += d * d * sample.area;
        votes[sample.foot->face] += sample.area;
    }
    FaceDeviation result() const {
        FaceDeviation all = face;
        if (!(face.area > 0)) return all;
        all.turned = turned / face.area, all.beyond = beyond / face.area;
        all.beside = beside / face.area;
        if (votes.empty()) return all;
        all.root_mean_square = std::sqrt(squares / (face.area - beyond));
        all.partner =
            std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
                return a.second < b.second;
            })->first;
        return all;
    }
};

} // namespace

std::vector<FaceDeviation> face_deviations(std::span<const DeviationSample> samples,
                                           std::size_t faces, double noise) {
    std::vector<FaceSums> sums(faces);
    for (const DeviationSample& sample : samples) sums[sample.point.face].add(sample, noise);
    std::vector<FaceDeviation> all;
    for (const FaceSums& face : sums) all.push_back(face.result());
    return all;
}

} // namespace keiko
