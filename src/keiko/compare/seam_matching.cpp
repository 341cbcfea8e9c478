#include "keiko/compare/compare_inspections.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/model/surface_model.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace keiko {
namespace {

/// How a seam runs along another.
struct Along {
    double share = 0; ///< of its course, by points, within reach of the other
    double apart = 0; ///< mm, mean distance there
};

/// The courses of many seams, found by nearness.
class Courses {
public:
    explicit Courses(std::span<const MeasuredSeam> seams) {
        for (std::uint32_t i = 0; i < seams.size(); ++i)
            for (const std::vector<Vec3>& piece : seams[i].course)
                for (std::size_t k = 0; k + 1 < piece.size(); ++k)
                    chords_.push_back({i, piece[k], piece[k + 1]});
        std::vector<Box3> boxes;
        for (const Chord& chord : chords_) {
            Box3 box;
            box.extend(chord.from), box.extend(chord.to);
            boxes.push_back(box);
        }
        tree_.emplace(std::move(boxes));
    }

    /// Every seam that a course runs along somewhere within `reach`.
    std::map<std::uint32_t, Along> beside(const MeasuredSeam& seam, double reach) const {
        std::map<std::uint32_t, Along> sums;
        std::size_t points = 0;
        for (const std::vector<Vec3>& piece : seam.course)
            for (const Vec3& p : piece) {
                ++points;
                for (const auto& [other, distance] : near(p, reach)) {
                    sums[other].share += 1;
                    sums[other].apart += distance;
                }
            }
        for (auto& [other, along] : sums) {
            along.apart /= along.share;
            along.share /= static_cast<double>(points);
        }
        return sums;
    }

private:
    struct Chord {
        std::uint32_t seam;
        Vec3 from, to;
    };

    std::map<std::uint32_t, double> near(const Vec3& p, double reach) const {
        std::map<std::uint32_t, double> nearest;
        for (const std::uint32_t i : tree_->overlapping(Box3{p, p}.padded(reach))) {
            const double distance = segment_distance(chords_[i].from, chords_[i].to, p);
            if (distance > reach) continue;
            const auto [at, added] = nearest.emplace(chords_[i].seam, distance);
            at->second = std::min(at->second, distance);
        }
        return nearest;
    }

    std::vector<Chord> chords_;
    std::optional<BoxTree> tree_;
};

/// Two seams that might be the same.
struct Candidate {
    int rank = 0; ///< 0: on each other, 1: of the same faces, 2: near
    double apart = 0;
    std::uint32_t before = 0, after = 0;
    bool operator<(const Candidate& other) const {
        return std::tie(rank, apart, before, after) <
               std::tie(other.rank, other.apart, other.before, other.after);
    }
};

class Matcher {
public:
    Matcher(std::span<const MeasuredSeam> before, std::span<const MeasuredSeam> after, double reach)
        : before_(before),
          after_(after),
          reach_(reach),
          of_before_(before.size(), no_index),
          of_after_(after.size(), no_index) {
        const Courses old(before), fresh(after);
        for (const MeasuredSeam& seam : before) beside_before_.push_back(fresh.beside(seam, reach));
        for (const MeasuredSeam& seam : after) beside_after_.push_back(old.beside(seam, reach));
    }

    SeamMatching run() {
        pair();
        for (std::uint32_t i = 0; i < before_.size(); ++i)
            if (of_before_[i] == no_index && !is_sliver(before_[i]))
                of_before_[i] = joined(beside_before_[i], of_after_);
        for (std::uint32_t j = 0; j < after_.size(); ++j)
            if (of_after_[j] == no_index && !is_sliver(after_[j]))
                of_after_[j] = joined(beside_after_[j], of_before_);
        return result();
    }

private:
    static constexpr double mostly = 0.5;

    /// Seams on each other share at least half of their course, both of them.
    std::vector<Candidate> candidates() const {
        std::vector<Candidate> all;
        for (std::uint32_t i = 0; i < before_.size(); ++i)
            for (const auto& [j, along] : beside_before_[i]) {
                if (is_sliver(before_[i]) || is_sliver(after_[j])) continue;
                const auto back = beside_after_[j].find(i);
                if (back == beside_after_[j].end()) continue;
                if (along.share < mostly || back->second.share < mostly) continue;
                const double apart = std::max(along.apart, back->second.apart);
                const bool whole = along.share > 0.9 && back->second.share > 0.9;
                const bool same_names = before_[i].faces == after_[j].faces;
                const int rank = whole && apart <= reach_ / 100 ? 0 : same_names ? 1 : 2;
                all.push_back({rank, apart, i, j});
            }
        std::sort(all.begin(), all.end());
        return all;
    }

    void pair() {
        for (const Candidate& candidate : candidates()) {
            std::uint32_t &i = of_before_[candidate.before], &j = of_after_[candidate.after];
            if (i != no_index || j != no_index) continue;
            i = j = groups_++;
        }
    }

    /// The group of the seam on the other side that one runs along, and lies on.
    std::uint32_t joined(const std::map<std::uint32_t, Along>& beside,
                         const std::vector<std::uint32_t>& groups) const {
        std::uint32_t best = no_index;
        double apart = reach_ / 100;
        for (const auto& [other, along] : beside)
            if (along.share > mostly && along.apart <= apart && groups[other] != no_index)
                best = groups[other], apart = along.apart;
        return best;
    }

    SeamMatching result() const {
        SeamMatching matching;
        matching.groups.resize(groups_);
        for (std::uint32_t i = 0; i < before_.size(); ++i)
            if (of_before_[i] != no_index)
                matching.groups[of_before_[i]].before.push_back(i);
            else if (!is_sliver(before_[i]))
                matching.removed.push_back(i);
        for (std::uint32_t j = 0; j < after_.size(); ++j)
            if (of_after_[j] != no_index)
                matching.groups[of_after_[j]].after.push_back(j);
            else if (!is_sliver(after_[j]))
                matching.added.push_back(j);
        std::sort(matching.groups.begin(), matching.groups.end(),
                  [](const SeamGroup& a, const SeamGroup& b) { return a.before < b.before; });
        return matching;
    }

    std::span<const MeasuredSeam> before_, after_;
    double reach_;
    std::vector<std::map<std::uint32_t, Along>> beside_before_, beside_after_;
    std::vector<std::uint32_t> of_before_, of_after_; ///< a seam: its group, or no_index
    std::uint32_t groups_ = 0;
};

} // namespace

SeamMatching match_seams(std::span<const MeasuredSeam> before, std::span<const MeasuredSeam> after,
                         double reach) {
    return Matcher(before, after, reach).run();
}

} // namespace keiko
