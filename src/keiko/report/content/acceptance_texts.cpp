#include "keiko/report/content/acceptance_texts.h"

#include "keiko/report/markup/html_text.h"

#include <charconv>
#include <chrono>

namespace keiko {
namespace {

/// A number of digits alone; -1 for any other text.
int number_of(std::string_view digits) {
    int number = -1;
    if (digits.find_first_not_of("0123456789") != std::string_view::npos) return -1;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return number;
}

} // namespace

bool is_date(std::string_view text) {
    if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
    const int year = number_of(text.substr(0, 4)), month = number_of(text.substr(5, 2)),
              day = number_of(text.substr(8, 2));
    if (year < 0 || month < 0 || day < 0) return false;
    return std::chrono::year_month_day(std::chrono::year(year),
                                       std::chrono::month(static_cast<unsigned>(month)),
                                       std::chrono::day(static_cast<unsigned>(day)))
        .ok();
}

std::string text_of(const AcceptanceNote& note) {
    return note.why + " (" + note.who + ", " + note.when +
           (note.until.empty() ? "" : ", until " + note.until) + ")";
}

std::string name_of(const Acceptance& entry) {
    return entry.code + " at " + place_text(entry.place) + " (" + entry.faces +
           (entry.view.empty() ? ")" : ", in view " + entry.view + ")");
}

std::string text_of(const AcceptanceRemark& remark) {
    const Acceptance& entry = remark.entry;
    const std::string name = "the acceptance of " + name_of(entry);
    switch (remark.kind) {
        case AcceptanceRemark::Kind::expired:
            return name + " expired on " + entry.note.until;
        case AcceptanceRemark::Kind::grown:
            return name + " does not cover the finding there, which is worse than what was " +
                   "accepted: " + short_number(remark.finding->worst.value) + " instead of " +
                   short_number(entry.value) + " " + entry.unit +
                   ", more uncertain, or on a longer stretch";
        case AcceptanceRemark::Kind::held_closer:
            return name + " does not cover the finding there, which is held to a closer limit: " +
                   short_number(remark.finding->worst.limit) + " instead of " +
                   short_number(entry.limit) + " " + entry.unit;
        case AcceptanceRemark::Kind::unused:
            break;
    }
    return name + " covers nothing any more: no such finding is within " +
           short_number(entry.reach) + " mm";
}

} // namespace keiko
