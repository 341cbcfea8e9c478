#pragma once

#include "keiko/base/job.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace keiko {

/// Exchange areas A_i F_ij of all pairs of elements, mm2. They are symmetric by reciprocity, and
/// one number is kept for each pair: 400 MB for 10 000 elements.
class ExchangeAreas {
public:
    /// Exchange area of the elements i and j, j <= i.
    using OfPair = std::function<double(std::size_t i, std::size_t j)>;

    /// Computes the pairs of `areas.size()` elements, whose areas in mm2 are above 0, row by row on
    /// the threads of the job. Throws Cancelled.
    ExchangeAreas(std::vector<double> areas, const OfPair& of_pair, const Job& job = {});

    /// Number of elements.
    std::size_t size() const { return areas_.size(); }
    /// Area of an element, mm2.
    double area(std::size_t i) const { return areas_[i]; }
    /// Exchange area of two elements, mm2.
    double between(std::size_t i, std::size_t j) const {
        return i < j ? pairs_[place(j, i)] : pairs_[place(i, j)];
    }
    /// Form factor from an element to another: the share, 0 to 1, of the light that leaves the
    /// first for the second.
    double form_factor(std::size_t from, std::size_t to) const {
        return between(from, to) / areas_[from];
    }
    /// Sum of the form factors of an element: 1 in a closed scene.
    double row_sum(std::size_t i) const;
    /// Exchange areas of an element with all, in their order, mm2.
    std::vector<double> row(std::size_t i) const;

private:
    static std::size_t place(std::size_t larger, std::size_t smaller) {
        return larger * (larger + 1) / 2 + smaller;
    }

    std::vector<double> areas_, pairs_;
};

} // namespace keiko
