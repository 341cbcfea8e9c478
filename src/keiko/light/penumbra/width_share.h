#pragma once

#include "keiko/light/penumbra/source_width.h"
#include "keiko/light/penumbra/width_samples.h"

#include <vector>

namespace keiko {

/// Accuracy of the visible share of a source.
struct WidthOptions {
    double tolerance = 0; ///< of its projected solid angle, as bright all over as at its best
    /// Widest spacing between lines of equal visibility, of half the width, by the place. Smaller
    /// occluders may be missed between them unless they are searched for.
    double widest_spacing = 1;
    /// True if the width is cut where outlines turn that hide more than the tolerance between
    /// lines. Lines then agree only if they do for each visible part.
    bool between_lines = false;
    bool tapers = false; ///< see SliceRule
};

/// Visible share of a source whose lines may be partly hidden
/// (docs/theory/visibility.md#the-width-of-a-lamp). The lines that every source needs are collected
/// first, so that those of many sources can be queried at once. Every call passes one width.
class WidthShare {
public:
    /// Lights the first lines.
    WidthShare(const SourceWidth& width, const WidthOptions& options)
        : options_(options), parts_(parts_of(width, {}, options.tapers)) {}

    /// Parts of the width between its own cuts.
    const std::vector<Slices>& parts() const { return parts_; }
    /// Appends the lines that are queried first.
    void add_lines(const SourceWidth& width, std::vector<Segment>& lines) const {
        add_ends_and_middles(width, parts_, lines);
    }
    /// Sets the visible parts of those lines, from `next` on.
    void hide_lines(const SourceWidth& width, std::vector<IntervalSet>::const_iterator& next);
    /// Visible share of the projected solid angle, 0 to 1. It queries more lines until the
    /// estimated error is below the tolerance; 1 if there is nothing to be hidden.
    double visible_share(const SourceWidth& width, const Visibility& visible);

private:
    SliceRule rule_of(const Slices& part) const;
    void look_between(const SourceWidth& width, const Visibility& visible);
    void cut_at(const SourceWidth& width, std::span<const WidthCut> cuts,
                const Visibility& visible);

    WidthOptions options_;
    std::vector<Slices> parts_;
    double brightest_ = 0;
};

/// Visible share, 0 to 1, of the light of one source by its lines. One query suffices if all
/// between the outermost lines is proved to have one visibility.
double visible_share(const SourceWidth& width, const Visibility& visible,
                     const WidthOptions& options);

} // namespace keiko
