#include "keiko/intersect/roots/root_finder.h"

#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/intersect/roots/planar_net.h"
#include "keiko/intersect/roots/preconditioner.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

/// A clip that leaves more than this share of a range has found several roots, or a tangency:
/// splitting is quicker [Nishita1990, section 3.5].
constexpr double poor_clip = 0.8;
/// Share of the domain below which no box is split.
constexpr double narrowest = 1e-12;
/// More boxes than any sub-patch with isolated roots was ever seen to need (a tangency mostly takes
/// some hundreds). What may hold a root then is taken as it is and flagged.
constexpr int most_boxes = 20000;

/// Share of the domain: a narrower box may be flat only because it is narrow.
constexpr double thinnest_for_line = 1e-3;
/// Half sizes, of the domain: what rounding hides in a longer box is no point, but a stretch of
/// surface that the ray runs along.
constexpr double long_box = 1e-2;

std::span<const double> f_of(const PlanarNet& net) {
    return std::span(net.f).first(net.size());
}
std::span<const double> g_of(const PlanarNet& net) {
    return std::span(net.g).first(net.size());
}

struct Extremes {
    double low, high;

    bool may_vanish(double slack) const { return low <= slack && high >= -slack; }
    bool vanish(double slack) const { return low >= -slack && high <= slack; }
};

Extremes extremes(std::span<const double> c) {
    const auto [low, high] = std::minmax_element(c.begin(), c.end());
    return {*low, *high};
}

/// Places on an edge where the ray meets it; at a corner they depend on rounding about zero. An
/// edge that lies in the ray has two ends.
std::vector<double> zeros_of_edge(const std::vector<double>& c, double slack) {
    std::vector<double> zeros;
    if (!extremes(c).vanish(slack)) zeros = bernstein_roots(c, 0);
    if (std::abs(c.front()) <= slack) zeros.push_back(0);
    if (std::abs(c.back()) <= slack) zeros.push_back(1);
    return zeros;
}

/// Place where a ray that lies in the surface may meet an edge of [0, 1]^2.
struct LineEnd {
    Vec2 at;
    double error = 0; ///< in either parameter
};

/// Across the plane nothing happens; in it, the other combination of f and g tells where the ray
/// runs, as well as `slack` lets it.
std::vector<LineEnd> ends_of_line(const PlanarNet& net, const Vec2& plane, double slack) {
    const std::size_t rows = net.rows(), columns = net.columns();
    std::vector<LineEnd> ends;
    const auto edge = [&](std::size_t first, std::size_t step, std::size_t count, unsigned axis,
                          double across) {
        std::vector<double> c;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = first + i * step;
            c.push_back(plane.x * net.g[at] - plane.y * net.f[at]);
        }
        const auto [low, high] = extremes(c);
        constexpr double least = 1e-12;
        const double error = high > low ? std::clamp(4 * slack / (high - low), least, 1.0) : 1;
        for (const double t : zeros_of_edge(c, slack)) {
            ends.push_back({Vec2(across), error});
            ends.back().at[axis] = t;
        }
    };
    edge(0, columns, rows, 0, 0);
    edge(columns - 1, columns, rows, 0, 1);
    edge(0, 1, columns, 1, 0);
    edge((rows - 1) * columns, 1, columns, 1, 1);
    return ends;
}

/// Both parameters' clips; where the net is not preconditioned each function may clip either.
struct Clip {
    ParameterInterval u, v;

    bool empty() const { return !(u.begin <= u.end && v.begin <= v.end); }
};

Clip clip(const Preconditioned& p) {
    const std::size_t rows = p.net.rows(), columns = p.net.columns();
    const std::span<const double> f = f_of(p.net), g = g_of(p.net);
    Clip c{clip_interval(f, rows, columns, Axis::u, p.slack_f),
           clip_interval(g, rows, columns, Axis::v, p.slack_g)};
    if (p.regular) return c;
    const ParameterInterval u = clip_interval(g, rows, columns, Axis::u, p.slack_g);
    const ParameterInterval v = clip_interval(f, rows, columns, Axis::v, p.slack_f);
    return {{std::max(c.u.begin, u.begin), std::min(c.u.end, u.end)},
            {std::max(c.v.begin, v.begin), std::min(c.v.end, v.end)}};
}

Box2 inner_box(const Box2& outer, const Clip& clip) {
    const Vec2 extent = outer.extent();
    return {outer.lower + extent * Vec2(clip.u.begin, clip.v.begin),
            outer.lower + extent * Vec2(clip.u.end, clip.v.end)};
}

/// Whether rounding hides what the functions do on the box. Asked after preconditioning: near a
/// tangency that lies askew to u and v the plain functions stay large in the box's corners, and
/// boxes small enough for them would number millions.
bool is_noise(const Preconditioned& p) {
    return extremes(f_of(p.net)).vanish(4 * p.slack_f) &&
           extremes(g_of(p.net)).vanish(4 * p.slack_g);
}

} // namespace

std::span<const SubPatchRoot> RootFinder::find(const PlanarNet& net, double slack) {
    whole_ = &net;
    slack_ = slack;
    roots_.start(net, slack);
    open_.assign(1, unit_square);
    for (int count = 0; !open_.empty(); ++count) {
        const Box2 box = open_.back();
        open_.pop_back();
        if (count >= most_boxes)
            accept_unless_clear(box);
        else if (box == unit_square)
            examine(net, box);
        else
            examine(restricted(net, box), box);
    }
    return roots_.finish();
}

void RootFinder::examine(const PlanarNet& net, const Box2& box) {
    if (!extremes(f_of(net)).may_vanish(slack_) || !extremes(g_of(net)).may_vanish(slack_)) return;
    const Preconditioned p = preconditioned(net, slack_);
    if (is_noise(p)) return accept_box(box);
    if (std::min(box.extent().x, box.extent().y) > thinnest_for_line)
        if (const auto plane = containing_plane(net, 2 * slack_))
            return accept_line(net, box, *plane);
    const Clip c = clip(p);
    if (c.empty()) return;
    const Box2 inner = inner_box(box, c);
    if (!clipping_only_ && at_most_one_root(p))
        if (const auto root = newton(p, Vec2(c.u.begin + c.u.end, c.v.begin + c.v.end) * 0.5))
            return roots_.add(
                {box.lower + box.extent() * root->uv, box.extent() * root->error, false, false});

    if (c.u.length() <= poor_clip || c.v.length() <= poor_clip)
        open_.push_back(inner);
    else if (inner.extent().x < narrowest && inner.extent().y < narrowest)
        accept_box(inner);
    else
        split(inner, variation(net));
}

void RootFinder::accept_unless_clear(const Box2& box) {
    const PlanarNet net = restricted(*whole_, box);
    if (extremes(f_of(net)).may_vanish(slack_) && extremes(g_of(net)).may_vanish(slack_))
        accept_box(box);
}

void RootFinder::split(const Box2& box, const Vec2& variation) {
    const Vec2 size = box.extent();
    const bool along_u = size.y < narrowest || (size.x >= narrowest && variation.x >= variation.y);
    const unsigned axis = along_u ? 0 : 1;
    Box2 low = box, high = box;
    low.upper[axis] = high.lower[axis] = box.center()[axis];
    open_.push_back(high);
    open_.push_back(low);
}

void RootFinder::accept_box(const Box2& box) {
    // Rounding hides what happens in the box itself; a wider look tells one root from several.
    constexpr double wider = 64;
    const Vec2 half = box.extent() * 0.5 + Vec2(4e-16);
    // Not past the net's own ends, where its coefficients' errors grow with the degree.
    const Box2 grown =
        unit_square.intersection({box.center() - half * wider, box.center() + half * wider});
    const Preconditioned wide = preconditioned(restricted(*whole_, grown), slack_);
    const bool single = at_most_one_root(wide);
    if (single && !clipping_only_)
        if (const auto root = newton(wide, Vec2(0.5)))
            return roots_.add({grown.lower + grown.extent() * root->uv,
                               grown.extent() * root->error, false, false});
    const SubPatchRoot root{box.center(), half, true, !single, single ? half * wider : Vec2(0)};
    if (std::max(half.x, half.y) > long_box) return roots_.add_stretch(root);
    roots_.add(root);
}

void RootFinder::accept_line(const PlanarNet& net, const Box2& box, const Vec2& plane) {
    const std::vector<LineEnd> ends = ends_of_line(net, plane, 2 * slack_);
    Box2 line;
    for (const LineEnd& end : ends) {
        const Vec2 middle = box.lower + box.extent() * end.at, half = box.extent() * end.error;
        if (box == unit_square) roots_.add({middle, half, true, true});
        line.extend(Box2{middle - half, middle + half});
    }
    if (box != unit_square && !ends.empty())
        roots_.add_stretch({line.center(), line.extent() * 0.5, true, true});
}

} // namespace keiko
