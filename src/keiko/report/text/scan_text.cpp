#include "keiko/base/text.h"
#include "keiko/report/content/comparison.h"
#include "keiko/report/content/scan_comparison.h"
#include "keiko/report/markup/html_text.h"

namespace keiko {
namespace {

std::string percent(std::size_t part, std::size_t whole) {
    return short_number(100 * static_cast<double>(part) / static_cast<double>(whole)) + " %";
}

std::string place_of(const ScanComparison& c, const std::string& word, const DeviationPlace& at) {
    return word + " " + short_number(at.value) + " mm at (" + place_text(at.place) + "), " +
           c.faces[at.face];
}

void add_points(TextLines& lines, const ScanComparison& c) {
    const ScanDeviation& d = c.deviation;
    if (d.beyond > 0)
        lines.line() << d.beyond << " of " << counted(d.points, "point") << " ("
                     << percent(d.beyond, d.points) << ") further than " << short_number(c.reach)
                     << " mm from the nominal";
    if (d.beside > 0)
        lines.line() << d.beside << " of " << counted(d.points, "point")
                     << " beyond its free borders, left out";
    if (d.uncertain > 0)
        lines.line() << "not proved at " << counted(d.uncertain, "point") << " ("
                     << percent(d.uncertain, d.measured) << ")";
}

} // namespace

std::string scan_text(const ScanComparison& c) {
    const ScanDeviation& d = c.deviation;
    TextLines lines;
    lines.line() << verdict_of(c) << ": " << verdict_reason(c);
    if (c.alignment) {
        lines.line() << "aligned: " << alignment_words(c.alignment->rigid);
        lines.line() << "aligned by: " << fit_words(*c.alignment);
    }
    if (d.measured > 0) {
        lines.line() << "deviation: mean " << short_number(d.mean) << " mm, root mean square "
                     << short_number(d.root_mean_square) << " mm, standard deviation "
                     << short_number(d.standard_deviation) << " mm";
        lines.line() << "half of the points within " << short_number(d.median)
                     << " mm, 90 % within " << short_number(d.percent_90) << " mm, 99 % within "
                     << short_number(d.percent_99) << " mm";
        lines.line() << place_of(c, "lowest", d.lowest);
        lines.line() << place_of(c, "highest", d.highest);
    }
    add_points(lines, c);
    return lines.text();
}

} // namespace keiko
