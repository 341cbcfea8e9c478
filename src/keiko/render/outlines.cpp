#include "keiko/render/outlines.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {

bool differ(const EyeSample& a, const EyeSample& b) {
    if (!a.hit || !b.hit) return (a.hit != nullptr) != (b.hit != nullptr);
    return a.mirrored_face.has_value() != b.mirrored_face.has_value() ||
           !continues(place_of(a), place_of(b));
}

bool look_alike(const EyeSample& a, const EyeSample& b) {
    if ((a.hit != nullptr) != (b.hit != nullptr)) return false;
    if ((a.lit || b.lit) && differ(a, b)) return false;
    const auto near = [](double x, double y) {
        return std::abs(x - y) <= 0.01 * std::max(std::abs(x), std::abs(y));
    };
    return near(a.luminance.r, b.luminance.r) && near(a.luminance.g, b.luminance.g) &&
           near(a.luminance.b, b.luminance.b);
}

std::vector<Outline> outlines_of(std::span<const EyeSample> samples, int width) {
    const auto w = static_cast<std::size_t>(width);
    const auto outline = [&](std::size_t i) {
        if (samples[i].torn) return Outline::torn;
        const auto off = [&](std::size_t other) { return differ(samples[i], samples[other]); };
        const std::array around{i - w - 1, i - w,     i - w + 1, i - 1,
                                i + 1,     i + w - 1, i + w,     i + w + 1};
        return std::any_of(around.begin(), around.end(), off) ? Outline::likely : Outline::none;
    };
    std::vector<Outline> outlines;
    for (std::size_t row = w; row + w < samples.size(); row += w)
        for (std::size_t x = 1; x + 1 < w; ++x) outlines.push_back(outline(row + x));
    return outlines;
}

} // namespace keiko
