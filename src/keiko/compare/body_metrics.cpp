#include "keiko/compare/body_metrics.h"

#include "keiko/compare/alignment/placed_model.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/math/quadrature.h"

#include <map>

namespace keiko {
namespace {

constexpr int quadrature_order = 8; ///< nodes each way on a patch, and on a border curve

/// Metrics of one check.
class MetricList {
public:
    explicit MetricList(std::string check) : check_(std::move(check)) {}

    void add(const std::string& name, Quantity quantity, double value) {
        metrics_.push_back({check_, name, quantity, value});
    }
    void add_count(const std::string& name, std::size_t value) {
        add(name, Quantity::count, static_cast<double>(value));
    }
    void add_word(const std::string& name, std::string_view word) {
        metrics_.push_back({check_, name, Quantity::verdict, std::string(word)});
    }
    void add_point(const std::string& name, Quantity quantity, const Vec3& p) {
        add(name + " x", quantity, p.x);
        add(name + " y", quantity, p.y);
        add(name + " z", quantity, p.z);
    }
    std::vector<Metric> taken() && { return std::move(metrics_); }

private:
    std::string check_;
    std::vector<Metric> metrics_;
};

/// A measure and its first moment.
struct Moments {
    double measure = 0;
    Vec3 moment{0};
    Vec3 direction{0}; ///< integral of the unit normal

    Vec3 centre() const { return measure > 0 ? moment / measure : Vec3(0); }
};

void add_patch(const BezierPatchView& patch, Moments& sum) {
    for (const QuadratureNode& i : gauss_legendre(quadrature_order))
        for (const QuadratureNode& j : gauss_legendre(quadrature_order)) {
            const auto s = evaluate(patch, {(1 + i.x) / 2, (1 + j.x) / 2}, 1);
            const Vec3 normal = s.du().cross(s.dv()) * (i.weight * j.weight / 4);
            const double area = normal.length();
            sum.measure += area, sum.moment += s.position() * area, sum.direction += normal;
        }
}

Moments surface_moments(const SurfaceModel& model, const Face& face) {
    Moments sum;
    for (std::uint32_t k = 0; k < face.patch_count; ++k)
        add_patch(model.patch(face.first_patch + k), sum);
    if (face.reversed) sum.direction = -sum.direction;
    return sum;
}

std::vector<Moments> border_moments(const SurfaceModel& model) {
    const BoundaryCurves curves(model);
    std::vector<Moments> sums(model.faces.size());
    for (const BoundaryInterval& border : curves.all()) {
        const SurfaceCurve curve = curves.curve(border);
        Moments& sum = sums[border.face];
        for (const QuadratureNode& node : gauss_legendre(quadrature_order)) {
            const SurfaceCurve::Point p = curve.at((1 + node.x) / 2);
            const double length = p.first.length() * node.weight / 2;
            sum.measure += length, sum.moment += p.position * length;
        }
    }
    return sums;
}

void add_seam(const std::string& name, const MeasuredSeam& seam, MetricList& list) {
    const std::string verdict(name_of(seam.verdict));
    const bool plain = seam.kind == SeamClass::smooth;
    list.add_word(name + "verdict",
                  plain ? verdict : std::string(name_of(seam.kind)) + ", " + verdict);
    list.add(name + "length", Quantity::length, seam.length);
    list.add(name + "gap", Quantity::gap, seam.gap.value);
    if (seam.angle) list.add(name + "angle", Quantity::angle, seam.angle->value);
    if (seam.curvature) {
        list.add(name + "curvature", Quantity::curvature, seam.curvature->worst.value);
        list.add_word(name + "curvature verdict", name_of(seam.curvature->worst.verdict));
    }
    if (seam.fading) list.add(name + "fading", Quantity::angle, seam.fading->value);
    if (seam.slope) list.add(name + "slope", Quantity::slope, seam.slope->worst.value);
}

/// Name with a number where it is met again: parts placed twice may have one name, two faces may
/// meet twice.
std::string numbered(const std::string& name, std::map<std::string, int>& met) {
    const int number = ++met[name];
    return number > 1 ? name + " #" + std::to_string(number) : name;
}

} // namespace

std::vector<Metric> shape_metrics(const SurfaceModel& model, const ModelFacts& facts) {
    MetricList list("shape");
    list.add_count("faces", facts.placed_faces);
    list.add_count("lost faces", facts.lost_faces.size());
    list.add_count("patches", facts.patches);
    list.add_count("trimmed faces", facts.trimmed_faces);
    list.add_count("seams", facts.seams);
    list.add("borders that meet no other", Quantity::length, facts.free_length);
    const PlacedModel placed = placed_model(model);
    const std::vector<Moments> borders = border_moments(placed.model);
    std::map<std::string, int> met;
    for (std::size_t f = 0; f < placed.origin.size(); ++f) {
        const PlacedFace& origin = placed.origin[f];
        const std::string name =
            numbered(placed_face_name(model, origin.instance, origin.face), met) + ": ";
        const Moments surface = surface_moments(placed.model, placed.model.faces[f]);
        list.add(name + "area", Quantity::area, surface.measure);
        list.add_point(name + "centre", Quantity::place, surface.centre());
        list.add_point(name + "direction", Quantity::direction,
                       surface.direction / std::max(surface.measure, 1e-300));
        list.add(name + "border length", Quantity::length, borders[f].measure);
        list.add_point(name + "border centre", Quantity::place, borders[f].centre());
    }
    return std::move(list).taken();
}

std::vector<Metric> seam_metrics(const Inspection& inspection) {
    MetricList list("seams");
    std::map<std::string, int> met;
    for (const MeasuredSeam& seam : inspection.seams) {
        // Scraps come and go with the rounding of exports.
        if (seam.scrap) continue;
        add_seam(numbered(seam.faces, met) + ": ", seam, list);
    }
    return std::move(list).taken();
}

std::vector<Metric> line_metrics(const std::string& view, std::span<const LineSource> sources,
                                 std::span<const SurfaceLine> lines) {
    std::vector<std::vector<double>> lengths;
    for (const LineSource& source : sources)
        lengths.emplace_back(static_cast<std::size_t>(source.row.lamps));
    for (const SurfaceLine& line : lines) lengths[line.plane][line.lamp] += length_of(line.line);
    MetricList list("lines");
    for (std::size_t plane = 0; plane < lengths.size(); ++plane)
        for (std::size_t lamp = 0; lamp < lengths[plane].size(); ++lamp)
            list.add(view + ": plane " + std::to_string(plane + 1) + ", lamp " +
                         std::to_string(lamp + 1),
                     Quantity::line, lengths[plane][lamp]);
    return std::move(list).taken();
}

} // namespace keiko
