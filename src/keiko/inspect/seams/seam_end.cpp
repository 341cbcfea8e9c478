#include "keiko/inspect/seams/seam_end.h"

namespace keiko {

SeamEnd end_of(const SeamProbe& probe, const SeamPart& part, bool last) {
    const SeamPoint& point = last ? part.end : part.begin;
    const Vec3 run = probe.run(point.t);
    return {point.place, last ? run : -run};
}

bool goes_on(const SeamEnd& from, const SeamEnd& into, double reach) {
    if (is_corner(from.out, -into.out)) return false;
    const Vec3 way = into.place - from.place;
    if (way.length() <= same_vertex) return true;
    return way.length() <= reach && !is_corner(from.out, way) && !is_corner(way, -into.out);
}

} // namespace keiko
