#include "keiko/report/content/comparison.h"

#include "keiko/base/text.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

template <class Test>
std::vector<std::string> chosen(const Deviation& deviation, const std::vector<std::string>& names,
                                const Test& test) {
    std::vector<std::string> found;
    for (std::size_t i = 0; i < deviation.faces.size(); ++i)
        if (test(deviation.faces[i])) found.push_back(names[i]);
    return found;
}

constexpr double nothing = 1e-9; // mm: roundings

/// "(1, 2, 3)"
std::string triple(const Vec3& v, int digits) {
    return "(" + short_number(v.x, digits) + ", " + short_number(v.y, digits) + ", " +
           short_number(v.z, digits) + ")";
}

} // namespace

bool Comparison::same() const {
    const std::vector<ComparisonCheck> checks = comparison_checks(*this);
    return std::all_of(checks.begin(), checks.end(),
                       [](const ComparisonCheck& check) { return check.within; }) &&
           std::all_of(views.begin(), views.end(),
                       [](const ComparedView& view) { return view.picture.within(); });
}

std::vector<std::string> faces_gone(const Comparison& comparison) {
    return chosen(comparison.missing, comparison.faces_before,
                  [](const FaceDeviation& face) { return face.alone(); });
}

std::vector<std::string> faces_new(const Comparison& comparison) {
    return chosen(comparison.deviation, comparison.faces_after,
                  [](const FaceDeviation& face) { return face.alone(); });
}

std::vector<std::string> faces_turned(const Comparison& comparison) {
    constexpr double mostly = 0.5;
    return chosen(comparison.deviation, comparison.faces_after,
                  [](const FaceDeviation& face) { return face.turned > mostly && !face.alone(); });
}

bool is_alone(const LineShift& line) {
    constexpr double wander = 1, share = 0.01; // mm, and share of the length: tolerance where a
                                               // silhouette cuts it
    return line.alone > wander + share * line.length;
}

bool lines_within(const ComparedView& view, const BodyTolerance& tolerance) {
    const auto within = [&](const LineShift& line) {
        return line.largest <= tolerance.line && !is_alone(line);
    };
    return std::all_of(view.lines.begin(), view.lines.end(), within) &&
           std::all_of(view.after_lines.begin(), view.after_lines.end(), within);
}

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
