#include "keiko/light/penumbra/width_share.h"

#include <algorithm>

namespace keiko {

void WidthShare::hide_lines(const SourceWidth& width,
                            std::vector<IntervalSet>::const_iterator& next) {
    hide_ends_and_middles(width, options_.between_lines, parts_, next);
    brightest_ = 0;
    for (const Slices& part : parts_) brightest_ = std::max(brightest_, part.brightest());
}

double WidthShare::visible_share(const SourceWidth& width, const Visibility& visible) {
    if (options_.between_lines) look_between(width, visible);
    SolidAngle sums;
    for (const Slices& part : parts_) sums += integrate(width, visible, part, rule_of(part));
    return sums.visible_share();
}

SliceRule WidthShare::rule_of(const Slices& part) const {
    constexpr int most_halvings = 14;
    const double error = options_.tolerance * 2 * brightest_ * part.half;
    return {error, options_.widest_spacing, options_.between_lines, most_halvings, options_.tapers};
}

/// Cuts the width at turns of outlines, as often as necessary for at most the tolerance to be
/// missed between lines.
void WidthShare::look_between(const SourceWidth& width, const Visibility& visible) {
    const double spacing = options_.widest_spacing / 2, allowed = options_.tolerance;
    const std::vector<CriticalSlice> found = visible.turns(width.around(), {spacing, allowed / 2});
    if (found.empty()) return;
    const bool agree = parts_.size() == 1 && ends_and_middle_agree(parts_[0], rule_of(parts_[0]));
    const std::vector<WidthCut> cuts =
        PenumbraBreakpoints(width, found, spacing).cuts(allowed, agree);
    if (!cuts.empty()) cut_at(width, cuts, visible);
}

/// Cuts the width; the visibility of both ends is known.
void WidthShare::cut_at(const SourceWidth& width, std::span<const WidthCut> cuts,
                        const Visibility& visible) {
    std::vector<Slices> parts = parts_of(width, cuts, options_.tapers);
    if (parts.front().begin() == -1) parts.front().seen.front() = parts_.front().seen.front();
    if (parts.back().end() == 1) parts.back().seen.back() = parts_.back().seen.back();
    parts_ = std::move(parts);
    std::vector<Segment> lines;
    add_lines(width, lines);
    const std::vector<IntervalSet> seen = visible.intervals(lines);
    auto next = seen.begin();
    hide_lines(width, next);
}

double visible_share(const SourceWidth& width, const Visibility& visible,
                     const WidthOptions& options) {
    const Prism around = width.around();
    if (const auto whole = visible.classify_prisms({&around, 1}).front()) return *whole ? 1 : 0;
    WidthShare share(width, options);
    std::vector<Segment> lines;
    share.add_lines(width, lines);
    const std::vector<IntervalSet> seen = visible.intervals(lines);
    auto next = seen.begin();
    share.hide_lines(width, next);
    return share.visible_share(width, visible);
}

} // namespace keiko
