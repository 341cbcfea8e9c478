#include "keiko/scene/axes_remark.h"

#include <cmath>
#include <string>

namespace keiko {
namespace {

/// Share of its extent by which an even box may miss the plane, and one that is not even must.
constexpr double even = 1e-3, uneven = 0.02;

/// How far the middle of the box is from 0 along an axis, as share of its extent.
double offset(const Box3& body, int axis) {
    return std::abs(body.center()[axis]) / body.extent()[axis];
}

Diagnostic remark(const char* plane, const char* suggestion) {
    return {Severity::note, "axes",
            std::string("the body lies evenly about ") + plane +
                " = 0, not about y = 0, the middle plane of a vehicle: named views take x as "
                "rearwards, y as to the right and z as up; where y is up, axes " +
                suggestion + " turns it"};
}

} // namespace

std::optional<Diagnostic> axes_remark(const Box3& body) {
    if (body.empty() || !(body.center().y > 0) || !(offset(body, 1) > uneven)) return {};
    const bool about_x = offset(body, 0) < even, about_z = offset(body, 2) < even;
    if (about_x == about_z) return {};
    return about_x ? remark("x", "z,x,y") : remark("z", "x,-z,y");
}

} // namespace keiko
