#pragma once

#include "keiko/base/export.h"
#include "keiko/light/tubes/c_plane.h"
#include "keiko/placement/view_samples.h"

#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// The samples of a picture and the effect of the lamps placed so far on each of them.
class LampField {
public:
    /// Field of samples without lamps.
    explicit LampField(std::vector<ViewSample> samples);

    /// The samples, in order.
    std::span<const ViewSample> samples() const { return samples_; }
    /// Total weight of all samples, reached or not.
    double total_weight() const { return total_weight_; }
    /// Weighted mean of the places on the surface, and the diagonal of their box, mm.
    const Vec3& centroid() const { return centroid_; }
    /// Diagonal of the box of the places, mm.
    double size() const { return size_; }
    /// Number of different (instance, face) pairs, and the one of a sample.
    std::size_t region_count() const { return region_count_; }
    /// Number of a sample's (instance, face) pair.
    std::uint32_t region(std::size_t sample) const { return regions_[sample]; }

    /// True if the sample is still uncovered: not blocked by the body, not hidden from the camera
    /// by lamps, not reached yet.
    bool waits(std::size_t sample) const;
    /// True if the sample reflects lamps.
    bool reached(std::size_t sample) const { return lit_[sample] && !hidden_[sample]; }
    /// True if the tube of a lamp stands between the sample and the camera.
    bool hidden(std::size_t sample) const { return hidden_[sample]; }
    /// Share of the weight that is reached.
    double coverage() const;

    /// Adds the lamps of one more plane.
    void place(const CPlane& plane);
    /// Field of `count` to twice as many of the samples, uniformly chosen, without lamps: for
    /// searches.
    LampField thinned(std::size_t count) const;

private:
    std::vector<ViewSample> samples_;
    std::vector<std::uint32_t> regions_;
    std::vector<bool> lit_, hidden_;
    double total_weight_ = 0, size_ = 0;
    Vec3 centroid_{0};
    std::size_t region_count_ = 0;
};

/// Cosine of the angle of incidence on a lamp plane below which a reflected ray does not count.
constexpr double grazing_cosine = 0.05;

} // namespace keiko
