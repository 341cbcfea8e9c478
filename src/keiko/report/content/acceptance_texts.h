#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/acceptance.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// True for a day of the calendar as "2026-11-27".
bool is_date(std::string_view text);

/// "tool mark, not visible (Ann, 2026-11-27, until 2027-02-01)".
std::string text_of(const AcceptanceNote& note);

/// Code, place and faces of an acceptance: "G-SU-LG at 1.0, 2.0, 3.0 (face 1 | face 2)".
std::string name_of(const Acceptance& entry);

/// One sentence on an acceptance that covers nothing.
std::string text_of(const AcceptanceRemark& remark);

/// Acceptances as "keiko-accepted/1" of docs/file-formats.md.
std::string acceptances_json(std::span<const Acceptance> entries);

/// Inverse of acceptances_json. `file` is for messages. Throws Error that names the entry, from 1,
/// and the reason.
std::vector<Acceptance> acceptances_from_json(const std::string& text, const std::string& file);

/// Faults and findings of a report to accept, by numbers from 1.
struct AcceptedNumbers {
    /// Faults of a keiko-report/1, each with all of its findings; of a keiko-inspection/1, which
    /// has no faults, findings.
    std::vector<std::size_t> items;
    std::vector<std::size_t> findings; ///< single ones, of either
};

/// Acceptances of findings of a report (keiko-inspection/1 or keiko-report/1), each once, in the
/// order of `numbers`. What is only worth a look in a fault is left out. Throws Error for a text
/// that is none, for a number without a fault or a finding, and for what has no part in a verdict.
std::vector<Acceptance> acceptances_of_report(const std::string& text, const std::string& file,
                                              const AcceptedNumbers& numbers,
                                              const AcceptanceNote& note);

} // namespace keiko
