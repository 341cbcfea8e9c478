#include "keiko/triage/mending.h"

#include <array>
#include <utility>

namespace keiko {
namespace {

/// Mendings of criteria, by their codes. All others ask for another layout.
constexpr std::array<std::pair<std::string_view, Mending>, 14> mendings{
    {{"G-SU-LG", Mending::position},
     {"KEIKO-OPENING", Mending::position},
     {"KEIKO-SYMMETRY", Mending::position},
     {"G-SU-NT", Mending::tangent},
     {"KEIKO-LINE-JUMP", Mending::tangent},
     {"KEIKO-LINE-TURN", Mending::tangent},
     {"G-SU-NS", Mending::curvature},
     {"KEIKO-G3", Mending::curvature},
     {"KEIKO-RUN-OUT", Mending::curvature},
     {"G-SU-CR", Mending::curvature},
     {"G-SU-WV", Mending::curvature},
     {"KEIKO-DENT", Mending::curvature},
     {"KEIKO-LINE-KINK", Mending::curvature},
     {"KEIKO-LINE-BEND", Mending::curvature}}};

} // namespace

std::string_view name_of(Mending mending) {
    switch (mending) {
        case Mending::position:
            return "position";
        case Mending::tangent:
            return "tangent";
        case Mending::curvature:
            return "curvature";
        case Mending::layout:
            return "layout";
    }
    return "";
}

Mending mending_of(const Check& check) {
    for (const auto& [code, mending] : mendings)
        if (code == check.code) return mending;
    return Mending::layout;
}

} // namespace keiko
