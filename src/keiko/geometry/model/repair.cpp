#include "keiko/geometry/model/repair.h"

#include <array>

namespace keiko {
namespace {

struct Words {
    std::string_view name, text;
};

/// Words of each kind, in the order of RepairKind.
constexpr std::array words{
    Words{"p_curve_built", "p-curve built"},
    Words{"p_curve_approximated", "p-curve approximated"},
    Words{"p_curve_moved", "p-curve moved by a whole period"},
    Words{"edges_sorted", "edges of a wire sorted"},
    Words{"edge_reversed", "edge that ran against its wire reversed"},
    Words{"edge_dropped", "edge that bounds nothing left out"},
    Words{"tiny_edge", "edge shorter than its tolerance kept"},
    Words{"degenerate_edge_added", "missing edge at a pole added"},
    Words{"gap_bridged", "gap between edges bridged"},
    Words{"loop_closed", "open loop closed"},
    Words{"point_loop_dropped", "loop that is only a point left out"},
    Words{"wire_split", "wire of several loops split"},
    Words{"wire_reversed", "wire around the surface reversed"},
    Words{"wire_around_closed", "wire around the surface closed without a seam"},
    Words{"loop_doubled", "loop across the seam doubled"},
    Words{"loop_runs_backwards", "loop runs backwards, judged by nesting"},
    Words{"surface_continued", "surface continued to its loops"},
    Words{"loops_cut_off", "loops beyond the surface cut off"},
    Words{"surface_approximated", "surface approximated"},
    Words{"by_reader", "remark of the CAD reader"}};
static_assert(words.size() == static_cast<std::size_t>(RepairKind::by_reader) + 1);

} // namespace

std::string_view name_of(RepairKind kind) {
    return words[static_cast<std::size_t>(kind)].name;
}

std::string_view text_of(RepairKind kind) {
    return words[static_cast<std::size_t>(kind)].text;
}

} // namespace keiko
