#include "keiko/base/error.h"
#include "keiko/report/content/report_stretch.h"
#include "keiko/report/json/json_parts.h"
#include "keiko/report/markup/json_errors.h"
#include "keiko/report/markup/json_members.h"

#include <algorithm>

namespace keiko {
namespace {

/// mm: ends of stretches are known to a micrometre.
constexpr double apart = 1e-3;

bool is_stretch(const MeasuredSeam& seam, const Json& stated) {
    const Json ids{seam.id_a, seam.id_b};
    return value_at(stated, "face_ids") == ids &&
           (seam.course.front().front() - place_at(stated, "from")).length() <= apart &&
           (seam.course.back().back() - place_at(stated, "to")).length() <= apart;
}

} // namespace

std::optional<std::uint32_t> stretch_of_report(const std::string& text, const std::string& file,
                                               std::uint32_t number, const Inspection& inspection) {
    return with_errors_named(file, "seams", [&]() -> std::optional<std::uint32_t> {
        const Json seams = list_at(Json::parse(text), "seams");
        const auto stated = std::find_if(seams.begin(), seams.end(), [&](const Json& seam) {
            return value_at(seam, "number") == number;
        });
        if (stated == seams.end()) return std::nullopt;
        const auto& known = inspection.seams;
        const auto found = std::find_if(known.begin(), known.end(), [&](const MeasuredSeam& seam) {
            return is_stretch(seam, *stated);
        });
        if (found == known.end()) return std::nullopt;
        return static_cast<std::uint32_t>(found - known.begin());
    });
}

} // namespace keiko
