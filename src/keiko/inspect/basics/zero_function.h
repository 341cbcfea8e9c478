#pragma once

#include "keiko/inspect/basics/patch_lines.h"

#include <optional>

namespace keiko {

/// A smooth function of a patch's parameters whose zeros are curves on the patch.
class ZeroFunction {
public:
    virtual ~ZeroFunction() = default;

    virtual double operator()(const Vec2& uv) const = 0;
    virtual LinePoint point(const Vec2& uv) const = 0;

    /// The root between two places of opposite sign, by the Illinois form of the secant rule
    /// [DowellJarratt1971]. That keeps the root between its ends; halving replaces it where it is
    /// slow.
    Vec2 root(Vec2 a, double at_a, Vec2 b, double at_b) const;

    /// A point of the line between two others near each other on it, beside the given share of
    /// their chord; nullopt if no change of sign locates it.
    std::optional<LinePoint> between(const LinePoint& a, const LinePoint& b, double share) const;
};

} // namespace keiko
