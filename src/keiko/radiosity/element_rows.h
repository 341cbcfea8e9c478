#pragma once

#include "keiko/base/job.h"
#include "keiko/math/rgb.h"
#include "keiko/radiosity/elements.h"
#include "keiko/radiosity/gather_rays.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

/// Form factors of the faces of elements, all fronts, then all backs, by rays from places spread
/// over each face to the exact surfaces: the share of them that meets another face. Rows sum to 1
/// in a closed scene.
class ElementRows {
public:
    /// `rays` of a face. Keeps references to elements and rays.
    ElementRows(const Elements& elements, const GatherRays& gather, int rays);

    /// Computes the rows. A few rays of each face come first; the others follow for those that
    /// light can reach from `lit` faces, also over others, by the first ones. After Cancelled, rows
    /// that are not done have the first rays, or nothing.
    void compute(const std::vector<bool>& lit, const Job& job);

    /// Light that a face receives of these radiosities, lx.
    Rgb arriving(std::size_t face, std::span<const Rgb> radiosity) const;
    /// Share of the light of a face that leaves the scene.
    double leaving(std::size_t face) const { return leaving_[face]; }
    /// Form factor of a face to another, of a row that has been computed.
    double form_factor(std::size_t from, std::size_t to) const;
    /// True for faces that light can reach; all before compute().
    const std::vector<bool>& reached() const { return reached_; }
    /// Number of faces.
    std::size_t size() const { return rows_.size(); }
    /// Number of rows computed with all rays.
    std::size_t computed() const;

private:
    /// A face and its form factor.
    struct Entry {
        std::uint32_t face;
        float factor;
    };
    void compute_row(std::size_t face, int rays);
    void find_reached(const std::vector<bool>& lit);

    const Elements& elements_;
    const GatherRays& gather_;
    int rays_;
    std::vector<std::vector<Entry>> rows_;
    std::vector<double> leaving_;
    std::vector<bool> reached_;
    std::vector<char> complete_; ///< rows, written by several threads
};

} // namespace keiko
