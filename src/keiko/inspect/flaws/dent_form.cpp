#include "keiko/inspect/flaws/dent_form.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko {
namespace {

std::vector<ReferenceForm> fits(std::span<const FormHeight> heights, double half_window,
                                BaseKind kind) {
    std::vector<ReferenceForm> found;
    for (const double share : dent_reaches)
        if (const auto base = ReferenceForm::fit(heights, share * half_window, kind))
            found.push_back(*base);
    return found;
}

/// Error bound of a fit among those of its kind by ascending reach, from its narrower neighbour and
/// the fits of the other kind.
double bound_of(std::span<const ReferenceForm> kind, std::size_t index,
                std::span<const ReferenceForm> other_kind) {
    const double here = kind[index].at_origin();
    double change = std::abs(here - kind[index - 1].at_origin());
    const auto consider = [&](const ReferenceForm& base) {
        change = std::max(change, std::abs(here - base.at_origin()) - base.origin_bound());
    };
    for (const ReferenceForm& wider : kind.subspan(index + 1)) consider(wider);
    for (const ReferenceForm& other : other_kind)
        if (other.reach() >= kind[index].reach()) consider(other);
    return change + kind[index].origin_bound();
}

} // namespace

std::optional<DentForm> dent_form(std::span<const FormHeight> heights, double half_window) {
    const std::vector<ReferenceForm> flat = fits(heights, half_window, BaseKind::flat);
    const std::vector<ReferenceForm> bent = fits(heights, half_window, BaseKind::bent);
    std::optional<DentForm> best;
    const auto consider = [&](const std::vector<ReferenceForm>& kind,
                              const std::vector<ReferenceForm>& other) {
        for (std::size_t i = 1; i < kind.size(); ++i) {
            const double bound = bound_of(kind, i, other);
            if (!best || bound < best->bound) best = DentForm{kind[i], bound};
        }
    };
    consider(flat, bent), consider(bent, flat);
    return best;
}

} // namespace keiko
