#pragma once

#include "keiko/math/function_place.h"

namespace keiko {

/// The lesser part of the golden section, (3 - sqrt 5) / 2.
constexpr double golden_section = 0.3819660112501051;

/// Golden-section search: a local minimum of `f` between `low` and `high`, from a place between
/// them with a known value [Kiefer1953]. The bracket is narrowed until it is no wider than
/// `enough`; each evaluation narrows it by 0.618 where `first` divides it by the golden section.
/// Returns the lowest place evaluated, of equal ones the earliest. The ends themselves are not
/// evaluated. Requires low < first.at < high and enough > 0.
template <class F>
FunctionPlace golden_section_minimum(const F& f, double low, const FunctionPlace& first,
                                     double high, double enough) {
    FunctionPlace best = first;
    while (high - low > enough) {
        const bool right = high - best.at > best.at - low;
        const double next = best.at + golden_section * (right ? high - best.at : low - best.at);
        const double value = f(next);
        if (value < best.value) {
            (right ? low : high) = best.at;
            best = {next, value};
        } else {
            (right ? high : low) = next;
        }
    }
    return best;
}

/// Golden-section search between two ends, from the golden section of the interval.
template <class F>
FunctionPlace golden_section_minimum(const F& f, double low, double high, double enough) {
    const double first = low + golden_section * (high - low);
    return golden_section_minimum(f, low, {first, f(first)}, high, enough);
}

} // namespace keiko
