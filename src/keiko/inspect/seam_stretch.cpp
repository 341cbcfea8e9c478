#include "keiko/inspect/seam_stretch.h"

#include "keiko/inspect/run_out.h"
#include "keiko/math/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <map>

namespace keiko {
namespace {

bool touch(const SeamPart& a, const SeamPart& b, double reach) {
    for (const SeamPoint* x : {&a.begin, &a.end})
        for (const SeamPoint* y : {&b.begin, &b.end})
            if ((x->place - y->place).length() <= reach) return true;
    return false;
}

/// Indices of parts of one class that go on into each other, by their first.
std::vector<std::vector<std::size_t>> groups_of(std::span<const SeamPart> parts,
                                                const StretchLimits& limits) {
    const double reach = std::max(limits.join, limits.negligible);
    DisjointSets sets(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (parts[i].kind == parts[j].kind && touch(parts[i], parts[j], reach)) sets.join(i, j);
    std::map<std::size_t, std::vector<std::size_t>> by_root;
    for (std::size_t i = 0; i < parts.size(); ++i) by_root[sets.root(i)].push_back(i);
    std::vector<std::vector<std::size_t>> groups;
    for (auto& [root, group] : by_root) groups.push_back(std::move(group));
    return groups;
}

double length_of(std::span<const SeamPart> parts, const std::vector<std::size_t>& group) {
    double length = 0;
    for (const std::size_t i : group) length += parts[i].length;
    return length;
}

class StretchMaker {
public:
    StretchMaker(std::span<const SeamProbe> probes, const StretchLimits& limits)
        : probes_(probes), limits_(limits) {
        for (std::uint32_t i = 0; i < probes.size(); ++i)
            for (SeamPart& part :
                 partition_seam(probes[i], i, {limits.feature_angle, limits.negligible}))
                parts_.push_back(std::move(part));
    }

    std::vector<SeamStretch> run() {
        add_run_outs();
        std::vector<SeamStretch> stretches;
        for (const std::vector<std::size_t>& group : groups_of(parts_, limits_))
            stretches.push_back(stretch_of(group));
        return stretches;
    }

private:
    void add_run_outs();
    void add_run_out(std::size_t crease, bool forward);
    SeamStretch stretch_of(const std::vector<std::size_t>& group) const;

    std::span<const SeamProbe> probes_;
    const StretchLimits& limits_;
    std::vector<SeamPart> parts_;
    /// Of creases that fade, by piece and parameter of the crease's begin.
    std::map<std::pair<std::uint32_t, double>, Worst> fading_;
};

void StretchMaker::add_run_outs() {
    std::vector<std::pair<std::uint32_t, double>> creases;
    for (const std::vector<std::size_t>& group : groups_of(parts_, limits_))
        if (parts_[group.front()].kind == SeamClass::crease &&
            length_of(parts_, group) >= limits_.negligible)
            for (const std::size_t i : group)
                creases.emplace_back(parts_[i].piece, parts_[i].begin.t);
    for (const auto& [piece, t] : creases)
        for (const bool forward : {false, true}) {
            const auto at = std::find_if(parts_.begin(), parts_.end(), [&](const SeamPart& part) {
                return part.piece == piece && part.begin.t == t;
            });
            add_run_out(static_cast<std::size_t>(at - parts_.begin()), forward);
        }
}

void StretchMaker::add_run_out(std::size_t crease, bool forward) {
    const std::optional<RunOut> found = follow_run_out(probes_, parts_, crease, forward, limits_);
    if (!found) return;
    Worst& fading = fading_[{parts_[crease].piece, parts_[crease].begin.t}];
    if (found->step.value + found->step.bound > fading.value + fading.bound) fading = found->step;
    for (const RunOut::Piece& piece : found->pieces) {
        parts_[piece.part] = piece.taken;
        if (piece.left) parts_.push_back(*piece.left);
    }
    std::sort(parts_.begin(), parts_.end(), [](const SeamPart& a, const SeamPart& b) {
        return std::pair(a.piece, a.begin.t) < std::pair(b.piece, b.begin.t);
    });
}

SeamStretch StretchMaker::stretch_of(const std::vector<std::size_t>& group) const {
    SeamStretch stretch;
    stretch.kind = parts_[group.front()].kind;
    for (const std::size_t i : group) {
        stretch.parts.push_back(parts_[i]);
        const auto fading = fading_.find({parts_[i].piece, parts_[i].begin.t});
        if (stretch.kind != SeamClass::crease || fading == fading_.end()) continue;
        const Worst& step = fading->second;
        if (!stretch.fading || step.value > stretch.fading->value) stretch.fading = step;
    }
    stretch.length = length_of(parts_, group);
    stretch.scrap = stretch.length < limits_.negligible;
    return stretch;
}

} // namespace

std::vector<SeamStretch> seam_stretches(std::span<const SeamProbe> probes,
                                        const StretchLimits& limits) {
    return StretchMaker(probes, limits).run();
}

} // namespace keiko
