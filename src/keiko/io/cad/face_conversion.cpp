#include "keiko/io/cad/face_conversion.h"

#include "keiko/base/error.h"
#include "keiko/io/cad/transforms.h"
#include "keiko/patch/bezier_patch.h"

#include <BRep_Tool.hxx>
#include <TopLoc_Location.hxx>

#include <cmath>
#include <sstream>

namespace keiko::cad {
namespace {

BezierPatchView view(const SurfacePatch& patch) {
    return {patch.degree_u, patch.degree_v, patch.points};
}

/// Largest distance between the patches and the CAD surface at points inside each patch.
double largest_deviation(const std::vector<SurfacePatch>& patches, const Geom_Surface& surface) {
    constexpr double places[] = {0, 0.37, 1};
    double worst = 0;
    for (const SurfacePatch& patch : patches)
        for (const double u : places)
            for (const double v : places) {
                gp_Pnt p;
                surface.D0(patch.map_u.to_face(u), patch.map_v.to_face(v), p);
                const Vec3 ours = evaluate(view(patch), {u, v}, 0).position();
                const double distance = (ours - Vec3(p.X(), p.Y(), p.Z())).length();
                // Not std::max, which would pass over a NaN.
                if (!(distance <= worst)) worst = distance;
            }
    return worst;
}

/// Throws when the patches are not the surface.
void check(const SurfacePatches& converted, const Geom_Surface& surface) {
    Box3 box;
    double magnitude = 0;
    for (const SurfacePatch& patch : converted.patches) {
        for (const Vec4& p : patch.points)
            if (!std::isfinite(p.x + p.y + p.z + p.w) || !(p.w > 0))
                throw Error("", "", "its control points are not finite with positive weights");
        box.extend(hull_bounds(view(patch)));
    }
    magnitude = std::max(box.lower.length(), box.upper.length());
    // Far from the origin, coordinates themselves are only good to their own rounding.
    const double tolerance = 1e-9 * box.size() + 1e-13 * magnitude + 2 * converted.approximated;
    const double deviation = largest_deviation(converted.patches, surface);
    if (deviation <= tolerance) return;
    std::ostringstream text;
    text << "its patches are " << deviation << " mm off the surface";
    throw Error("", "", text.str());
}

} // namespace

ConvertedFace convert_face(const TopoDS_Face& face, EdgeTable& edges,
                           const std::vector<TopoDS_Edge>& built) {
    TopLoc_Location location;
    const opencascade::handle<Geom_Surface> surface = BRep_Tool::Surface(face, location);
    if (surface.IsNull()) throw Error("", "", "it has no surface");
    ConvertedFace result{{}, 0, face_loops(face, edges, built)};
    SurfacePatches converted = surface_patches(surface, result.trim.domain);
    if (converted.patches.empty()) throw Error("", "", "its trim loops lie outside of its surface");
    check(converted, *untrimmed(surface));
    const Affine to_part = affine(location.Transformation());
    if (!to_part.is_identity())
        for (SurfacePatch& patch : converted.patches)
            for (Vec4& p : patch.points) p = to_part.homogeneous(p);
    result.patches = std::move(converted.patches);
    result.approximated = converted.approximated;
    return result;
}

std::string surface_kind(const TopoDS_Face& face) {
    TopLoc_Location location;
    const auto& surface = BRep_Tool::Surface(face, location);
    return surface.IsNull() ? "none" : surface_kind(surface);
}

} // namespace keiko::cad
