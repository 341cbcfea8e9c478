#pragma once

#include <array>
#include <optional>
#include <span>

namespace keiko {

/// A place of a surface beside a tangent plane, mm, and how much it counts.
struct Height {
    double x = 0, y = 0, z = 0;
    double weight = 1;
};

/// The form under a dent: a polynomial of total degree 4 over the plane that goes by most heights;
/// those that lie off the others by far do not count. By iteratively reweighted least squares,
/// first to the smallest sum of distances, then with Tukey's biweight (Holland and Welsch 1977), as
/// ISO 16610-31 does for profiles.
class SmoothBase {
public:
    static constexpr std::size_t term_count = 15;

    /// Of the heights within `reach` of the origin, mm. Nothing where they are too few or too close
    /// to a line.
    static std::optional<SmoothBase> fit(std::span<const Height> heights, double reach);

    double height(double x, double y) const;

private:
    double reach_ = 1;
    std::array<double, term_count> terms_{};
};

} // namespace keiko
