#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

namespace keiko {

/// What a metric is a number of.
enum class Quantity {
    count,     ///< of faces, seams, ...
    verdict,   ///< "pass", "undecided" or "fail"
    place,     ///< mm, a coordinate
    length,    ///< mm
    area,      ///< mm2
    direction, ///< a component of a mean unit vector
    gap,       ///< mm
    angle,     ///< degrees
    curvature, ///< mismatch across a seam: share of 1, or 1/mm where nearly flat
    slope,     ///< degrees, of the curvature's slope
    line,      ///< mm of reflection lines
    share      ///< of 1
};

constexpr std::size_t quantity_count = 12;

/// "gap"
std::string_view name_of(Quantity quantity);
/// "mm", "deg", ...; empty for what has none.
std::string_view unit_of(Quantity quantity);
/// Throws Error for a name that is no quantity.
Quantity quantity_by_name(std::string_view name);

/// A number or a word that a fixture is guarded by.
struct Metric {
    std::string check; ///< "shape", "seams" or "lines"
    std::string name;  ///< unique within the check, e.g. "face 3 (roof): area"
    Quantity quantity = Quantity::count;
    std::variant<double, std::string> value; ///< a word for verdicts only

    bool operator==(const Metric&) const = default;
};

/// How far apart two numbers may be: `absolute` + `relative` times the larger of their sizes.
struct MetricTolerance {
    double absolute = 0, relative = 0;

    bool operator==(const MetricTolerance&) const = default;
};

/// That of each quantity. The defaults leave room for another compiler or processor, not for
/// another shape: an inner control point moved by 10 um shows (docs/regression.md).
struct MetricTolerances {
    std::array<MetricTolerance, quantity_count> each{{{0, 0},
                                                      {0, 0},
                                                      {1e-6, 1e-12},
                                                      {1e-6, 1e-9},
                                                      {1e-6, 1e-9},
                                                      {1e-9, 0},
                                                      {1e-5, 0},
                                                      {1e-4, 0},
                                                      {1e-6, 1e-4},
                                                      {1e-3, 0},
                                                      {0.1, 1e-3},
                                                      {1e-6, 0}}};

    const MetricTolerance& operator[](Quantity quantity) const {
        return each[static_cast<std::size_t>(quantity)];
    }
    MetricTolerance& operator[](Quantity quantity) {
        return each[static_cast<std::size_t>(quantity)];
    }

    bool operator==(const MetricTolerances&) const = default;
};

} // namespace keiko
