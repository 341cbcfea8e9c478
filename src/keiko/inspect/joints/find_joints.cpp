#include "keiko/inspect/joints/find_joints.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/seam/seam_candidate.h"
#include "keiko/inspect/joints/joint_chain.h"
#include "keiko/inspect/joints/joint_extremes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// mm within which borders of one skin continue each other.
constexpr double border_join = 0.5;

class JointFinder {
public:
    JointFinder(const PanelBorders& borders, const JointLimits& limits)
        : borders_(borders), limits_(limits), runs_(borders, limits) {}

    std::vector<JointRun> runs(const Job& job) const;
    /// The joint of a chain; nullopt if it is only a corner, or wider than it is long.
    std::optional<Joint> joint(JointChain chain) const;

private:
    std::string name(const PlacedFace& face) const {
        return placed_face_name(borders_.model(), face.instance, face.face);
    }
    bool is_corner(const JointSection& section) const {
        const double turn = section.sides[0].curvature + section.sides[1].curvature;
        return std::abs(turn) * limits_.corner_radius > 1;
    }
    void trim_corner(JointChain& chain) const;
    void measure_length(Joint& joint) const;
    bool is_long(const Joint& joint) const;

    const PanelBorders& borders_;
    const JointLimits& limits_;
    JointRuns runs_;
};

std::vector<JointRun> JointFinder::runs(const Job& job) const {
    std::vector<std::vector<JointRun>> found(borders_.all().size());
    parallel_for(found.size(), job, "joints",
                 [&](std::size_t i) { found[i] = runs_.of(static_cast<std::uint32_t>(i)); });
    std::vector<JointRun> all;
    for (auto& some : found) std::move(some.begin(), some.end(), std::back_inserter(all));
    return all;
}

/// Removes the corner in which a chain ends.
void JointFinder::trim_corner(JointChain& chain) const {
    const auto is_straight = [&](const JointSection& section) { return !is_corner(section); };
    std::vector<JointStation>& stations = chain.stations;
    std::optional<JointStation> removed;
    while (!stations.empty() && stations.back().section && is_corner(*stations.back().section))
        removed = stations.back(), stations.pop_back();
    if (stations.empty() || !removed) return;
    const JointStation& last = stations.back();
    if (!last.section || last.border != removed->border) return;
    const auto end = runs_.last_good(last.border, last.t, removed->t, chain.other, is_straight);
    if (end) stations.push_back(*end);
}

void JointFinder::measure_length(Joint& joint) const {
    std::vector<JointStation>& stations = joint.stations;
    for (std::size_t i = 1; i < stations.size(); ++i) {
        const JointStation &from = stations[i - 1], &to = stations[i];
        const bool same = from.border == to.border;
        const double way = same ? borders_.all()[to.border].curve.length(from.t, to.t)
                                : (to.place - from.place).length();
        stations[i].along = from.along + way;
        if (from.section && to.section) continue;
        if (joint.unmeasured == 0) joint.unmeasured_place = from.section ? to.place : from.place;
        joint.unmeasured += way;
    }
    joint.length = stations.back().along;
}

/// A touch of two corners is about as wide as it is long.
bool JointFinder::is_long(const Joint& joint) const {
    if (!joint.extremes) return joint.length > limits_.spacing;
    return joint.length > 0 && slender(joint.length, joint.extremes->narrowest.gap);
}

std::optional<Joint> JointFinder::joint(JointChain chain) const {
    for (int end = 0; end < 2 && !chain.closed; ++end) {
        trim_corner(chain);
        std::reverse(chain.stations.begin(), chain.stations.end());
    }
    if (chain.stations.empty()) return std::nullopt;
    Joint joint;
    joint.stations = std::move(chain.stations), joint.closed = chain.closed;
    measure_length(joint);
    joint.extremes = joint_extremes(runs_, joint.stations, chain.other);
    if (!is_long(joint)) return std::nullopt;
    std::vector<const JointSection*> sections;
    for (const JointStation& station : joint.stations)
        if (station.section) sections.push_back(&*station.section);
    joint.faces[0] = borders_.all()[joint.stations.front().border].face();
    joint.faces[1] = joint.faces[0];
    if (!sections.empty())
        for (std::size_t side = 0; side < 2; ++side)
            joint.faces[side] = sections[sections.size() / 2]->sides[side].face;
    joint.names = name(joint.faces[0]) + " | " + name(joint.faces[1]);
    return joint;
}

/// True if the edges of the first joint are those of the second, taken from the far side, as where
/// the edges are hems.
bool is_same_edge(const Joint& joint, const Joint& other) {
    if (!joint.extremes || !other.extremes) return false;
    const JointSection& at = joint.extremes->narrowest;
    constexpr double same = 0.05; // mm, more than chords are off
    for (std::size_t i = 0; i + 1 < other.stations.size(); ++i) {
        const auto &from = other.stations[i].section, &to = other.stations[i + 1].section;
        if (!from || !to || at.outward.dot(from->outward) > 0) continue;
        if (segment_distance(from->sides[0].foremost, to->sides[0].foremost,
                             at.sides[0].foremost) <= same)
            return true;
    }
    return false;
}

/// Leaves out joints of hems taken from inside: their faces are the smaller ones.
std::vector<Joint> from_outside(std::vector<Joint> joints, const PanelBorders& borders) {
    const auto size = [&](const Joint& joint) {
        return borders.size(joint.faces[0]) + borders.size(joint.faces[1]);
    };
    std::vector<Joint> kept;
    for (const Joint& joint : joints) {
        const bool inside = std::any_of(joints.begin(), joints.end(), [&](const Joint& other) {
            return size(other) > size(joint) && is_same_edge(joint, other);
        });
        if (!inside) kept.push_back(joint);
    }
    return kept;
}

} // namespace

std::vector<Joint> find_joints(const ModelBorders& borders, std::span<const Seam> seams,
                               const JointLimits& limits, const Job& job) {
    const PanelBorders panels(borders, seams, job);
    if (panels.body_count() < 2) return {};
    const JointFinder finder(panels, limits);
    std::vector<JointChain> chains = chained(finder.runs(job), border_join);
    std::vector<std::optional<Joint>> found(chains.size());
    parallel_for(chains.size(), job, "",
                 [&](std::size_t i) { found[i] = finder.joint(std::move(chains[i])); });
    std::vector<Joint> joints;
    for (auto& joint : found)
        if (joint) joints.push_back(std::move(*joint));
    return from_outside(std::move(joints), panels);
}

} // namespace keiko
