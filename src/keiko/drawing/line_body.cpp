#include "keiko/drawing/line_body.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/drawing/curves/body_edges.h"
#include "keiko/drawing/curves/outlines.h"
#include "keiko/drawing/hidden/curve_pieces.h"
#include "keiko/drawing/hidden/piercings.h"

#include <cmath>

namespace keiko {

struct LineBody::Edges {
    Edges(const SurfaceModel& model, const BodyEdgeOptions& options, const Tracer& tracer,
          const Job& job)
        : body(model, options, job), pierced(find_piercings(body.curves(), tracer, job)) {}

    BodyEdges body;
    std::vector<ModelCurve> pierced; ///< curves of the body
};

namespace {

void require_before_eye(const Camera& camera, const ImageProjection& projection, const Box3& box) {
    if (projection.parallel()) return;
    constexpr double nearest = 1e-3; // of the body's size
    for (int i = 0; i < 8; ++i) {
        const Vec3 corner(i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                          i & 4 ? box.upper.z : box.lower.z);
        if (!((corner - camera.eye).dot(projection.axes().forward) > nearest * box.size()))
            throw Error("", "view",
                        "has its eye within the body or beside it: a drawing in "
                        "perspective needs all of the body before the eye");
    }
}

Stroke stroke_of(const ModelCurve& curve, const CurvePiece& piece,
                 const ImageProjection& projection) {
    Stroke stroke{piece.contour ? CurveKind::outline : curve.kind, piece.visible};
    const auto add = [&](double t) {
        stroke.points.push_back(projection.image(curve.course.at(t)).at);
    };
    add(piece.begin);
    for (double t = std::floor(piece.begin) + 1; t < piece.end; ++t) add(t);
    add(piece.end);
    return stroke;
}

} // namespace

LineBody::LineBody(const SurfaceModel& model, const Tracer& tracer, const LineBodyOptions& options,
                   const Job& job)
    : model_(model),
      tracer_(tracer),
      chord_error_(options.chord_error * tracer.bounds().size()),
      edges_(std::make_unique<const Edges>(
          model, BodyEdgeOptions{options.join, options.crease_angle, chord_error_}, tracer, job)) {}

LineBody::~LineBody() = default;

double LineBody::chord_error() const {
    return chord_error_;
}

std::vector<Stroke> LineBody::parts(const Camera& camera, std::span<const ModelCurve> others,
                                    bool wireframe, const Job& job) const {
    const ImageProjection projection(camera);
    require_before_eye(camera, projection, tracer_.bounds());
    Outlines outlines = find_outlines(model_, LineEye(camera), chord_error_, job);
    const SightTest sight(model_, tracer_, projection);
    const OccluderImage image(projection, edges_->body.occluding(), outlines.occluding,
                              sight.size(), chord_error_);
    if (!wireframe) outlines.curves = find_piercings(std::move(outlines.curves), tracer_, job);
    std::vector<const ModelCurve*> curves;
    for (const std::span<const ModelCurve> some :
         {std::span<const ModelCurve>(edges_->pierced),
          std::span<const ModelCurve>(outlines.curves), others})
        for (const ModelCurve& curve : some) curves.push_back(&curve);
    std::vector<std::vector<Stroke>> found(curves.size());
    parallel_for(curves.size(), job, "hidden lines", [&](std::size_t i) {
        const ModelCurve& curve = *curves[i];
        const std::vector<CurvePiece> pieces =
            wireframe ? std::vector<CurvePiece>{{0, curve.course.end()}}
                      : pieces_by_rays(curve, image.along(curve), sight);
        for (const CurvePiece& piece : pieces)
            found[i].push_back(stroke_of(curve, piece, projection));
    });
    std::vector<Stroke> strokes;
    for (std::vector<Stroke>& of_curve : found)
        std::move(of_curve.begin(), of_curve.end(), std::back_inserter(strokes));
    return strokes;
}

std::vector<Stroke> LineBody::strokes(const Camera& camera, std::span<const ModelCurve> others,
                                      bool wireframe, const Job& job) const {
    return joined_strokes(parts(camera, others, wireframe, job));
}

std::vector<bool> LineBody::visible(const Camera& camera, std::span<const Vec3> places) const {
    const ImageProjection projection(camera);
    ModelCurve anywhere;
    for (const PlacedFace& face : placed_faces(model_)) anywhere.faces.push_back(face);
    std::vector<bool> visible;
    for (const PointSight& sight : SightTest(model_, tracer_, projection).sights(places, anywhere))
        visible.push_back(sight.visible);
    return visible;
}

} // namespace keiko
