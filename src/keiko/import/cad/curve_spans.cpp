#include "keiko/import/cad/curve_spans.h"

#include "keiko/base/error.h"
#include "keiko/geometry/bezier/nurbs.h"

#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_Parabola.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>

#include <cmath>

namespace keiko::cad {

namespace {

/// OpenCASCADE has every curve twice, in the plane and in space, with the same interface.
struct InPlane {
    using Curve = Geom2d_Curve;
    using Line = Geom2d_Line;
    using Circle = Geom2d_Circle;
    using Ellipse = Geom2d_Ellipse;
    using Parabola = Geom2d_Parabola;
    using Hyperbola = Geom2d_Hyperbola;
    using Bezier = Geom2d_BezierCurve;
    using BSpline = Geom2d_BSplineCurve;
    using Trimmed = Geom2d_TrimmedCurve;
    using Vector = Vec2;
    using Point = Vec3;

    static Vec3 homogeneous(const Vec2& wp, double w) { return {wp.x, wp.y, w}; }
    static Vec2 vector(const gp_XY& p) { return {p.X(), p.Y()}; }
    static Vec2 direction(const gp_Dir2d& d) { return {d.X(), d.Y()}; }
    static Handle(BSpline) to_bspline(const Handle(Curve) & c) {
        return Geom2dConvert::CurveToBSplineCurve(c);
    }
};

struct InSpace {
    using Curve = Geom_Curve;
    using Line = Geom_Line;
    using Circle = Geom_Circle;
    using Ellipse = Geom_Ellipse;
    using Parabola = Geom_Parabola;
    using Hyperbola = Geom_Hyperbola;
    using Bezier = Geom_BezierCurve;
    using BSpline = Geom_BSplineCurve;
    using Trimmed = Geom_TrimmedCurve;
    using Vector = Vec3;
    using Point = Vec4;

    static Vec4 homogeneous(const Vec3& wp, double w) { return {wp.x, wp.y, wp.z, w}; }
    static Vec3 vector(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }
    static Vec3 direction(const gp_Dir& d) { return {d.X(), d.Y(), d.Z()}; }
    static Handle(BSpline) to_bspline(const Handle(Curve) & c) {
        return GeomConvert::CurveToBSplineCurve(c);
    }
};

/// Converts the part [first, last] of one curve.
template <class D>
class Converter {
public:
    using P = typename D::Point;
    using V = typename D::Vector;
    using CurveHandle = opencascade::handle<typename D::Curve>;

    Converter(CurveHandle curve, double first, double last)
        : curve_(std::move(curve)), first_(first), last_(last) {}

    CurveSpans<P> spans() const {
        if (auto c = as<typename D::Trimmed>())
            return Converter(c->BasisCurve(), first_, last_).spans();
        if (as<typename D::Line>()) return {{line()}};
        if (auto c = as<typename D::Circle>()) return {conic(*c, c->Radius(), c->Radius())};
        if (auto c = as<typename D::Ellipse>())
            return {conic(*c, c->MajorRadius(), c->MinorRadius())};
        if (auto c = as<typename D::Hyperbola>())
            return {conic(*c, c->MajorRadius(), c->MinorRadius())};
        if (as<typename D::Parabola>()) return {{parabola()}};
        if (auto c = as<typename D::Bezier>()) return {clipped({bezier(*c)}, 0)};
        if (auto c = as<typename D::BSpline>()) return {bspline(c)};
        return approximation();
    }

private:
    template <class Kind>
    opencascade::handle<Kind> as() const {
        return opencascade::handle<Kind>::DownCast(curve_);
    }
    V value(double t) const { return D::vector(curve_->Value(t).Coord()); }
    P point(double t) const { return D::homogeneous(value(t), 1); }
    ParameterMap whole() const { return {ParameterMap::Kind::affine, first_, last_}; }

    CurveSpan<P> line() const { return {whole(), {point(first_), point(last_)}}; }

    CurveSpan<P> parabola() const {
        const V begin = value(first_), end = value(last_);
        const V middle = value((first_ + last_) / 2) * 2.0 - (begin + end) * 0.5;
        return {whole(),
                {D::homogeneous(begin, 1), D::homogeneous(middle, 1), D::homogeneous(end, 1)}};
    }

    template <class Conic>
    std::vector<CurveSpan<P>> conic(const Conic& c, double major, double minor) const {
        const V center = D::vector(c.Position().Location().Coord());
        const V x = D::direction(c.Position().XDirection()) * major;
        const V y = D::direction(c.Position().YDirection()) * minor;
        std::vector<CurveSpan<P>> result;
        for (const UnitArc& arc : arcs(c)) {
            CurveSpan<P> span{arc.map, {}};
            for (const Vec3& p : arc.points)
                span.points.push_back(D::homogeneous(center * p.z + x * p.x + y * p.y, p.z));
            result.push_back(std::move(span));
        }
        return result;
    }
    std::vector<UnitArc> arcs(const typename D::Hyperbola&) const {
        return hyperbola_arcs(first_, last_);
    }
    template <class Closed>
    std::vector<UnitArc> arcs(const Closed&) const {
        return circle_arcs(first_, last_);
    }

    BezierSpan<P> bezier(const typename D::Bezier& c) const {
        BezierSpan<P> span;
        for (int i = 1; i <= c.NbPoles(); ++i)
            span.points.push_back(weighted(c.Pole(i).Coord(), c.IsRational() ? c.Weight(i) : 1));
        return span;
    }

    std::vector<CurveSpan<P>> bspline(opencascade::handle<typename D::BSpline> c) const {
        const double period = c->IsPeriodic() ? c->Period() : 0;
        if (c->IsPeriodic()) {
            c = opencascade::handle<typename D::BSpline>::DownCast(c->Copy());
            c->SetNotPeriodic();
        }
        NurbsCurve<P> nurbs{c->Degree(), flat_knots(c->Knots(), c->Multiplicities()), {}};
        for (int i = 1; i <= c->NbPoles(); ++i)
            nurbs.points.push_back(
                weighted(c->Pole(i).Coord(), c->IsRational() ? c->Weight(i) : 1));
        return clipped(bezier_spans(std::move(nurbs)), period);
    }

    CurveSpans<P> approximation() const {
        const opencascade::handle<typename D::Trimmed> part =
            new typename D::Trimmed(curve_, first_, last_);
        const auto spline = D::to_bspline(part);
        if (spline.IsNull()) throw Error("", "", "a curve that cannot be converted");
        const Converter converter(CurveHandle(spline), spline->FirstParameter(),
                                  spline->LastParameter());
        CurveSpans<P> result = converter.spans();
        for (int i = 0; i <= 256; ++i) {
            const double t = first_ + (last_ - first_) * i / 256;
            result.approximated =
                std::max(result.approximated, (value(t) - converter.value(t)).length());
        }
        return result;
    }

    template <class Coordinates>
    static P weighted(const Coordinates& p, double weight) {
        return D::homogeneous(D::vector(p) * weight, weight);
    }

    /// The spans cut to [first, last]: repeated by whole periods, or, where there is no period,
    /// continued by the first and last span.
    std::vector<CurveSpan<P>> clipped(const std::vector<BezierSpan<P>>& spans,
                                      double period) const {
        const double begin = spans.front().begin, end = spans.back().end;
        const double slack = same_parameter * std::max(end - begin, last_ - first_);
        const PeriodRange turns(begin, end, first_ + slack, last_ - slack, period);
        std::vector<CurveSpan<P>> result;
        for (int turn = turns.first; turn <= turns.last; ++turn)
            for (const BezierSpan<P>& span : spans) {
                const double shift = turn * period;
                const bool open_begin = !(period > 0) && &span == &spans.front();
                const bool open_end = !(period > 0) && &span == &spans.back();
                const double from = open_begin ? first_ : std::max(first_, span.begin + shift);
                const double to = open_end ? last_ : std::min(last_, span.end + shift);
                if (to - from > slack) result.push_back(cut(span, shift, from, to, slack));
            }
        if (result.empty()) throw Error("", "", "a curve without extent");
        return result;
    }

    static CurveSpan<P> cut(const BezierSpan<P>& span, double shift, double from, double to,
                            double slack) {
        const double length = span.end - span.begin;
        double a = (from - shift - span.begin) / length, b = (to - shift - span.begin) / length;
        if (std::abs(a) * length <= slack) a = 0;
        if (std::abs(b - 1) * length <= slack) b = 1;
        return {{ParameterMap::Kind::affine, from, to},
                a == 0 && b == 1 ? span.points : bezier_segment(span.points, a, b)};
    }

    CurveHandle curve_;
    double first_, last_;
};

} // namespace

CurveSpans<Vec3> curve_spans(const opencascade::handle<Geom2d_Curve>& curve, double first,
                             double last) {
    return Converter<InPlane>(curve, first, last).spans();
}

CurveSpans<Vec4> curve_spans(const opencascade::handle<Geom_Curve>& curve, double first,
                             double last) {
    return Converter<InSpace>(curve, first, last).spans();
}

} // namespace keiko::cad
