#include "keiko/report/content/comparison_words.h"

#include "keiko/base/text.h"
#include "keiko/report/markup/html_text.h"

#include <cmath>

namespace keiko {
namespace {

constexpr double nothing = 1e-9; // mm: roundings

/// "(1, 2, 3)"
std::string triple(const Vec3& v, int digits) {
    return "(" + short_number(v.x, digits) + ", " + short_number(v.y, digits) + ", " +
           short_number(v.z, digits) + ")";
}

} // namespace

std::string distance_words(double value, double reach) {
    if (std::isinf(value)) return "further than " + short_number(reach) + " mm";
    return (std::abs(value) < nothing ? "< 1e-9" : short_number(value)) + std::string(" mm");
}

std::string at_most(double value, double reach) {
    const bool in_words = std::isinf(value) || std::abs(value) < nothing;
    return (in_words ? "" : "at most ") + distance_words(std::abs(value), reach);
}

std::string picture_words(const PictureOutcome& picture) {
    if (!picture.problem.empty()) return picture.problem;
    if (picture.within()) return "the same within tolerance";
    std::string text = counted(picture.coverage_flips, "pixel") + " of the outline, " +
                       std::to_string(picture.face_flips) + " of another face";
    for (const LayerDifference& layer : picture.layers)
        if (!layer.within)
            text +=
                "; " + layer.layer + " beyond its tolerance in " + counted(layer.beyond, "pixel");
    return text;
}

std::string alignment_words(const Alignment& a) {
    constexpr int digits = 6;
    return "turned by " + short_number(a.angle, digits) + " degrees about " +
           triple(a.axis, digits) + ", its centre shifted by " + triple(a.shift, digits) +
           " mm; root mean square distance left " + short_number(a.residual) + " mm" +
           (a.converged ? "" : "; not converged");
}

} // namespace keiko
