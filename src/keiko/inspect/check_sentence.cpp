#include "keiko/inspect/check_sentence.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>

namespace keiko {
namespace {

constexpr std::array criteria{
    Criterion{"G-SU-LG", "gap_between_faces_related_to_an_edge", "gap",
              "Distance between the trimmed borders of the two sides of a seam (G0)."},
    Criterion{"G-SU-NT", "g1_discontinuity_between_adjacent_faces", "angle",
              "Angle between the surface normals on the two sides of a seam (G1)."},
    Criterion{"G-SU-NS", "g2_discontinuity_between_adjacent_faces", "curvature",
              "Mismatch of the normal curvatures across a seam (G2)."},
    // Neither [SASIG-PDQ] nor [ISO10303-59] names a check of G3.
    Criterion{"KEIKO-G3", "", "curvature_slope",
              "Change of the slope of the normal curvature across a seam (G3)."},
    Criterion{"KEIKO-RUN-OUT", "", "fading",
              "Step of the slope of a crease's angle along the seam where the crease fades out."},
    Criterion{"G-SU-NA", "entirely_narrow_face", "width",
              "Width of a strip of a face beside a crease: the step across it is not judged."},
    Criterion{"G-SU-CR", "surface_with_small_curvature_radius", "radius",
              "Smallest radius of curvature of a face, over what its trims leave of it."},
    // Neither [SASIG-PDQ] nor [ISO10303-59] names a check of draft.
    Criterion{"KEIKO-DRAFT", "", "draft",
              "Smallest draft angle of a face against the pull of its tool, over what its trims "
              "leave of it."},
    Criterion{"G-SU-WV", "", "waviness", "Depth of waves of a surface, off the form around them."},
    Criterion{"KEIKO-DENT", "", "dent",
              "Depth of a dent or height of a bump of a surface, off the form around it."},
    Criterion{"G-SU-FO", "abrupt_change_of_surface_normal", "fold",
              "Angle by which the normal of a face turns over inside it: the face folds back."},
    Criterion{"KEIKO-SINGULAR", "abrupt_change_of_surface_normal", "singular_place",
              "Angle between the normals about a place of a face at which they have no limit."},
    Criterion{
        "KEIKO-OPENING", "", "opening",
        "Width of a notch, slit or small hole between free edges of faces that meet or nearly do, "
        "or of a groove between two of their creases."},
    Criterion{"KEIKO-OVERLAP", "partly_overlapping_faces", "overlap",
              "Length of a free edge that lies on the inside of another face, the faces on each "
              "other."},
    Criterion{"KEIKO-TEE", "", "tee",
              "Length of a free edge that ends on the inside of another face, its face at an angle "
              "to that."},
    Criterion{"KEIKO-CROSSING", "", "crossing",
              "Length of a free edge beside the face that it passes through."},
    Criterion{"G-SU-HD", "excessively_high_degree_surface", "degree",
              "Degree of a spline surface, the larger of its two."},
    // Neither [SASIG-PDQ] as Keiko knows it nor [ISO10303-59] names a limit of spans.
    Criterion{"KEIKO-SPANS", "", "spans",
              "Number of knot spans of a spline surface, the larger of its two directions."},
    Criterion{"G-SU-IK", "indistinct_surface_knots", "knot_distance",
              "Width in space of the narrowest knot span of a spline surface."},
    Criterion{"G-SU-TI", "narrow_surface_patch", "patch_edge",
              "Length of the shortest edge of a patch that is not a point."},
    Criterion{"G-SU-DC", "nearly_degenerate_surface_boundary", "degenerate_edge",
              "Length of the shortest edge of a patch, 0 where the edge is a point."},
    Criterion{"G-SU-DP", "nearly_degenerate_surface_patch", "corner_angle",
              "Angle between the edges of a patch at a corner, from 0 or 180 degrees."},
    Criterion{"G-SU-RN", "extreme_patch_width_variation", "width_ratio",
              "Ratio of the widths in space of two knot spans of a spline surface side by side."},
    // Neither [SASIG-PDQ] as Keiko knows it nor [ISO10303-59] names order and evenness of nets.
    Criterion{"KEIKO-NET-TURN", "", "control_turn",
              "Angle between two legs of a row of control points that follow each other."},
    Criterion{"KEIKO-NET-TWIST", "", "control_twist",
              "Angle between two legs side by side in neighbouring rows of control points."},
    Criterion{
        "KEIKO-NET-RATIO", "", "control_ratio",
        "Ratio of the lengths of two legs of a row of control points that follow each other."},
    Criterion{"KEIKO-NET-POINTS", "multiply_defined_cartesian_points", "control_distance",
              "Distance of two control points that follow each other in a row."},
    Criterion{"G-SU-EM", "multiply_defined_faces", "identical_face",
              "Distance of a face from another one, all over the face."},
    Criterion{"G-CU-EM", "multiply_defined_edges", "identical_edge",
              "Distance of an edge from another one, all along the edge."},
    Criterion{"G-SU-IS", "self_intersecting_surface", "self_distance",
              "Distance of a face from itself, between places that are far apart along it."},
    Criterion{"G-LO-IS", "self_intersecting_loop", "loop_crossing",
              "Length of the part of a loop of borders that a crossing of the loop cuts off."},
    Criterion{"G-CU-LG", "gap_between_adjacent_edges_in_loop", "edge_gap",
              "Distance between the ends of two edges that follow each other in a loop."},
    Criterion{"G-CU-NT", "g1_discontinuous_curve", "edge_angle",
              "Angle between the tangents of two curves of one edge where they meet."},
    Criterion{"G-CU-HD", "excessively_high_degree_curve", "edge_degree",
              "Degree of a curve of an edge in the parameters of its face."},
    Criterion{"G-CU-IK", "indistinct_curve_knots", "edge_knot_distance",
              "Length in space of the shortest curve of an edge that has several."},
    Criterion{"G-CU-TI", "short_length_edge", "edge_length",
              "Length of the shortest edge that bounds a face."},
    Criterion{"G-FA-TI", "small_area_face", "face_size",
              "Size of a face: the diagonal of the box of its borders."},
    Criterion{"KEIKO-SYMMETRY", "", "symmetry",
              "Largest distance of a body's surface from its own mirror image."},
    Criterion{"KEIKO-JOINT-GAP", "", "joint_gap",
              "Deviation of the gap between two panels that stand apart from its nominal size."},
    Criterion{"KEIKO-JOINT-FLUSH", "", "joint_flush",
              "Deviation of the step between the skins of two panels from its nominal size."},
    Criterion{"KEIKO-JOINT-PARALLEL", "", "joint_parallelism",
              "Difference of the largest and the smallest gap along a joint between two panels."},
    Criterion{"KEIKO-JOINT-RADIUS", "", "joint_radius",
              "Smallest radius of the edges of two panels at their joint."},
    Criterion{"KEIKO-LINE-JUMP", "", "line_jump",
              "Jump of a reflection line across itself where it crosses a seam."},
    Criterion{
        "KEIKO-LINE-TURN", "", "line_turn",
        "Seam angle that moves a lamp's image as far as it jumps where its line crosses a seam."},
    Criterion{"KEIKO-LINE-KINK", "", "line_kink",
              "Angle of a reflection line where it crosses a seam."},
    Criterion{"KEIKO-LINE-BEND", "", "line_bend",
              "Change of a reflection line's curvature where it crosses a seam."}};

/// A value's error bound with its trailing zeros, "0.0370", which state its precision.
std::string bound_number(double bound) {
    char text[32];
    std::snprintf(text, sizeof text, "%#.3g", bound);
    return text;
}

std::string sentence(const MeasuredValue& worst, const Wording& wording) {
    const char* relation =
        worst.verdict == Verdict::fail
            ? (worst.at_least ? " is under the limit of " : " is over the limit of ")
        : worst.verdict == Verdict::pass ? " is within the limit of "
                                         : " cannot be told from the limit of ";
    const std::string bound = worst.verdict == Verdict::undecided
                                  ? " ± " + bound_number(worst.bound * wording.scale)
                                  : "";
    return std::string(wording.what) + " of " + short_number(worst.value * wording.scale) + bound +
           wording.unit + relation + short_number(worst.limit * wording.scale) + wording.unit;
}

} // namespace

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

const Criterion& criterion_of(std::string_view code) {
    const auto found = std::find_if(criteria.begin(), criteria.end(),
                                    [&](const Criterion& c) { return c.code == code; });
    if (found == criteria.end()) throw std::out_of_range("no criterion " + std::string(code));
    return *found;
}

Check named_check(std::string_view code) {
    const Criterion& criterion = criterion_of(code);
    Check check;
    check.code = criterion.code, check.rule = criterion.rule, check.quantity = criterion.quantity;
    return check;
}

Check judged_check(std::string_view code, const std::string& unit, const MeasuredValue& worst,
                   const Wording& wording) {
    Check check = named_check(code);
    check.unit = unit, check.worst = worst, check.message = sentence(worst, wording);
    return check;
}

Check unjudged_check(std::string_view code, const std::string& reason) {
    Check check = named_check(code);
    check.judged = false, check.message = "the " + check.quantity + " is not judged: " + reason;
    std::replace(check.message.begin(), check.message.end(), '_', ' ');
    return check;
}

} // namespace keiko
