#include "keiko/trace/root_finder.h"

#include "keiko/patch/bernstein_roots.h"
#include "keiko/trace/hull_clip.h"
#include "keiko/trace/newton.h"
#include "keiko/trace/preconditioner.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

/// A clip that leaves more than this share of a range has found several roots, or a tangency:
/// splitting is quicker (Nishita, Sederberg & Kakimoto 1990, section 3.5).
constexpr double poor_clip = 0.8;
/// Of the domain: no box is split below.
constexpr double narrowest = 1e-12;
/// More boxes than any leaf with isolated roots was ever seen to need (a tangency takes some
/// hundreds). What is left then is taken as it is and flagged.
constexpr int most_boxes = 20000;

/// Of the domain: a narrower box may look flat only because it is narrow.
constexpr double thinnest_for_line = 1e-3;
/// Half sizes, of the domain: what rounding hides in a longer box is no point, but a stretch of
/// surface that the ray runs along.
constexpr double long_box = 1e-2;

struct Extremes {
    double low, high;
};

Extremes extremes(const double* c, std::size_t count) {
    Extremes e{c[0], c[0]};
    for (std::size_t i = 1; i < count; ++i) {
        e.low = std::min(e.low, c[i]);
        e.high = std::max(e.high, c[i]);
    }
    return e;
}

bool may_vanish(const Extremes& e, double slack) {
    return e.low <= slack && e.high >= -slack;
}
bool vanishes(const Extremes& e, double slack) {
    return e.low >= -slack && e.high <= slack;
}

/// How much the two functions vary along u and along v, summed along the steepest line.
Vec2 variation(const PlanarNet& net) {
    const std::size_t rows = net.rows(), columns = net.columns();
    const auto difference = [&](std::size_t a, std::size_t b) {
        return std::abs(net.f[a] - net.f[b]) + std::abs(net.g[a] - net.g[b]);
    };
    Vec2 most(0);
    for (std::size_t j = 0; j < columns; ++j) {
        double sum = 0;
        for (std::size_t i = 1; i < rows; ++i)
            sum += difference(i * columns + j, (i - 1) * columns + j);
        most.x = std::max(most.x, sum);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        double sum = 0;
        for (std::size_t j = 1; j < columns; ++j)
            sum += difference(i * columns + j, i * columns + j - 1);
        most.y = std::max(most.y, sum);
    }
    return most;
}

/// A plane through the ray in which the whole piece lies, as its coordinates in the normals of
/// the two planes of the net.
std::optional<Vec2> containing_plane(const PlanarNet& net, double slack) {
    const std::size_t last = net.size() - 1, row = net.columns() - 1, column = last - row;
    // The widest chord gives the direction across which a flat net has no extent.
    Vec2 chord(0);
    for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>{0, last}, {row, column}}) {
        const Vec2 d(net.f[b] - net.f[a], net.g[b] - net.g[a]);
        if (d.length2() > chord.length2()) chord = d;
    }
    if (!(chord.length2() > 0)) return std::nullopt;
    const Vec2 plane = Vec2(-chord.y, chord.x) / chord.length();
    for (std::size_t i = 0; i <= last; ++i)
        if (!(std::abs(plane.x * net.f[i] + plane.y * net.g[i]) <= slack)) return std::nullopt;
    return plane;
}

/// Where on an edge the ray meets it; at a corner by whatever rounding leaves there of zero. An
/// edge that lies in the ray has two ends.
std::vector<double> zeros_of_line(const std::vector<double>& c, double slack) {
    std::vector<double> zeros;
    if (!vanishes(extremes(c.data(), c.size()), slack)) zeros = bernstein_roots(c, 0);
    if (std::abs(c.front()) <= slack) zeros.push_back(0);
    if (std::abs(c.back()) <= slack) zeros.push_back(1);
    return zeros;
}

/// Both parameters' clips; where the net is not preconditioned each function may clip either.
struct Clip {
    ParameterInterval u, v;

    bool empty() const { return !(u.begin <= u.end && v.begin <= v.end); }
};

Clip clip(const Preconditioned& p) {
    const std::size_t rows = p.net.rows(), columns = p.net.columns();
    const std::span<const double> f(p.net.f.data(), p.net.size()), g(p.net.g.data(), p.net.size());
    Clip c{hull_clip(f, rows, columns, Axis::u, p.slack_f),
           hull_clip(g, rows, columns, Axis::v, p.slack_g)};
    if (p.regular) return c;
    const ParameterInterval u = hull_clip(g, rows, columns, Axis::u, p.slack_g);
    const ParameterInterval v = hull_clip(f, rows, columns, Axis::v, p.slack_f);
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
    return vanishes(extremes(p.net.f.data(), p.net.size()), 4 * p.slack_f) &&
           vanishes(extremes(p.net.g.data(), p.net.size()), 4 * p.slack_g);
}

/// Whether all of b lies where a has no second root beside it.
bool has_no_other(const LeafRoot& a, const LeafRoot& b) {
    const Vec2 apart = b.uv - a.uv;
    return std::abs(apart.x) + b.error.x <= a.alone.x && std::abs(apart.y) + b.error.y <= a.alone.y;
}

LeafRoot united(const LeafRoot& a, const LeafRoot& b) {
    Box2 box{a.uv - a.error, a.uv + a.error};
    box.extend(Box2{b.uv - b.error, b.uv + b.error});
    const Vec2 middle = box.center();
    const LeafRoot& wider = a.alone.length2() > b.alone.length2() ? a : b;
    const Vec2 moved(std::abs(middle.x - wider.uv.x), std::abs(middle.y - wider.uv.y));
    const Vec2 alone(std::max(0.0, wider.alone.x - moved.x),
                     std::max(0.0, wider.alone.y - moved.y));
    return {middle, box.extent() * 0.5, a.clipped || b.clipped, a.tangential || b.tangential,
            alone};
}

} // namespace

std::span<const LeafRoot> RootFinder::find(const PlanarNet& net, double slack) {
    whole_ = &net;
    slack_ = slack;
    roots_.clear();
    stretches_.clear();
    open_.assign(1, unit_square);
    for (int count = 0; !open_.empty(); ++count) {
        const Box2 box = open_.back();
        open_.pop_back();
        if (count >= most_boxes)
            accept_box(box);
        else if (box == unit_square)
            examine(net, box);
        else
            examine(restricted(net, box), box);
    }
    split_lines();
    // A tangency reaches on where rounding has just let go of it.
    for (LeafRoot& root : roots_)
        if (root.tangential) root.error *= 4;
    return roots_;
}

void RootFinder::examine(const PlanarNet& net, const Box2& box) {
    if (!may_vanish(extremes(net.f.data(), net.size()), slack_) ||
        !may_vanish(extremes(net.g.data(), net.size()), slack_))
        return;
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
            return add(
                {box.lower + box.extent() * root->uv, box.extent() * root->error, false, false});

    if (c.u.length() <= poor_clip || c.v.length() <= poor_clip)
        open_.push_back(inner);
    else if (inner.extent().x < narrowest && inner.extent().y < narrowest)
        accept_box(inner);
    else
        split(inner, variation(net));
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
            return add({grown.lower + grown.extent() * root->uv, grown.extent() * root->error,
                        false, false});
    const LeafRoot root{box.center(), half, true, !single, single ? half * wider : Vec2(0)};
    if (std::max(half.x, half.y) > long_box) stretches_.push_back(root);
    add(root);
}

void RootFinder::accept_line(const PlanarNet& net, const Box2& box, const Vec2& plane) {
    const std::size_t rows = net.rows(), columns = net.columns();
    // Across the plane nothing happens; in it, the other combination tells where the ray runs.
    const auto along = [&](std::size_t i) { return plane.x * net.g[i] - plane.y * net.f[i]; };
    Box2 line;
    std::vector<LeafRoot> ends;
    const auto edge = [&](std::size_t first, std::size_t step, std::size_t count, unsigned axis,
                          double across) {
        std::vector<double> c;
        for (std::size_t i = 0; i < count; ++i) c.push_back(along(first + i * step));
        for (const double t : zeros_of_line(c, 2 * slack_)) {
            Vec2 inside;
            inside[axis] = t;
            inside[1 - axis] = across;
            ends.push_back({box.lower + box.extent() * inside, Vec2(1e-12), true, true});
            line.extend(ends.back().uv);
        }
    };
    edge(0, columns, rows, 0, 0);
    edge(columns - 1, columns, rows, 0, 1);
    edge(0, 1, columns, 1, 0);
    edge((rows - 1) * columns, 1, columns, 1, 1);
    if (ends.empty()) return;
    if (box != unit_square) {
        ends.assign(1, {line.center(), line.extent() * 0.5 + Vec2(1e-12), true, true});
        stretches_.push_back(ends.front());
    }
    for (const LeafRoot& end : ends) add(end);
}

/// Of a stretch that crosses the whole domain, what counts is where the ray enters and leaves it.
/// Any other stretch is one tangency, however long rounding makes it.
void RootFinder::split_lines() {
    if (stretches_.empty()) return;
    constexpr double rounding = 1e-12;
    std::vector<LeafRoot> ends;
    std::erase_if(roots_, [&](const LeafRoot& root) {
        for (unsigned axis = 0; axis < 2; ++axis) {
            if (!(root.uv[axis] - root.error[axis] <= rounding &&
                  root.uv[axis] + root.error[axis] >= 1 - rounding))
                continue;
            const std::size_t before = ends.size();
            for (const LeafRoot& s : stretches_)
                for (const double at : {0.0, 1.0}) {
                    if (!(std::abs(s.uv[axis] - at) <= s.error[axis] + rounding)) continue;
                    LeafRoot end = s;
                    end.uv[axis] = at;
                    end.error[axis] = 4e-16;
                    end.tangential = true;
                    ends.push_back(end);
                }
            return ends.size() > before;
        }
        return false;
    });
    for (const LeafRoot& end : ends) add(end);
}

bool RootFinder::same(const LeafRoot& a, const LeafRoot& b) const {
    const Vec2 apart = a.uv - b.uv, reach = a.error + b.error + Vec2(1e-13);
    if (std::abs(apart.x) <= reach.x && std::abs(apart.y) <= reach.y) return true;
    if (has_no_other(a, b) || has_no_other(b, a)) return true;
    if (!a.tangential && !b.tangential) return false;
    // What rounding leaves of one tangency is scattered along the ray; the pieces are one as long
    // as between them the surface stays within rounding of the ray, measured across the surface:
    // a box's middle may well be off to the side. Both ends of a line in the surface remain two.
    constexpr double widest_tangency = 1e-3;
    if (!(apart.length() < widest_tangency)) return false;
    const PlanarPoint between = evaluate(*whole_, (a.uv + b.uv) / 2);
    const Vec2 along = between.du.length2() > between.dv.length2() ? between.du : between.dv;
    return std::abs(along.x * between.value.y - along.y * between.value.x) <=
           8 * slack_ * along.length();
}

void RootFinder::add(LeafRoot root) {
    for (std::size_t i = 0; i < roots_.size();) {
        const LeafRoot& known = roots_[i];
        if (!same(known, root)) {
            ++i;
            continue;
        }
        // A root found by clipping alone lies in any of the boxes that rounding left over.
        const bool proved =
            !known.tangential && !root.tangential && !(known.clipped && root.clipped);
        if (!proved)
            root = united(known, root);
        else if (!known.clipped)
            root = known;
        // What has grown may touch others that were apart before.
        roots_.erase(roots_.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0;
    }
    roots_.push_back(root);
}

} // namespace keiko
