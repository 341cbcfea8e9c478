#include "keiko/report/content/combs_text.h"

#include "keiko/inspect/basics/placed_face.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>

namespace keiko {
namespace {

using Kind = SectionRemark::Kind;

std::string text_of(const SectionRemark& first, std::size_t count, const SectionPlane& plane,
                    const SurfaceModel& model) {
    const std::string begin = "section " + plane.name;
    if (first.kind == Kind::missed)
        return begin + " misses the body, whose patches reach from " +
               short_number(first.reach[0], 6) + " to " + short_number(first.reach[1], 6) +
               " mm along it";
    const std::string face = placed_face_name(model, first.instance, first.face);
    const std::string more = count > 1
                                 ? " and " + std::to_string(count - 1) + " more such " +
                                       std::string(first.kind == Kind::within ? "faces" : "places")
                                 : "";
    if (first.kind == Kind::within)
        return begin + ": " + face + more + " lies in the plane, which has no curve there";
    return begin + " touches " + face + " at " + place_text(first.place) + more +
           ", where it has no curve";
}

} // namespace

std::vector<std::string> comb_remarks(const FoundCombs& combs, std::span<const SectionPlane> planes,
                                      const SurfaceModel& model) {
    std::vector<std::string> texts;
    for (std::uint32_t plane = 0; plane < planes.size(); ++plane)
        for (const Kind kind : {Kind::missed, Kind::within, Kind::touches}) {
            const auto same = [&](const SectionRemark& remark) {
                return remark.plane == plane && remark.kind == kind;
            };
            const auto first = std::find_if(combs.remarks.begin(), combs.remarks.end(), same);
            if (first == combs.remarks.end()) continue;
            const auto count = std::count_if(first, combs.remarks.end(), same);
            texts.push_back(text_of(*first, static_cast<std::size_t>(count), planes[plane], model));
        }
    return texts;
}

} // namespace keiko
