#include "keiko/inspect/seams/class_stretches.h"

#include "keiko/geometry/model/closest_point.h"
#include "keiko/inspect/seams/run_out.h"
#include "keiko/inspect/seams/seam_chain.h"
#include "keiko/math/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace keiko {
namespace {

double length_of(std::span<const SeamPart> parts, const std::vector<std::size_t>& group) {
    double length = 0;
    for (const std::size_t i : group) length += parts[i].length;
    return length;
}

std::array<SeamEnd, 2> ends_of(const SeamProbe& probe, const SeamPart& part) {
    return {end_of(probe, part, false), end_of(probe, part, true)};
}

class StretchMaker {
public:
    StretchMaker(std::span<const SeamProbe> probes, const StretchLimits& limits,
                 const PiecesBeyond& beyond)
        : probes_(probes), limits_(limits), beyond_(beyond) {
        for (std::uint32_t i = 0; i < probes.size(); ++i)
            for (SeamPart& part : partition_seam(probes[i], i, limits))
                parts_.push_back(std::move(part));
    }

    std::vector<SeamStretch> run() {
        add_run_outs();
        std::vector<SeamStretch> stretches;
        for (const std::vector<std::size_t>& group : groups())
            stretches.push_back(stretch_of(group));
        return stretches;
    }

private:
    std::vector<std::vector<std::size_t>> groups() const;
    void add_run_outs();
    void add_run_out(std::size_t crease, bool forward, double longest);
    double length_beyond(std::size_t crease) const;
    SeamStretch stretch_of(const std::vector<std::size_t>& group) const;

    std::span<const SeamProbe> probes_;
    const StretchLimits& limits_;
    const PiecesBeyond& beyond_;
    std::vector<SeamPart> parts_;
    /// Fading of creases that fade out, by piece and parameter of the crease's begin.
    std::map<std::pair<std::uint32_t, double>, MeasuredValue> fading_;
};

/// Groups of connected parts of one class: their indices, by their first.
std::vector<std::vector<std::size_t>> StretchMaker::groups() const {
    const double reach = std::max(limits_.join, limits_.negligible);
    std::vector<std::array<SeamEnd, 2>> ends;
    for (const SeamPart& part : parts_) ends.push_back(ends_of(probes_[part.piece], part));
    DisjointSets sets(parts_.size());
    for (std::size_t i = 0; i < parts_.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (parts_[i].kind == parts_[j].kind && touch(ends[i], ends[j], reach)) sets.join(i, j);
    std::map<std::size_t, std::vector<std::size_t>> by_root;
    for (std::size_t i = 0; i < parts_.size(); ++i) by_root[sets.root(i)].push_back(i);
    std::vector<std::vector<std::size_t>> result;
    result.reserve(by_root.size());
    for (auto& [root, group] : by_root) result.push_back(std::move(group));
    return result;
}

void StretchMaker::add_run_outs() {
    struct Crease {
        std::uint32_t piece;
        double t, length;
    };
    std::vector<Crease> creases;
    for (const std::vector<std::size_t>& group : groups()) {
        const double length = length_of(parts_, group);
        if (parts_[group.front()].kind != SeamClass::crease || length < limits_.negligible)
            continue;
        for (const std::size_t i : group)
            creases.push_back({parts_[i].piece, parts_[i].begin.t, length});
    }
    for (const Crease& crease : creases)
        for (const bool forward : {false, true}) {
            const auto at = std::find_if(parts_.begin(), parts_.end(), [&](const SeamPart& part) {
                return part.piece == crease.piece && part.begin.t == crease.t;
            });
            add_run_out(static_cast<std::size_t>(at - parts_.begin()), forward, crease.length);
        }
}

void StretchMaker::add_run_out(std::size_t crease, bool forward, double longest) {
    const std::optional<RunOut> found = follow_run_out(probes_, parts_, crease, forward, limits_);
    // A seam that is mostly run-out is no feature line but a fault that its peak would excuse.
    if (!found) return;
    if (found->length() > longest && found->length() > longest + length_beyond(crease)) return;
    const auto [fading, is_first] =
        fading_.try_emplace({parts_[crease].piece, parts_[crease].begin.t}, found->step);
    if (!is_first) fading->second = worse_of(fading->second, found->step);
    for (const RunOut::Piece& piece : found->pieces) {
        parts_[piece.part] = piece.taken;
        if (piece.left) parts_.push_back(*piece.left);
    }
    std::sort(parts_.begin(), parts_.end(), [](const SeamPart& a, const SeamPart& b) {
        return std::pair(a.piece, a.begin.t) < std::pair(b.piece, b.begin.t);
    });
}

/// mm of creases on pieces of other lines that continue a crease of this one.
double StretchMaker::length_beyond(std::size_t crease) const {
    if (!beyond_) return 0;
    const double reach = std::max(limits_.join, limits_.negligible);
    std::vector<std::array<SeamEnd, 2>> reached;
    for (const std::vector<std::size_t>& group : groups())
        if (std::find(group.begin(), group.end(), crease) != group.end())
            for (const std::size_t i : group)
                reached.push_back(ends_of(probes_[parts_[i].piece], parts_[i]));
    struct Beyond {
        std::array<SeamEnd, 2> ends;
        double length = 0;
    };
    std::vector<Beyond> left;
    for (const SeamProbe& probe : beyond_())
        for (const SeamPart& part : partition_seam(probe, 0, limits_))
            if (part.kind == SeamClass::crease) left.push_back({ends_of(probe, part), part.length});
    double length = 0;
    for (std::size_t i = 0; i < reached.size(); ++i)
        std::erase_if(left, [&, from = reached[i]](const Beyond& part) {
            if (!touch(from, part.ends, reach)) return false;
            length += part.length;
            reached.push_back(part.ends);
            return true;
        });
    return length;
}

SeamStretch StretchMaker::stretch_of(const std::vector<std::size_t>& group) const {
    SeamStretch stretch;
    stretch.kind = parts_[group.front()].kind;
    for (const std::size_t i : group) {
        stretch.parts.push_back(parts_[i]);
        const auto fading = fading_.find({parts_[i].piece, parts_[i].begin.t});
        if (stretch.kind != SeamClass::crease || fading == fading_.end()) continue;
        const MeasuredValue& step = fading->second;
        stretch.fading = stretch.fading ? worse_of(*stretch.fading, step) : step;
    }
    stretch.length = length_of(parts_, group);
    double unknown = 0;
    for (const SeamPart& part : stretch.parts) unknown += part.unknown;
    stretch.unknown = unknown > limits_.negligible;
    stretch.scrap = stretch.length < limits_.negligible;
    return stretch;
}

/// mm from a place to side a of a seam, by 64 chords.
double distance_to(const SeamProbe& probe, const Vec3& place) {
    constexpr int steps = 64;
    double least = HUGE_VAL;
    Vec3 before = probe.place(probe.begin());
    for (int i = 1; i <= steps; ++i) {
        const double t = probe.begin() + (probe.end() - probe.begin()) * i / steps;
        const Vec3 after = probe.place(t);
        least = std::min(least, segment_distance(before, after, place));
        before = after;
    }
    return least;
}

} // namespace

std::vector<SeamStretch> seam_stretches(std::span<const SeamProbe> probes,
                                        const StretchLimits& limits, const PiecesBeyond& beyond) {
    return StretchMaker(probes, limits, beyond).run();
}

RunOutPlaces::RunOutPlaces(std::span<const SeamProbe> pieces, const StretchLimits& limits,
                           const PiecesBeyond& beyond) {
    for (const SeamStretch& stretch : seam_stretches(pieces, limits, beyond)) {
        if (stretch.kind != SeamClass::run_out) continue;
        for (const SeamPart& part : stretch.parts)
            run_outs_.push_back(pieces[part.piece].part(part.begin, part.end));
    }
}

bool RunOutPlaces::hold(const Vec3& place, double reach) const {
    return std::any_of(run_outs_.begin(), run_outs_.end(),
                       [&](const SeamProbe& probe) { return distance_to(probe, place) <= reach; });
}

} // namespace keiko
