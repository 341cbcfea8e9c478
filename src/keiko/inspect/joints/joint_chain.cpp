#include "keiko/inspect/joints/joint_chain.h"

#include "keiko/geometry/seam/seam_candidate.h"

#include <algorithm>
#include <optional>

namespace keiko {
namespace {

/// Both ends of each run: 2 r is the first of run r, 2 r + 1 its last.
class RunEnds {
public:
    RunEnds(const std::vector<JointRun>& runs, double join) : runs_(runs), next_(2 * runs.size()) {
        struct Pair {
            double distance;
            std::size_t i, j;
        };
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < next_.size(); ++i)
            for (std::size_t j = i + 1; j < next_.size(); ++j)
                if (const double d = distance(i, j); d <= join && may_join(i, j, d))
                    pairs.push_back({d, i, j});
        std::stable_sort(pairs.begin(), pairs.end(),
                         [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
        for (const Pair& pair : pairs)
            if (!next_[pair.i] && !next_[pair.j]) next_[pair.i] = pair.j, next_[pair.j] = pair.i;
    }

    std::optional<std::size_t> next(std::size_t end) const { return next_[end]; }

private:
    const JointRun& run(std::size_t end) const { return runs_[end / 2]; }
    const JointStation& station(std::size_t end) const {
        return end % 2 == 0 ? run(end).stations.front() : run(end).stations.back();
    }
    double distance(std::size_t i, std::size_t j) const {
        return (station(i).place - station(j).place).length();
    }
    bool may_join(std::size_t i, std::size_t j, double d) const {
        if (run(i).body != run(j).body || run(i).other != run(j).other) return false;
        if (i / 2 == j / 2 && !is_loop(run(i), d)) return false;
        const auto &a = station(i).section, &b = station(j).section;
        if (!a || !b) return true;
        const Vec3 turned = b->along * (a->along.dot(b->along) < 0 ? -1.0 : 1.0);
        return !is_corner(a->along, turned) && a->outward.dot(b->outward) > 0;
    }
    /// True if a run leads away from its beginning and back.
    static bool is_loop(const JointRun& run, double ends_apart) {
        const Vec3& from = run.stations.front().place;
        return std::any_of(run.stations.begin(), run.stations.end(), [&](const JointStation& s) {
            return (s.place - from).length() > 4 * ends_apart;
        });
    }

    const std::vector<JointRun>& runs_;
    std::vector<std::optional<std::size_t>> next_;
};

/// The chain that begins at an end of a run.
JointChain chain_from(std::size_t end, std::vector<JointRun>& runs, const RunEnds& ends,
                      std::vector<bool>& used) {
    JointChain chain{runs[end / 2].body, runs[end / 2].other, {}, false};
    const std::size_t first = end;
    for (std::optional<std::size_t> at = end; at && !used[*at / 2];) {
        used[*at / 2] = true;
        auto& stations = runs[*at / 2].stations;
        if (*at % 2 == 1) std::reverse(stations.begin(), stations.end());
        chain.stations.insert(chain.stations.end(), stations.begin(), stations.end());
        at = ends.next(*at ^ 1);
        chain.closed = at == first;
    }
    return chain;
}

} // namespace

std::vector<JointChain> chained(std::vector<JointRun> runs, double join) {
    const RunEnds ends(runs, join);
    std::vector<bool> used(runs.size());
    std::vector<JointChain> chains;
    const auto add_from = [&](bool loops) {
        for (std::size_t end = 0; end < 2 * runs.size(); ++end)
            if (!used[end / 2] && (loops || !ends.next(end)))
                chains.push_back(chain_from(end, runs, ends, used));
    };
    add_from(false), add_from(true);
    return chains;
}

} // namespace keiko
