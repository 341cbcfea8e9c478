#include "keiko/workflow/accepted_findings.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/workflow/version.h"

#include <algorithm>

namespace keiko {
namespace {

/// True if an acceptance still holds for the very finding that another accepts.
bool holds_for(const Acceptance& earlier, const Acceptance& later, const std::string& today) {
    return !is_expired(earlier.note, today) && earlier.value == later.value &&
           earlier.bound == later.bound && earlier.verdict == later.verdict;
}

void add(Acceptance entry, const std::string& today, const std::string& file,
         AddedAcceptances& all) {
    const auto same =
        std::find_if(all.entries.begin(), all.entries.end(),
                     [&](const Acceptance& other) { return accept_the_same(other, entry); });
    all.added.push_back(entry);
    if (same == all.entries.end()) {
        all.entries.push_back(std::move(entry));
        return;
    }
    const auto number = same - all.entries.begin() + 1;
    if (holds_for(*same, entry, today))
        throw Error(file, "entry " + std::to_string(number),
                    "accepts " + name_of(entry) + " already");
    all.replaced.push_back(*same);
    *same = std::move(entry);
}

void require_end(const AcceptanceNote& note, const std::string& today) {
    if (!note.until.empty() && !is_date(note.until))
        throw FieldError("until", "'" + note.until + "' is no date as 2026-11-27");
    if (is_expired(note, today))
        throw FieldError("until", "'" + note.until + "' is over already: it is " + today);
}

} // namespace

std::string date_today() {
    return utc_now("%Y-%m-%d");
}

AcceptanceList read_acceptances(const std::filesystem::path& file, std::string today) {
    return {acceptances_from_json(read_text_file(file), file.string()), std::move(today)};
}

AcceptanceList earlier_acceptances(const std::filesystem::path& file, std::string today) {
    if (!std::filesystem::exists(file)) return {{}, std::move(today)};
    return read_acceptances(file, std::move(today));
}

AddedAcceptances accept_items(const AcceptanceList& earlier, const std::filesystem::path& file,
                              const std::filesystem::path& report, const AcceptedNumbers& numbers,
                              const AcceptanceNote& note) {
    require_end(note, earlier.today);
    AddedAcceptances all{earlier.entries, {}, {}};
    for (Acceptance& entry :
         acceptances_of_report(read_text_file(report), report.string(), numbers, note))
        add(std::move(entry), earlier.today, file.string(), all);
    return all;
}

} // namespace keiko
