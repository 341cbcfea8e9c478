#include "keiko/inspect/flaws/dent_form.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko {
namespace {

std::vector<SmoothBase> fits(std::span<const Height> heights, double half_window, BaseKind kind) {
    std::vector<SmoothBase> found;
    for (const double share : dent_reaches)
        if (const auto base = SmoothBase::fit(heights, share * half_window, kind))
            found.push_back(*base);
    return found;
}

/// Of a fit among those of its kind by ascending reach, of which one is narrower, and of the
/// others.
double bound_of(std::span<const SmoothBase> kind, std::size_t index,
                std::span<const SmoothBase> other_kind) {
    const double here = kind[index].at_origin();
    double change = std::abs(here - kind[index - 1].at_origin());
    const auto consider = [&](const SmoothBase& base) {
        change = std::max(change, std::abs(here - base.at_origin()) - base.origin_bound());
    };
    for (const SmoothBase& wider : kind.subspan(index + 1)) consider(wider);
    for (const SmoothBase& other : other_kind)
        if (other.reach() >= kind[index].reach()) consider(other);
    return change + kind[index].origin_bound();
}

} // namespace

std::optional<DentForm> dent_form(std::span<const Height> heights, double half_window) {
    const std::vector<SmoothBase> flat = fits(heights, half_window, BaseKind::flat);
    const std::vector<SmoothBase> bent = fits(heights, half_window, BaseKind::bent);
    std::optional<DentForm> best;
    const auto consider = [&](const std::vector<SmoothBase>& kind,
                              const std::vector<SmoothBase>& other) {
        for (std::size_t i = 1; i < kind.size(); ++i) {
            const double bound = bound_of(kind, i, other);
            if (!best || bound < best->bound) best = DentForm{kind[i], bound};
        }
    };
    consider(flat, bent), consider(bent, flat);
    return best;
}

} // namespace keiko
