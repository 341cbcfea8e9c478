#include "keiko/inspect/lines/line_pairs.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace keiko {
namespace {

/// mm: ends this near each other on the part need no jump to explain it. Rounding of files causes
/// such distances, and so do ends that run nearly along the border.
constexpr double same_place = 1e-5;
/// Relative difference allowed between the jumps of both sides, as the field may change along the
/// border.
constexpr double alike = 0.5;
/// Factor by which the field's slope along the border may change between the ends. It predicts the
/// distance of the sides' ends and is evaluated at either end.
constexpr double prediction_slack = 4;

double distance(const LineEndpoint& a, const LineEndpoint& b) {
    return (a.place - b.place).length();
}

/// True if the field's jump between the sides explains the distance of the ends.
bool explained(const LineEndpoint& tail, const LineEndpoint& head) {
    const double jump = std::max(std::abs(tail.jump), std::abs(head.jump));
    const double least_slope = std::min(std::abs(tail.slope()), std::abs(head.slope()));
    const double reach = std::max(tail.gap, head.gap) + prediction_slack * jump / least_slope;
    if (!(distance(tail, head) <= reach + same_place)) return false;
    // A shift by same_place changes the field by that length times its gradient.
    const double noise = same_place * std::max(tail.course.density, head.course.density);
    return std::abs(tail.jump + head.jump) <= alike * jump + noise;
}

using Candidate = std::tuple<double, std::uint32_t, std::uint32_t>;

class Pairing {
public:
    Pairing(std::span<const LineEndpoint> meetings, double crease)
        : meetings_(meetings), crease_(crease) {}

    std::vector<LinePair> run() {
        join(candidates([](const LineEndpoint& m) { return m.border; }, false));
        join(candidates([](const LineEndpoint&) { return LineBorder{}; }, true));
        return std::move(pairs_);
    }

private:
    bool crossable(const LineEndpoint& meeting) const {
        return std::isfinite(meeting.jump) && meeting.angle <= crease_ &&
               !done_.count({meeting.piece, meeting.head});
    }

    /// Groups meetings by border and lamp, and lists matching pairs in each group.
    template <class BorderOf>
    std::vector<Candidate> candidates(const BorderOf& border_of, bool any_seam) const {
        std::map<std::tuple<LineBorder, std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>>
            groups;
        for (std::uint32_t i = 0; i < meetings_.size(); ++i) {
            const LineEndpoint& m = meetings_[i];
            const bool asked = !any_seam || m.border.seam != no_index;
            if (asked && crossable(m)) groups[{border_of(m), m.plane, m.lamp}].push_back(i);
        }
        std::vector<Candidate> found;
        for (const auto& [key, members] : groups)
            for (const std::uint32_t tail : members)
                for (const std::uint32_t head : members)
                    if (!meetings_[tail].head && meetings_[head].head &&
                        (any_seam || meetings_[tail].second != meetings_[head].second) &&
                        explained(meetings_[tail], meetings_[head]))
                        found.emplace_back(distance(meetings_[tail], meetings_[head]), tail, head);
        return found;
    }

    void join(std::vector<Candidate> found) {
        std::sort(found.begin(), found.end());
        for (const auto& [apart, tail, head] : found) {
            const LineEndpoint &t = meetings_[tail], &h = meetings_[head];
            if (done_.count({t.piece, false}) || done_.count({h.piece, true})) continue;
            done_.insert({t.piece, false});
            done_.insert({h.piece, true});
            pairs_.push_back({tail, head});
        }
    }

    std::span<const LineEndpoint> meetings_;
    double crease_;
    std::set<std::pair<std::uint32_t, bool>> done_; ///< ends by piece; true: its head
    std::vector<LinePair> pairs_;
};

} // namespace

std::vector<LinePair> pair_meetings(std::span<const LineEndpoint> meetings, double crease) {
    return Pairing(meetings, crease).run();
}

} // namespace keiko
