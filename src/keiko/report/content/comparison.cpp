#include "keiko/report/content/comparison.h"

#include <algorithm>

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

} // namespace keiko
