#pragma once

#include "keiko/base/job.h"
#include "keiko/math/rgb.h"
#include "keiko/radiosity/element_mesh.h"
#include "keiko/radiosity/hemicube.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Exchange areas of the faces of elements, all fronts, then all backs, by hemicubes in the middles
/// of the four quarters of each triangle. A row is computed when it is needed first, with some that
/// are likely to be next, and kept.
class ElementRows {
public:
    /// `cells`: of the hemicubes. `order`: of the faces as rows are likely to be needed. Keeps
    /// references to the elements and the job.
    ElementRows(const ElementMesh& elements, int cells, std::vector<std::size_t> order,
                const Job& job);

    /// Exchange areas of a face with all, in their order, mm2. Throws Cancelled.
    std::vector<double> row(std::size_t face);
    /// Light that faces receive of these radiosities, lx, each by its own row: for equal
    /// radiosities the rounding of outlines to cells cancels. Throws Cancelled.
    std::vector<Rgb> gathered(std::span<const Rgb> radiosity, std::span<const std::size_t> faces);
    /// Light of these radiosities that no element receives, lm/m2 times mm2: what the rows of
    /// `faces` lack of 1. Throws Cancelled.
    Rgb escaped(std::span<const Rgb> radiosity, std::span<const std::size_t> faces);
    /// Area of a face, mm2.
    double area(std::size_t face) const { return elements_.area(face % elements_.size()); }
    /// Number of rows computed so far.
    std::size_t computed() const { return computed_; }

private:
    /// A face and its form factor.
    struct Entry {
        std::uint32_t face;
        float factor;
    };

    std::vector<Entry> computed_row(std::size_t face) const;
    void compute(std::span<const std::size_t> faces);
    void compute_missing(std::span<const std::size_t> faces);

    const ElementMesh& elements_;
    Hemicube cube_;
    std::vector<std::size_t> order_;
    const Job& job_;
    std::size_t next_ = 0; ///< into order_
    std::size_t computed_ = 0;
    std::vector<std::optional<std::vector<Entry>>> rows_; ///< a face
};

} // namespace keiko
