#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/acceptance.h"
#include "keiko/report/content/acceptance_texts.h"

#include <filesystem>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// The day of the clock in UTC, "2026-11-27".
std::string date_today();

/// The accepted findings of a file (keiko-accepted/1), applied on `today`. Throws Error that names
/// the entry and the reason.
AcceptanceList read_acceptances(const std::filesystem::path& file, std::string today);

/// The accepted findings of a file that more are to be added to, as of read_acceptances; none if it
/// does not exist.
AcceptanceList earlier_acceptances(const std::filesystem::path& file, std::string today);

/// Acceptances, some of them added to earlier ones.
struct AddedAcceptances {
    std::vector<Acceptance> entries;  ///< all of them: the earlier ones first, in their order
    std::vector<Acceptance> added;    ///< the new ones
    std::vector<Acceptance> replaced; ///< earlier ones of the same finding that no longer held
};

/// Adds acceptances of findings of a report to earlier ones. One that has expired, or that is of
/// another value, is replaced. Throws Error naming `file` for a finding that is accepted already,
/// and for a report that cannot be read. Throws FieldError for an `until` of the note that is no
/// date, or that is over.
AddedAcceptances accept_items(const AcceptanceList& earlier, const std::filesystem::path& file,
                              const std::filesystem::path& report, const AcceptedNumbers& numbers,
                              const AcceptanceNote& note);

} // namespace keiko
