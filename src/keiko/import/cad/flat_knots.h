#pragma once

#include "keiko/import/cad/curve_span.h"

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>

#include <vector>

namespace keiko::cad {

/// Knots written out with their multiplicity. Neighbours closer than `same_parameter` of the
/// whole range become one, so that no span is thinner than rounding.
inline std::vector<double> flat_knots(const TColStd_Array1OfReal& knots,
                                      const TColStd_Array1OfInteger& multiplicities) {
    const double merge = same_parameter * (knots.Last() - knots.First());
    std::vector<double> flat;
    for (int i = knots.Lower(); i <= knots.Upper(); ++i) {
        const bool same = !flat.empty() && knots(i) - flat.back() <= merge;
        flat.insert(flat.end(), static_cast<std::size_t>(multiplicities(i)),
                    same ? flat.back() : knots(i));
    }
    return flat;
}

/// The whole numbers k for which [begin, end] + k period overlaps [first, last]; 0 alone where
/// `period` is 0.
struct PeriodRange {
    int first = 0, last = 0;

    PeriodRange(double begin, double end, double wanted_first, double wanted_last, double period) {
        if (!(period > 0)) return;
        first = static_cast<int>(std::floor((wanted_first - end) / period)) + 1;
        last = static_cast<int>(std::ceil((wanted_last - begin) / period)) - 1;
        last = std::max(first, last);
    }
};

} // namespace keiko::cad
