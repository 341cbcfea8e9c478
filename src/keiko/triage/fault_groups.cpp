#include "keiko/triage/fault_groups.h"

#include "keiko/base/parallel.h"
#include "keiko/math/disjoint_sets.h"
#include "keiko/triage/bad_patches.h"
#include "keiko/triage/continuations.h"
#include "keiko/triage/mirror_images.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace keiko {
namespace {

/// Different means make different faults.
enum class Means { close_gap, rebuild_line, change_design };

Means means_of(const FaultUnit& unit) {
    if (unit.mending == Mending::position) return Means::close_gap;
    return unit.is_fine() ? Means::change_design : Means::rebuild_line;
}

bool are_mended_alike(const FaultUnit& a, const FaultUnit& b) {
    return means_of(a) == means_of(b);
}

/// mm: distance between the places of two faults, with the extent of either, up to which an eye
/// sees them in one glance. It is 1 degree, half of the sharp part of its field, from 3.4 m, but at
/// most a tenth of the body.
double glance_of(const Box3& body) {
    constexpr double most = 60, share = 0.1;
    return std::min(most, share * body.size());
}

class Grouping {
public:
    Grouping(const Inspection& inspection, const std::vector<FaultUnit>& units, const Box3& body)
        : inspection_(inspection),
          units_(units),
          mirror_{1, (body.lower.y + body.upper.y) / 2},
          glance_(glance_of(body)),
          has_image_(units.size()) {}

    std::vector<FaultGroup> groups() {
        std::vector<FaultGroup> groups = joined();
        sort(groups);
        groups = merged_by_patch(merged_by_glance(groups));
        sort(groups);
        return groups;
    }

private:
    const MeasuredSeam& seam(std::size_t unit) const {
        return inspection_.seams[units_[unit].seam];
    }
    std::vector<FaultGroup> joined();
    void join_lines(DisjointSets& sets) const;
    void join_fine(DisjointSets& sets) const;
    void join_images(DisjointSets& sets);
    FaultGroup group_of(std::vector<std::size_t> members) const;
    void sort(std::vector<FaultGroup>& groups) const;
    bool may_belong_to_patch(const FaultGroup& group) const;
    std::vector<FaultGroup> merged_by_patch(const std::vector<FaultGroup>& groups) const;
    std::vector<FaultGroup> merged_by_glance(const std::vector<FaultGroup>& groups) const;
    bool may_merge(const FaultGroup& group, const FaultGroup& worse) const;
    bool is_in_glance(const FaultGroup& group, const FaultGroup& worse) const;

    const Inspection& inspection_;
    const std::vector<FaultUnit>& units_;
    MirrorPlane mirror_;          ///< the middle plane of the body across y
    double glance_;               ///< mm
    std::vector<bool> has_image_; ///< of each unit
};

/// Stretches of one line, and those that go on where another ends.
void Grouping::join_lines(DisjointSets& sets) const {
    std::vector<std::size_t> of_seams;
    std::vector<const MeasuredSeam*> stretches;
    std::map<std::pair<std::uint32_t, Means>, std::size_t> first_of_line;
    for (std::size_t i = 0; i < units_.size(); ++i) {
        if (units_[i].seam == no_index) continue;
        of_seams.push_back(i);
        stretches.push_back(&seam(i));
        const std::pair line(seam(i).line, means_of(units_[i]));
        const auto [first, is_new] = first_of_line.try_emplace(line, i);
        if (!is_new) sets.join(i, first->second);
    }
    const LineReach reach{inspection_.join, glance_ / 4};
    for (const auto& [a, b] : continuations(stretches, reach))
        if (are_mended_alike(units_[of_seams[a]], units_[of_seams[b]]))
            sets.join(of_seams[a], of_seams[b]);
}

/// Jumps that are too fine for an eye are one fault, wherever they lie: they are of the design.
void Grouping::join_fine(DisjointSets& sets) const {
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < units_.size(); ++i) {
        if (!units_[i].is_fine()) continue;
        if (first) sets.join(i, *first);
        first = i;
    }
}

void Grouping::join_images(DisjointSets& sets) {
    for (std::size_t j = 1; j < units_.size(); ++j) {
        check_stop();
        for (std::size_t i = 0; i < j; ++i) {
            if (!are_mended_alike(units_[i], units_[j]) ||
                !are_mirror_images(inspection_, units_[i], units_[j], mirror_))
                continue;
            has_image_[i] = has_image_[j] = true;
            sets.join(i, j);
        }
    }
}

/// Groups of stretches that are one line, too fine for an eye, or images of each other.
std::vector<FaultGroup> Grouping::joined() {
    DisjointSets sets(units_.size());
    join_lines(sets);
    join_fine(sets);
    join_images(sets);
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < units_.size(); ++i) members[sets.root(i)].push_back(i);
    std::vector<FaultGroup> groups;
    for (auto& [root, of_group] : members) groups.push_back(group_of(std::move(of_group)));
    return groups;
}

FaultGroup Grouping::group_of(std::vector<std::size_t> members) const {
    std::stable_sort(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
        return units_[a].sight.is_worse_than(units_[b].sight);
    });
    FaultGroup group;
    for (const std::size_t i : members) {
        group.sight.add(units_[i].sight);
        if (has_image_[i]) group.mirrored = true;
    }
    group.units = std::move(members);
    return group;
}

/// True for a fault that is mended by a better surface: a gap needs another border, and what is too
/// fine another design.
bool Grouping::may_belong_to_patch(const FaultGroup& group) const {
    return !group.sight.is_hidden() &&
           std::all_of(group.units.begin(), group.units.end(),
                       [&](std::size_t i) { return means_of(units_[i]) == Means::rebuild_line; });
}

/// The faults of each bad patch as one.
std::vector<FaultGroup> Grouping::merged_by_patch(const std::vector<FaultGroup>& groups) const {
    std::vector<bool> may_belong;
    for (const FaultGroup& group : groups) may_belong.push_back(may_belong_to_patch(group));
    std::vector<bool> is_taken(groups.size());
    std::vector<FaultGroup> merged;
    for (const BadPatch& patch : bad_patches(inspection_, units_, groups, may_belong)) {
        std::vector<std::size_t> members;
        for (const std::size_t i : patch.groups) {
            is_taken[i] = true;
            members.insert(members.end(), groups[i].units.begin(), groups[i].units.end());
        }
        merged.push_back(group_of(std::move(members)));
        merged.back().patch = patch.face;
    }
    for (std::size_t i = 0; i < groups.size(); ++i)
        if (!is_taken[i]) merged.push_back(groups[i]);
    return merged;
}

/// The worst first; among equals the one with the earliest finding.
void Grouping::sort(std::vector<FaultGroup>& groups) const {
    const auto first_finding = [&](const FaultGroup& group) {
        std::size_t first = units_[group.units.front()].findings.front();
        for (const std::size_t i : group.units) first = std::min(first, units_[i].findings.front());
        return first;
    };
    std::stable_sort(groups.begin(), groups.end(), [&](const FaultGroup& a, const FaultGroup& b) {
        if (a.sight.is_worse_than(b.sight)) return true;
        return !b.sight.is_worse_than(a.sight) && first_finding(a) < first_finding(b);
    });
}

/// True for a group that may belong to a worse one. What is too fine for an eye stands by itself,
/// all over the body.
bool Grouping::may_merge(const FaultGroup& group, const FaultGroup& worse) const {
    const auto is_fine_group = [&](const FaultGroup& any) {
        return units_[any.units.front()].is_fine();
    };
    const bool is_local = worse.sight.spread <= glance_;
    if (!is_local && group.sight.tear > worse.sight.tear) return false;
    return group.sight.is_hidden() == worse.sight.is_hidden() && !is_fine_group(group) &&
           !is_fine_group(worse) && is_in_glance(group, worse);
}

/// True if each unit of a group is seen in one glance with a unit of a worse one. What is mended by
/// other means has to touch it too.
bool Grouping::is_in_glance(const FaultGroup& group, const FaultGroup& worse) const {
    const bool alike = are_mended_alike(units_[group.units.front()], units_[worse.units.front()]);
    const auto are_close = [&](std::size_t i, std::size_t j) {
        const Sight &a = units_[i].sight, &b = units_[j].sight;
        const double distance = (a.place - b.place).length();
        const double touching = (a.spread + b.spread) / spread_share;
        return distance + std::max(a.spread, b.spread) <= glance_ &&
               (alike || distance <= touching);
    };
    return std::all_of(group.units.begin(), group.units.end(), [&](std::size_t i) {
        return std::any_of(worse.units.begin(), worse.units.end(),
                           [&](std::size_t j) { return are_close(i, j); });
    });
}

/// Each group with those that belong to it. Groups are compared as they were joined, so that a row
/// of faults does not become one.
std::vector<FaultGroup> Grouping::merged_by_glance(const std::vector<FaultGroup>& groups) const {
    std::vector<bool> is_taken(groups.size());
    std::vector<FaultGroup> merged;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (is_taken[i]) continue;
        check_stop();
        std::vector<std::size_t> members = groups[i].units;
        for (std::size_t j = i + 1; j < groups.size(); ++j) {
            if (is_taken[j] || !may_merge(groups[j], groups[i])) continue;
            is_taken[j] = true;
            members.insert(members.end(), groups[j].units.begin(), groups[j].units.end());
        }
        merged.push_back(group_of(std::move(members)));
    }
    return merged;
}

} // namespace

std::vector<FaultGroup> fault_groups(const Inspection& inspection,
                                     const std::vector<FaultUnit>& units, const Box3& body) {
    return Grouping(inspection, units, body).groups();
}

} // namespace keiko
