#include "trim_tracer.h"

#include "bernstein_fit.h"

#include <algorithm>
#include <cmath>

namespace keiko::fixtures {
namespace {

constexpr int kPieceDegree = 9;
/// Pieces whose images on the skins lie further apart are halved, in mm.
constexpr double kMostDeviation = 1e-5;
constexpr int kMostHalvings = 4;
constexpr int kMarchSteps = 600;
/// In skin parameters; crossings are found to rounding, so this only tells them from their kin.
constexpr double kSnap = 1e-9;

struct Sample {
    double tau;
    TrimPoint point;
};

std::vector<Sample> march(const TrimPath& path, double first, double last, const TrimPoint& start) {
    std::vector<Sample> samples{{first, path(first, start)}};
    for (int i = 1; i <= kMarchSteps; ++i) {
        const double tau = i == kMarchSteps ? last : first + (last - first) * i / kMarchSteps;
        samples.push_back({tau, path(tau, samples.back().point)});
    }
    return samples;
}

double component(const TrimPoint& point, std::size_t skin, int axis) {
    return point.uv[skin].Coord(axis + 1);
}

/// Sample between two others at which the component reaches `level`, bisected down to rounding.
Sample crossing(const TrimPath& path, Sample low, Sample high, std::size_t skin, int axis,
                double level) {
    const bool rising = component(high.point, skin, axis) > level;
    for (int i = 0; i < 60; ++i) {
        const double tau = 0.5 * (low.tau + high.tau);
        const Sample middle{tau, path(tau, low.point)};
        const bool beyond = (component(middle.point, skin, axis) > level) == rising;
        (beyond ? high : low) = middle;
    }
    high.point.uv[skin].SetCoord(axis + 1, level);
    return high;
}

void append_crossings(const TrimPath& path, const Sample& a, const Sample& b, std::size_t skin,
                      int axis, std::vector<Sample>& cuts) {
    const double from = component(a.point, skin, axis);
    const double to = component(b.point, skin, axis);
    const double low = std::min(from, to);
    const double high = std::max(from, to);
    for (double level = std::ceil(low + kSnap); level <= high - kSnap; level += 1.0)
        cuts.push_back(crossing(path, a, b, skin, axis, level));
}

void snap(TrimPoint& point) {
    for (gp_XY& uv : point.uv)
        for (int axis = 1; axis <= 2; ++axis)
            if (std::abs(uv.Coord(axis) - std::round(uv.Coord(axis))) < kSnap)
                uv.SetCoord(axis, std::round(uv.Coord(axis)));
}

/// Ends of all pieces in order, both ends of the curve included.
std::vector<Sample> cut_points(const TrimPath& path, const std::vector<Sample>& samples,
                               std::size_t skins) {
    std::vector<Sample> cuts{samples.front()};
    for (std::size_t i = 1; i < samples.size(); ++i) {
        std::vector<Sample> found;
        for (std::size_t skin = 0; skin < skins; ++skin)
            for (int axis = 0; axis < 2; ++axis)
                append_crossings(path, samples[i - 1], samples[i], skin, axis, found);
        std::stable_sort(found.begin(), found.end(),
                         [](const Sample& a, const Sample& b) { return a.tau < b.tau; });
        cuts.insert(cuts.end(), found.begin(), found.end());
    }
    cuts.push_back(samples.back());
    for (Sample& cut : cuts) snap(cut.point);
    return cuts;
}

template <typename Vector>
std::vector<Vector> fitted(const std::vector<Vector>& samples, int dimension) {
    std::vector<Vector> poles(samples.size());
    for (int axis = 1; axis <= dimension; ++axis) {
        std::vector<double> values;
        for (const Vector& sample : samples) values.push_back(sample.Coord(axis));
        const std::vector<double> coefficients = bernstein_fit(values);
        for (std::size_t k = 0; k < poles.size(); ++k) poles[k].SetCoord(axis, coefficients[k]);
    }
    return poles;
}

template <typename Vector>
Vector casteljau(std::vector<Vector> poles, double t) {
    for (std::size_t n = poles.size(); n > 1; --n)
        for (std::size_t k = 0; k + 1 < n; ++k) poles[k] = poles[k] * (1.0 - t) + poles[k + 1] * t;
    return poles.front();
}

void settle(TrimPiece& piece, const std::vector<const Skin*>& skins) {
    constexpr int kChecks = 40;
    for (std::size_t skin = 0; skin < skins.size(); ++skin) {
        piece.cells.push_back(skins[skin]->cell_of(casteljau(piece.uv_poles[skin], 0.5)));
        for (int i = 0; i <= kChecks; ++i) {
            const double t = static_cast<double>(i) / kChecks;
            const gp_XYZ on_curve = casteljau(piece.poles, t);
            const gp_XY uv = casteljau(piece.uv_poles[skin], t);
            const gp_XYZ on_skin = skins[skin]->evaluate(uv).position;
            piece.deviation = std::max(piece.deviation, (on_curve - on_skin).Modulus());
        }
    }
}

TrimPiece piece_between(const TrimPath& path, const Sample& from, const Sample& to,
                        const std::vector<const Skin*>& skins) {
    std::vector<TrimPoint> points;
    for (const double t : fit_parameters(kPieceDegree))
        points.push_back(path(from.tau + (to.tau - from.tau) * t, from.point));
    points.front() = from.point;
    points.back() = to.point;
    TrimPiece piece;
    std::vector<gp_XYZ> positions;
    for (const TrimPoint& point : points) positions.push_back(point.position);
    piece.poles = fitted(positions, 3);
    for (std::size_t skin = 0; skin < skins.size(); ++skin) {
        std::vector<gp_XY> uv;
        for (const TrimPoint& point : points) uv.push_back(point.uv[skin]);
        piece.uv_poles.push_back(fitted(uv, 2));
    }
    settle(piece, skins);
    return piece;
}

void append_pieces(TrimCurve& curve, const TrimPath& path, const Sample& from, const Sample& to,
                   const std::vector<const Skin*>& skins, int halvings) {
    const TrimPiece piece = piece_between(path, from, to, skins);
    if (piece.deviation < kMostDeviation || halvings == kMostHalvings) {
        curve.push_back(piece);
        return;
    }
    const double tau = 0.5 * (from.tau + to.tau);
    const Sample middle{tau, path(tau, from.point)};
    append_pieces(curve, path, from, middle, skins, halvings + 1);
    append_pieces(curve, path, middle, to, skins, halvings + 1);
}

} // namespace

gp_XYZ point_on(const TrimPiece& piece, double t) {
    return casteljau(piece.poles, t);
}

TrimCurve trace(const TrimPath& path, double first, double last, const TrimPoint& start,
                const std::vector<const Skin*>& skins) {
    const std::vector<Sample> cuts =
        cut_points(path, march(path, first, last, start), skins.size());
    TrimCurve curve;
    for (std::size_t i = 1; i < cuts.size(); ++i)
        // Two skins crossed at once leave a cut twice.
        if (std::abs(cuts[i].tau - cuts[i - 1].tau) > kSnap * std::abs(last - first))
            append_pieces(curve, path, cuts[i - 1], cuts[i], skins, 0);
    return curve;
}

TrimCurve mirrored(const TrimCurve& curve,
                   const std::vector<std::function<gp_XY(gp_XY)>>& mirror_uv,
                   const std::vector<const Skin*>& skins) {
    TrimCurve mirror;
    for (auto piece = curve.rbegin(); piece != curve.rend(); ++piece) {
        TrimPiece image;
        for (auto pole = piece->poles.rbegin(); pole != piece->poles.rend(); ++pole)
            image.poles.emplace_back(pole->X(), -pole->Y(), pole->Z());
        for (std::size_t skin = 0; skin < mirror_uv.size(); ++skin) {
            std::vector<gp_XY> uv;
            for (auto pole = piece->uv_poles[skin].rbegin(); pole != piece->uv_poles[skin].rend();
                 ++pole)
                uv.push_back(mirror_uv[skin](*pole));
            image.uv_poles.push_back(uv);
        }
        settle(image, skins);
        mirror.push_back(image);
    }
    return mirror;
}

TrimCurve with_mirror_image(TrimCurve right,
                            const std::vector<std::function<gp_XY(gp_XY)>>& mirror_uv,
                            const std::vector<const Skin*>& skins) {
    right.front().poles.front().SetY(0.0);
    right.back().poles.back().SetY(0.0);
    const TrimCurve left = mirrored(right, mirror_uv, skins);
    right.insert(right.end(), left.begin(), left.end());
    return right;
}

bool encloses(const TrimCurve& curve, std::size_t side, gp_XY uv) {
    bool inside = false;
    for (const TrimPiece& piece : curve)
        for (std::size_t k = 1; k < piece.uv_poles[side].size(); ++k) {
            // The control polygon is close enough to the curve for points clear of it.
            const gp_XY a = piece.uv_poles[side][k - 1] - uv;
            const gp_XY b = piece.uv_poles[side][k] - uv;
            if ((a.Y() > 0.0) == (b.Y() > 0.0)) continue;
            const double crossing = a.X() - a.Y() * (b.X() - a.X()) / (b.Y() - a.Y());
            if (crossing > 0.0) inside = !inside;
        }
    return inside;
}

} // namespace keiko::fixtures
