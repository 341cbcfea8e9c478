#include "keiko/inspect/face_flaws.h"

#include "keiko/inspect/dent_depth.h"
#include "keiko/inspect/face_grid.h"
#include "keiko/inspect/ripple.h"
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
/// What is wider than this share of the window is form to it: what lies around is not seen.
constexpr double widest_share = 0.55;
/// A depth that changes by more than this share of it with how much around is looked at may be
/// form.
constexpr double form_share = 0.25;
/// Ripples are looked for down to this share of the limit: they tell of a depth only about.
constexpr double ripple_share = 1.0 / 8;
/// How many of the deepest ripples of a flaw are measured, and how many are tried: what is beside a
/// border cannot be.
constexpr std::size_t most_measured = 4, most_tried = 1000;

/// A ripple on the face.
struct Candidate {
    Vec2 place{0}; ///< in the grid
    Vec3 position{0};
    double width = 0, depth = 0;
    bool along_u = true; ///< the line that shows it
};

class FlawSearch {
public:
    FlawSearch(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
               const WavinessLimit& limit)
        : limit_(limit), grid_(model, instance, face, spacing()) {}

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
    double spacing() const { return limit_.window * sample_share; } ///< of the samples, mm

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
                if (r.width > widest_share * limit_.window) continue;
                const auto [column, row] = index_of(begin + r.index);
                candidates_.push_back({grid_.place(column, row), grid_.sample(column, row).position,
                                       r.width, r.depth, bend == &FaceSample::bend_u});
            }
            line.clear();
        }
    }

    std::array<int, 3> cell_of(const Vec3& position) const {
        const auto number = [this](double x) {
            return static_cast<int>(std::floor(4 * x / limit_.window));
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
        for (std::size_t i = 0; i < std::min(group.size(), most_tried); ++i) {
            const auto flaw = waves ? wave(group[i]) : dent(group[i]);
            if (!flaw) continue;
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
        const auto found = dent_depth(grid_, c.place, limit_.window / 2, spacing());
        if (!found) return std::nullopt;
        return flaw(found->offset < 0 ? Flaw::Kind::dent : Flaw::Kind::bump,
                    std::abs(found->offset), found->bound, found->position, c.width);
    }

    /// Whether a group has crests and troughs that are nearly as deep.
    static bool to_and_fro(const std::vector<Candidate>& group) {
        const double first = group.front().depth;
        return std::any_of(group.begin(), group.end(), [first](const Candidate& c) {
            return c.depth * first < 0 && std::abs(c.depth) > std::abs(first) / 2;
        });
    }

    WavinessLimit limit_;
    FaceGrid grid_;
    std::vector<Candidate> candidates_;
};

} // namespace

std::vector<Flaw> find_flaws(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                             const WavinessLimit& limit) {
    return FlawSearch(model, instance, face, limit).run();
}

} // namespace keiko
