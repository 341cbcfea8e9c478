#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/check.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// A finding that a person accepted, as it was then. It covers one finding of the same code and
/// near the same place, which has not grown by more than a tenth and is held to no closer limit.
struct Acceptance {
    /// The stretch of a seam that the finding is of.
    struct Stretch {
        Vec3 middle{0};    ///< a point halfway along, world, mm
        double length = 0; ///< mm
    };

    std::string code;    ///< as Check
    std::string formula; ///< as Check
    std::string view;    ///< as Check
    std::string faces;   ///< as Check; a hint, since numbers of faces change between revisions
    std::string unit;    ///< as Check
    Vec3 place{0};       ///< world, mm
    double reach = 1;    ///< mm that the place may have moved
    std::optional<Stretch> stretch;       ///< of a finding of a seam
    double value = 0, bound = 0;          ///< as MeasuredValue
    double limit = 0;                     ///< that the value was held to
    Verdict verdict = Verdict::undecided; ///< fail or undecided
    AcceptanceNote note;                  ///< who, why, when, until
};

/// Acceptances, and the day on which they are applied.
struct AcceptanceList {
    std::vector<Acceptance> entries; ///< in the order of their file
    std::string today;               ///< "2026-11-27"; those that ended before cover nothing
};

/// An acceptance that covers nothing, and the reason.
struct AcceptanceRemark {
    /// Why it covers nothing.
    enum class Kind {
        expired,     ///< its last day is over
        grown,       ///< the finding there has grown by more than a tenth
        held_closer, ///< the finding there is held to a closer limit
        unused       ///< there is no such finding near its place
    };
    Kind kind = Kind::unused;     ///< why
    Acceptance entry;             ///< the acceptance
    std::optional<Check> finding; ///< that has grown or is held closer
};

/// The worst of several checks that do not pass.
struct WorstChecks {
    Verdict all = Verdict::pass;  ///< of all
    Verdict left = Verdict::pass; ///< of those that are not accepted

    /// Adds a finding, or one that would be if it were not accepted.
    void add(const Check& check) {
        all = std::max(all, check.worst.verdict);
        if (!check.is_accepted()) left = std::max(left, check.worst.verdict);
    }
    /// A measured verdict without what is accepted. One that no check explains stays as it is.
    Verdict left_of(Verdict measured) const { return measured > all ? measured : left; }
};

/// mm that the place of a finding of a face or of lines, or the course of a seam, may move from one
/// revision to the next. Borders of a fillet are further apart.
constexpr double acceptance_reach = 1;

/// The acceptance of a finding as it is; `seams` are those of its inspection.
Acceptance acceptance_of(const Check& finding, std::span<const MeasuredSeam> seams,
                         AcceptanceNote note);

/// mm that the worst place of a finding of a stretch may move along it.
double acceptance_reach_on(double stretch_length);

/// True if both accept the same finding, of the same code at the very same place.
bool accept_the_same(const Acceptance& a, const Acceptance& b);

/// True if the date of an acceptance's end lies before `today`.
bool is_expired(const AcceptanceNote& note, const std::string& today);

/// Marks as accepted each finding among `checks` that an entry covers. An entry covers one finding
/// at the most, and a finding is covered by one entry. Returns the entries that cover none.
std::vector<AcceptanceRemark> accept(std::span<Check> checks, const AcceptanceList& list,
                                     std::span<const MeasuredSeam> seams);

} // namespace keiko
