#include "keiko/inspect/structure/span_nets.h"

#include <algorithm>

namespace keiko {

CurvePoints SpanNet::along_u(std::size_t j) const {
    CurvePoints row;
    for (std::size_t i = 0; i < count_u(); ++i) row.push_back(point(i, j));
    return row;
}

CurvePoints SpanNet::along_v(std::size_t i) const {
    CurvePoints row;
    for (std::size_t j = 0; j < count_v(); ++j) row.push_back(point(i, j));
    return row;
}

std::vector<CurvePoints> SpanNet::rows(bool in_u) const {
    std::vector<CurvePoints> rows;
    for (std::size_t k = 0; k < (in_u ? count_v() : count_u()); ++k)
        rows.push_back(in_u ? along_u(k) : along_v(k));
    return rows;
}

std::vector<SpanNet> span_nets(const SurfaceModel& model, std::uint32_t instance,
                               const Face& face) {
    std::vector<SpanNet> nets;
    for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p)
        nets.push_back(
            {&model.patches[p], PlacedPatch(model, p, model.instances[instance].transform)});
    return nets;
}

bool is_point(const CurvePoints& row, double coincidence) {
    const Vec3 first = euclidean(row.front());
    return std::all_of(row.begin(), row.end(), [&](const Vec4& p) {
        return !((euclidean(p) - first).length() > coincidence);
    });
}

} // namespace keiko
