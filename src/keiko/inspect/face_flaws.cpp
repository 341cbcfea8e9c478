#include "keiko/inspect/face_flaws.h"

#include "keiko/inspect/face_grid.h"
#include "keiko/inspect/ripple.h"
#include "keiko/inspect/smooth_base.h"
#include "keiko/inspect/wave_section.h"
#include "keiko/math/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace keiko {
namespace {

/// Of the window's width.
constexpr double sample_share = 1.0 / 20;
/// What is deeper than this share of the window is form, not a flaw.
constexpr double deepest_share = 1.0 / 50;
/// A depth that changes by more than this share of it with how much around is looked at may be
/// form.
constexpr double form_share = 0.25;
/// Ripples are looked for down to this share of the limit: they tell of a depth only about.
constexpr double ripple_share = 1.0 / 8;
/// How many of the deepest ripples of a flaw are measured.
constexpr std::size_t most_measured = 4;

/// A ripple on the face.
struct Candidate {
    Vec2 place{0}; ///< in the grid
    Vec3 position{0};
    double width = 0, depth = 0;
    bool along_u = true; ///< the line that shows it
};

/// A plane that touches the surface, to look from at what is around.
struct Outlook {
    Vec3 origin, x, y, z;

    Height height(const Vec3& position, double weight) const {
        const Vec3 from = position - origin;
        return {from.dot(x), from.dot(y), from.dot(z), weight};
    }
};

/// How far the surface at a place lies off its base, mm, positive outwards.
struct Measured {
    double offset = 0;
    Vec2 place{0};
    Vec3 position{0};
};

class FlawSearch {
public:
    FlawSearch(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
               const WavinessLimit& limit)
        : limit_(limit),
          reach_(limit.window / 2),
          grid_(model, instance, face, limit.window * sample_share) {}

    std::vector<Flaw> run() {
        collect();
        std::vector<Flaw> flaws;
        for (const std::vector<Candidate>& group : groups()) {
            const auto flaw = judged(group);
            if (flaw && flaw->depth.value >= limit_.depth / 2) flaws.push_back(*flaw);
        }
        std::stable_sort(flaws.begin(), flaws.end(), [](const Flaw& a, const Flaw& b) {
            return a.depth.value > b.depth.value;
        });
        return flaws;
    }

private:
    void collect() {
        for (std::size_t row = 0; row < grid_.rows(); ++row)
            collect_line(
                grid_.columns(), [&](std::size_t k) { return std::pair(k, row); },
                &FaceSample::bend_u);
        for (std::size_t column = 0; column < grid_.columns(); ++column)
            collect_line(
                grid_.rows(), [&](std::size_t k) { return std::pair(column, k); },
                &FaceSample::bend_v);
    }

    /// The ripples of each stretch of a line that is material.
    template <class IndexOf>
    void collect_line(std::size_t count, const IndexOf& index_of, double FaceSample::*bend) {
        std::vector<LinePoint> line;
        const auto sample = [&](std::size_t k) -> const FaceSample& {
            const auto [column, row] = index_of(k);
            return grid_.sample(column, row);
        };
        for (std::size_t k = 0; k <= count; ++k) {
            if (k < count && sample(k).material) {
                const double step =
                    line.empty() ? 0 : (sample(k).position - sample(k - 1).position).length();
                line.push_back({line.empty() ? 0 : line.back().length + step, sample(k).*bend});
                continue;
            }
            const std::size_t begin = k - line.size();
            for (const Ripple& r : find_ripples(line, limit_.depth * ripple_share, limit_.window)) {
                const auto [column, row] = index_of(begin + r.index);
                candidates_.push_back({grid_.place(column, row), grid_.sample(column, row).position,
                                       r.width, r.depth, bend == &FaceSample::bend_u});
            }
            line.clear();
        }
    }

    std::array<int, 3> cell_of(const Vec3& position) const {
        const auto number = [this](double x) {
            return static_cast<int>(std::floor(2 * x / reach_));
        };
        return {number(position.x), number(position.y), number(position.z)};
    }

    /// Those in the same or in neighbouring cells of a quarter of the window, each group's deepest
    /// first.
    std::vector<std::vector<Candidate>> groups() {
        std::stable_sort(candidates_.begin(), candidates_.end(),
                         [](const Candidate& a, const Candidate& b) {
                             return std::abs(a.depth) > std::abs(b.depth);
                         });
        DisjointSets sets(candidates_.size());
        std::map<std::array<int, 3>, std::size_t> cells;
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
            const std::array<int, 3> cell = cell_of(candidates_[i].position);
            cells.try_emplace(cell, i);
            for (int k = 0; k < 27; ++k) {
                const auto near =
                    cells.find({cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1});
                if (near != cells.end()) sets.join(i, near->second);
            }
        }
        std::map<std::size_t, std::size_t> number;
        std::vector<std::vector<Candidate>> found;
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
            const auto [at, fresh] = number.try_emplace(sets.root(i), found.size());
            if (fresh) found.emplace_back();
            found[at->second].push_back(candidates_[i]);
        }
        return found;
    }

    std::optional<Flaw> judged(const std::vector<Candidate>& group) const {
        const bool waves = to_and_fro(group);
        std::optional<Flaw> deepest;
        std::size_t measured = 0;
        for (const Candidate& candidate : group) {
            const auto flaw = waves ? wave(candidate) : dent(candidate);
            if (!flaw) continue; // beside a border
            if (!deepest || flaw->depth.value > deepest->depth.value) deepest = flaw;
            if (++measured == most_measured) break;
        }
        if (deepest && deepest->depth.value > limit_.window * deepest_share) return std::nullopt;
        return deepest;
    }

    Flaw flaw(Flaw::Kind kind, double depth, double bound, const Vec3& place, double width) const {
        Verdict verdict = judge(depth, bound, limit_.depth);
        if (bound > form_share * depth) verdict = std::min(verdict, Verdict::undecided);
        return {kind, {depth, bound, limit_.depth, place, verdict, false}, width};
    }

    std::optional<Flaw> wave(const Candidate& c) const {
        const auto found = wave_section(grid_, c.place, c.along_u, c.depth < 0, c.width);
        if (!found) return std::nullopt;
        return flaw(Flaw::Kind::waves, std::abs(found->depth), found->bound, found->position,
                    found->length);
    }

    std::optional<Flaw> dent(const Candidate& c) const {
        const auto found = climbed(c);
        if (!found) return std::nullopt;
        constexpr double less = 0.8;
        const auto again = offset_at(found->place, less * reach_);
        if (!again) return std::nullopt;
        return flaw(found->offset < 0 ? Flaw::Kind::dent : Flaw::Kind::bump,
                    std::abs(found->offset), std::abs(*again - found->offset), found->position,
                    c.width);
    }

    /// Whether a group has crests and troughs that are nearly as deep.
    static bool to_and_fro(const std::vector<Candidate>& group) {
        const double first = group.front().depth;
        return std::any_of(group.begin(), group.end(), [first](const Candidate& c) {
            return c.depth * first < 0 && std::abs(c.depth) > std::abs(first) / 2;
        });
    }

    std::optional<Outlook> outlook(const Vec2& place) const {
        const auto s = grid_.evaluate(place, 1);
        if (!s) return std::nullopt;
        const Vec3 x = s->du().normalized();
        const Vec3 z = s->du().cross(s->dv()).normalized() * grid_.sign();
        return Outlook{s->position(), x, z.cross(x), z};
    }

    std::optional<SmoothBase> base(const Outlook& from, double reach) const {
        std::vector<Height> heights;
        std::array<std::size_t, 4> quarters{};
        for (std::size_t row = 0; row < grid_.rows(); ++row)
            for (std::size_t column = 0; column < grid_.columns(); ++column) {
                const FaceSample& sample = grid_.sample(column, row);
                if (!sample.material || (sample.position - from.origin).length() > reach) continue;
                heights.push_back(from.height(sample.position, sample.area));
                ++quarters[(heights.back().x > 0 ? 1u : 0u) + (heights.back().y > 0 ? 2u : 0u)];
            }
        // Beside a border there is form on one side only.
        constexpr std::size_t least_share = 20;
        for (const std::size_t quarter : quarters)
            if (quarter * least_share < heights.size()) return std::nullopt;
        return SmoothBase::fit(heights, reach);
    }

    std::optional<double> offset_at(const Vec2& place, double reach) const {
        const auto from = outlook(place);
        if (!from) return std::nullopt;
        const auto under = base(*from, reach);
        if (!under) return std::nullopt;
        return -under->height(0, 0);
    }

    /// From a ripple to where the surface is furthest off the base around it.
    std::optional<Measured> climbed(const Candidate& candidate) const {
        Vec2 place = candidate.place;
        constexpr int rounds = 3;
        for (int i = 0; i < rounds; ++i) {
            const auto from = outlook(place);
            if (!from) return std::nullopt;
            const auto under = base(*from, reach_);
            if (!under) return std::nullopt;
            place = furthest(place, *from, *under);
        }
        const auto from = outlook(place);
        const auto offset = offset_at(place, reach_);
        if (!from || !offset) return std::nullopt;
        return Measured{*offset, place, from->origin};
    }

    /// By steps along u and v that are halved where none leads further off.
    Vec2 furthest(Vec2 place, const Outlook& from, const SmoothBase& under) const {
        const auto offset = [&](const Vec2& at) {
            const auto s = grid_.evaluate(at, 0);
            if (!s) return 0.0;
            const Height h = from.height(s->position(), 1);
            return h.x * h.x + h.y * h.y < reach_ * reach_ ? h.z - under.height(h.x, h.y) : 0.0;
        };
        const auto s = grid_.evaluate(place, 1);
        if (!s) return place;
        double best = offset(place);
        const double side = best < 0 ? -1 : 1;
        best *= side;
        const double spacing = limit_.window * sample_share;
        Vec2 step(spacing / s->du().length(), spacing / s->dv().length());
        constexpr int halvings = 8;
        for (int halved = 0; halved < halvings;) {
            bool moved = false;
            for (const Vec2& way :
                 {Vec2(step.x, 0), Vec2(-step.x, 0), Vec2(0, step.y), Vec2(0, -step.y)}) {
                const double there = offset(place + way) * side;
                if (there > best) best = there, place += way, moved = true;
            }
            if (!moved) step *= 0.5, ++halved;
        }
        return place;
    }

    WavinessLimit limit_;
    double reach_; ///< mm, of what is looked at around a place
    FaceGrid grid_;
    std::vector<Candidate> candidates_;
};

} // namespace

std::vector<Flaw> find_flaws(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                             const WavinessLimit& limit) {
    return FlawSearch(model, instance, face, limit).run();
}

} // namespace keiko
