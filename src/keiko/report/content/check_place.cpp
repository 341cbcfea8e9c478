#include "keiko/report/content/check_place.h"

#include "keiko/report/markup/html_text.h"

namespace keiko {

std::string subject_of(const Check& check) {
    if (!check.view.empty()) return "lines over " + check.faces + " in view " + check.view;
    if (check.seam == no_index) return check.faces;
    return "seam " + std::to_string(check.seam + 1) + " (" + check.faces + ")";
}

std::string placed_message(const Check& check) {
    return check.faces + ": " + check.message + ", at " + place_text(check.worst.place);
}

} // namespace keiko
