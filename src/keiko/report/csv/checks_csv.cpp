#include "keiko/report/csv/checks_csv.h"

#include "keiko/base/text.h"
#include "keiko/report/markup/csv_text.h"

#include <initializer_list>

namespace keiko {
namespace {

std::string field(std::string_view any_text) {
    const std::string text = as_utf8(any_text);
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    return csv_quoted(text);
}

std::string row(std::initializer_list<std::string> fields) {
    std::string text;
    for (const std::string& f : fields) text += f + ",";
    text.back() = '\r';
    return text + "\n";
}

std::string row(const Check& check) {
    const MeasuredValue& w = check.worst;
    const auto if_judged = [&](double value) { return check.judged ? csv_number(value) : ""; };
    return row({check.seam == no_index ? "" : std::to_string(check.seam + 1), field(check.view),
                field(check.faces), field(check.code), field(check.quantity),
                check.judged ? std::string(outcome_of(check)) : "not judged", if_judged(w.value),
                if_judged(w.bound), if_judged(w.limit), field(check.unit), field(check.formula),
                if_judged(w.place.x), if_judged(w.place.y), if_judged(w.place.z),
                field(check.message)});
}

} // namespace

std::string checks_csv(const Inspection& inspection) {
    std::string text = row({"seam", "view", "faces", "code", "quantity", "verdict", "value",
                            "bound", "limit", "unit", "formula", "x", "y", "z", "message"});
    for (const Check& check : inspection.checks) text += row(check);
    return text;
}

} // namespace keiko
