#include "keiko/inspect/structure/span_widths.h"

#include "keiko/inspect/structure/least_value.h"

#include <algorithm>
#include <limits>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// mm: no isoline across the patch is longer. A leg of an isoline's control polygon is a mean of
/// those of the net, if the weights are a product of two factors; else their ratios add some.
double longest_isoline(const std::vector<CurvePoints>& curves) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < curves.front().size(); ++i) {
        double leg = 0, extent = 0, least = infinity, most = 0;
        const Vec3 from = euclidean(curves.front()[i]);
        for (const CurvePoints& curve : curves) {
            const Vec3 p = euclidean(curve[i]);
            leg = std::max(leg, (euclidean(curve[i + 1]) - p).length());
            extent = std::max(extent, (p - from).length());
            const double ratio = curve[i + 1].w / curve[i].w;
            least = std::min(least, ratio), most = std::max(most, ratio);
        }
        length += leg + (most / least - 1) * extent;
    }
    return length;
}

/// Bounds of the width of a span, the longest isoline across it, mm.
struct Width {
    double least = 0, most = 0;
    Vec3 place{0}; ///< world: the middle of its longest edge
};

/// The width is at least that of the edges of its patches.
Width width_of(const std::vector<const SpanNet*>& patches, bool in_u) {
    Width width;
    for (const SpanNet* net : patches) {
        const std::vector<CurvePoints> curves = net->rows(in_u);
        for (const CurvePoints* edge : {&curves.front(), &curves.back()}) {
            const double length = curve_length(*edge).least;
            if (length < width.least) continue;
            width.least = length, width.place = net->world(curve_middle(*edge));
        }
        width.most = std::max(width.most, longest_isoline(curves));
    }
    width.most = std::max(width.least, width.most);
    return width;
}

/// The longest chord of the edges across a span, mm: the span is at least that wide.
double least_width(const std::vector<const SpanNet*>& patches, bool in_u) {
    double least = 0;
    for (const SpanNet* net : patches) {
        const std::size_t last = (in_u ? net->count_v() : net->count_u()) - 1;
        for (const std::size_t k : {std::size_t{0}, last})
            least = std::max(least, chord_length(in_u ? net->along_u(k) : net->along_v(k)));
    }
    return least;
}

/// The ratio of two widths, the larger by the smaller, at the narrower span.
MeasuredValue ratio_of(const Width& a, const Width& b, double limit) {
    const auto shortest = [](const Width& width) { return std::max(width.least, 1e-300); };
    const double least =
        std::max({1.0, a.least / std::max(b.most, 1e-300), b.least / std::max(a.most, 1e-300)});
    const double most = std::max({least, a.most / shortest(b), b.most / shortest(a)});
    const double value = (least + most) / 2, bound = (most - least) / 2;
    return {value, bound, limit, (a.most < b.most ? a : b).place, judge(value, bound, limit),
            false};
}

} // namespace

Spans spans_of(const std::vector<SpanNet>& nets, bool in_u) {
    Spans spans;
    for (const SpanNet& net : nets) {
        const ParameterMap& map = in_u ? net.patch->map_u : net.patch->map_v;
        spans[{map.begin, map.end}].push_back(&net);
    }
    return spans;
}

MeasuredValue knot_distance(const std::vector<SpanNet>& nets, double limit) {
    std::optional<MeasuredValue> narrowest;
    for (const bool in_u : {true, false})
        for (const auto& [knots, patches] : spans_of(nets, in_u)) {
            if (narrowest && least_width(patches, in_u) > std::max(limit, narrowest->value))
                continue;
            const Width width = width_of(patches, in_u);
            const MeasuredValue found = at_least(
                (width.least + width.most) / 2, (width.most - width.least) / 2, limit, width.place);
            narrowest = narrowest ? lesser_of(*narrowest, found) : found;
        }
    return *narrowest;
}

std::optional<MeasuredValue> largest_width_ratio(const std::vector<SpanNet>& nets, double limit) {
    std::optional<MeasuredValue> largest;
    for (const bool in_u : {true, false}) {
        std::optional<std::pair<double, Width>> last; // the knot where it ends
        for (const auto& [knots, patches] : spans_of(nets, in_u)) {
            const Width width = width_of(patches, in_u);
            if (last && last->first == knots.first) {
                const MeasuredValue found = ratio_of(last->second, width, limit);
                keep_worse(largest, found);
            }
            last.emplace(knots.second, width);
        }
    }
    return largest;
}

} // namespace keiko
