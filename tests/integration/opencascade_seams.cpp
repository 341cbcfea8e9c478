#include "tests/integration/opencascade_seams.h"

#include "keiko/base/units.h"

#include <Adaptor3d_CurveOnSurface.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Curve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keiko::test {
namespace {

Vec3 vector_of(const gp_XYZ& p) {
    return {p.X(), p.Y(), p.Z()};
}

/// mm: a way into the material that a border's neighbourhood surely has.
constexpr std::array<double, 4> steps_aside = {0.1, 0.01, 0.001, 0.0001};
/// Share of a piece.
constexpr double beside_an_end = 1e-6;
/// mm: a border of a length below it is a point in space.
constexpr double point_length = 1e-6;

/// Geometry of one side of a seam at one place.
struct PeerSide {
    gp_Pnt position;
    gp_Vec du, dv, duu, duv, dvv, normal, along, inward; ///< the last three unit

    /// 1/mm, of the section square to the border, positive towards `normal`.
    double curvature() const {
        const double e = du * du, f = du * dv, g = dv * dv, determinant = e * g - f * f;
        const double u = inward * du, v = inward * dv;
        const double a = (g * u - f * v) / determinant, b = (e * v - f * u) / determinant;
        return a * a * (duu * normal) + 2 * a * b * (duv * normal) + b * b * (dvv * normal);
    }
};

/// An edge on one of its faces.
class Border {
public:
    Border(std::size_t face, const TopoDS_Edge& edge, const TopoDS_Face& on)
        : face_(face), edge_(edge), surface_(new BRepAdaptor_Surface(on, false)) {
        double first = 0, last = 0;
        const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, on, first, last);
        if (curve.IsNull() || BRep_Tool::Degenerated(edge)) return;
        p_curve_ = new Geom2dAdaptor_Curve(curve, first, last);
        curve_ = Adaptor3d_CurveOnSurface(p_curve_, surface_);
        list_places();
        if (length_ > point_length) find_material(on);
    }

    std::size_t face() const { return face_; }
    const TopoDS_Edge& edge() const { return edge_; }
    /// Whether it has a length and a side on which the material lies.
    bool bounds() const { return material_ != 0; }
    const Bnd_Box& box() const { return box_; }

    gp_Pnt position(double t) const { return curve_.Value(t); }
    /// mm from a point to the nearer end.
    double from_end(const gp_Pnt& p) const {
        return std::min(p.Distance(places_.front()), p.Distance(places_.back()));
    }

    /// Parameters at even steps of each of its smooth pieces. At their ends themselves, `aside` of
    /// a piece off, the nearest point of a corner would belong to two borders.
    std::vector<double> even_steps(int count, double aside) const {
        std::vector<double> result;
        for (std::size_t i = 1; i < spans_.size(); ++i)
            for (int k = 0; k <= count; ++k) {
                const double share = std::clamp(static_cast<double>(k) / count, aside, 1 - aside);
                result.push_back(spans_[i - 1] + (spans_[i] - spans_[i - 1]) * share);
            }
        return result;
    }

    /// The parameter of its point that is nearest to another.
    double nearest(const gp_Pnt& p) const {
        double best = parameters_.front(), least = std::numeric_limits<double>::infinity();
        std::vector<double> square;
        for (const gp_Pnt& place : places_) square.push_back(place.SquareDistance(p));
        for (std::size_t i = 0; i < square.size(); ++i) {
            const std::size_t before = i > 0 ? i - 1 : i,
                              after = std::min(i + 1, square.size() - 1);
            if (square[i] > square[before] || square[i] > square[after]) continue;
            const double t = foot(p, parameters_[before], parameters_[after]);
            const double distance = position(t).SquareDistance(p);
            if (distance < least) least = distance, best = t;
        }
        return best;
    }

    /// nullopt where the surface is singular or the border stands still.
    std::optional<PeerSide> side(double t) const {
        PeerSide s;
        const gp_Pnt2d uv = p_curve_->Value(t);
        surface_->D2(uv.X(), uv.Y(), s.position, s.du, s.dv, s.duu, s.dvv, s.duv);
        s.normal = s.du.Crossed(s.dv), s.along = tangent(t);
        if (!(s.normal.Magnitude() > 1e-12 * s.du.Magnitude() * s.dv.Magnitude()) ||
            !(s.along.Magnitude() > 0))
            return std::nullopt;
        s.normal.Normalize(), s.along.Normalize();
        s.inward = s.normal.Crossed(s.along) * material_;
        s.inward.Normalize();
        return s;
    }

    gp_Vec tangent(double t) const {
        gp_Pnt p;
        gp_Vec d;
        curve_.D1(t, p, d);
        return d;
    }

    void list_places() {
        const int n = curve_.NbIntervals(GeomAbs_C2);
        TColStd_Array1OfReal knots(1, n + 1);
        curve_.Intervals(knots, GeomAbs_C2);
        for (const double knot : knots) spans_.push_back(knot);
        constexpr int steps = 32;
        parameters_ = even_steps(steps, 0);
        for (const double t : parameters_) {
            places_.push_back(position(t));
            box_.Add(places_.back());
            if (places_.size() > 1) length_ += places_.back().Distance(places_[places_.size() - 2]);
        }
        // What the arcs between the places may leave the box by.
        box_.Enlarge(length_ / steps);
    }

    /// By OpenCASCADE's classifier of parameters, beside places of the border.
    void find_material(const TopoDS_Face& on) {
        BRepTopAdaptor_FClass2d classifier(on, 1e-12);
        for (const double aside : steps_aside)
            for (const double share : {0.5, 0.37, 0.71}) {
                const double t = spans_.front() + share * (spans_.back() - spans_.front());
                const bool left = is_inside(classifier, t, aside),
                           right = is_inside(classifier, t, -aside);
                if (left == right) continue;
                material_ = left ? 1 : -1;
                return;
            }
    }

    bool is_inside(BRepTopAdaptor_FClass2d& classifier, double t, double aside) const {
        gp_Pnt2d uv;
        gp_Vec2d d;
        p_curve_->D1(t, uv, d);
        const double speed = tangent(t).Magnitude();
        const gp_Vec2d left(-d.Y(), d.X());
        if (!(speed > 0)) return false;
        return classifier.Perform(uv.Translated(left * (aside / speed)), false) == TopAbs_IN;
    }

    /// Bisects (C(t) - p) . C'(t) = 0.
    double foot(const gp_Pnt& p, double low, double high) const {
        const auto ahead = [&](double t) {
            gp_Pnt c;
            gp_Vec d;
            curve_.D1(t, c, d);
            return gp_Vec(p, c) * d >= 0;
        };
        if (ahead(low)) return low;
        if (!ahead(high)) return high;
        for (int i = 0; i < 60; ++i) {
            const double middle = (low + high) / 2;
            (ahead(middle) ? high : low) = middle;
        }
        return (low + high) / 2;
    }

    std::size_t face_;
    TopoDS_Edge edge_;
    Handle(BRepAdaptor_Surface) surface_;
    Handle(Geom2dAdaptor_Curve) p_curve_;
    Adaptor3d_CurveOnSurface curve_;
    std::vector<double> spans_, parameters_;
    std::vector<gp_Pnt> places_;
    Bnd_Box box_;
    double length_ = 0;
    int material_ = 0; ///< 1: left of the p-curve, in parameters; -1: right; 0: not known
};

gp_Vec on_one_side(const PeerSide& side, const gp_Vec& across, const gp_Vec& run) {
    return across.Crossed(run) * side.normal < 0 ? -side.normal : side.normal;
}

PeerSeamPlace place_between(const Border& a, double t, const Border& b, double s) {
    PeerSeamPlace place;
    const gp_Pnt p = a.position(t), q = b.position(s);
    place.t = t, place.s = s;
    place.place = vector_of(p.XYZ()), place.foot = vector_of(q.XYZ());
    place.gap = p.Distance(q), place.from_end = std::min(a.from_end(p), b.from_end(q));
    const gp_Vec along = b.tangent(s);
    if (along.Magnitude() > 0) place.slip = std::abs(gp_Vec(p, q) * along) / along.Magnitude();
    auto from = a.side(t), into = b.side(s);
    if (!from || !into) return place;
    const double turn = from->along.Angle(into->along);
    place.turn = radians_to_degrees(std::min(turn, std::acos(-1.0) - turn));
    const bool forward = from->along * into->along > 0;
    from->normal = on_one_side(*from, -from->inward, from->along);
    into->normal = on_one_side(*into, into->inward, forward ? into->along : -into->along);
    place.angle = radians_to_degrees(from->normal.Angle(into->normal));
    place.curvature_a = from->curvature(), place.curvature_b = into->curvature();
    return place;
}

} // namespace

struct OpenCascadeSeams::Borders {
    std::vector<Border> all;
    std::size_t faces = 0;
};

OpenCascadeSeams::OpenCascadeSeams(const TopoDS_Shape& shape)
    : borders_(std::make_unique<Borders>()) {
    for (TopExp_Explorer f(shape, TopAbs_FACE); f.More(); f.Next()) {
        const TopoDS_Face face = TopoDS::Face(f.Current().Oriented(TopAbs_FORWARD));
        for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
            Border border(borders_->faces, TopoDS::Edge(e.Current()), face);
            if (border.bounds()) borders_->all.push_back(std::move(border));
        }
        ++borders_->faces;
    }
}

OpenCascadeSeams::~OpenCascadeSeams() = default;

std::size_t OpenCascadeSeams::border_count() const {
    return borders_->all.size();
}

std::size_t OpenCascadeSeams::face_of(std::size_t border) const {
    return borders_->all[border].face();
}

std::size_t OpenCascadeSeams::face_count() const {
    return borders_->faces;
}

std::vector<PeerSeamPlace> OpenCascadeSeams::facing(std::size_t border, double t,
                                                    double reach) const {
    const Border& a = borders_->all[border];
    Bnd_Box around(a.position(t), a.position(t));
    std::vector<PeerSeamPlace> result;
    for (std::size_t i = 0; i < border_count(); ++i) {
        const Border& b = borders_->all[i];
        const bool closed = b.face() != a.face() || b.edge().IsSame(a.edge());
        if (i == border || !closed || b.box().Distance(around) > reach) continue;
        PeerSeamPlace place = place_between(a, t, b, b.nearest(a.position(t)));
        if (place.gap > reach) continue;
        place.border_a = border, place.border_b = i;
        place.is_shared = b.edge().IsSame(a.edge());
        result.push_back(place);
    }
    return result;
}

std::vector<PeerSeamPlace> OpenCascadeSeams::sample(std::size_t border, int count,
                                                    double reach) const {
    std::vector<PeerSeamPlace> result;
    for (const double t : borders_->all[border].even_steps(count, beside_an_end))
        for (const PeerSeamPlace& place : facing(border, t, reach)) result.push_back(place);
    return result;
}

std::vector<PeerSeamPlace> OpenCascadeSeams::at(std::size_t border, const Vec3& point,
                                                double reach) const {
    return facing(border, borders_->all[border].nearest({point.x, point.y, point.z}), reach);
}

double OpenCascadeSeams::distance(std::size_t border, const Vec3& point) const {
    const Border& on = borders_->all[border];
    const gp_Pnt p(point.x, point.y, point.z);
    if (const double least = on.box().Distance(Bnd_Box(p, p)); least > 0) return least;
    return on.position(on.nearest(p)).Distance(p);
}

} // namespace keiko::test
