#include "keiko/light/luminance/gloss_kernel.h"

#include "keiko/math/quadrature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {

namespace {

using std::numbers::pi;

/// 1 / (2 pi) over the integral of exp(-(alpha / m)^2) sin cos up to pi / 2.
double gauss_peak(double m) {
    const auto f = [m](double alpha) {
        return std::exp(-(alpha / m) * (alpha / m)) * std::sin(alpha) * std::cos(alpha);
    };
    // Beyond 7 m the integrand is negligible.
    const double end = std::min(pi / 2, 7 * m), middle = std::min(end, 2 * m);
    return 1 / (2 * pi * (integrate(f, 0, middle, 48) + integrate(f, middle, end, 48)));
}

double peak_of(DistributionKind kind, double width) {
    switch (kind) {
        case DistributionKind::phong:
            return (width + 1) / (2 * pi);
        case DistributionKind::blinn:
            return (width + 2) / (2 * pi);
        case DistributionKind::gauss:
            return gauss_peak(width);
        case DistributionKind::trowbridge_reitz:
        case DistributionKind::beckmann:
            return 1 / (pi * width * width);
    }
    return 0;
}

} // namespace

Distribution::Distribution(DistributionKind kind, double width)
    : kind_(kind), width_(width), scale_(peak_of(kind, width)) {}

double Distribution::density(double cosine, double sine2) const {
    if (!(cosine > 0)) return 0;
    const double cosine2 = cosine * cosine, w2 = width_ * width_;
    switch (kind_) {
        case DistributionKind::phong:
        case DistributionKind::blinn:
            return scale_ * std::exp(width_ / 2 * std::log1p(-std::min(sine2, 1.0)));
        case DistributionKind::gauss: {
            const double alpha = std::atan2(std::sqrt(sine2), cosine);
            return scale_ * std::exp(-alpha * alpha / w2);
        }
        case DistributionKind::trowbridge_reitz: {
            const double ratio = w2 / (sine2 + w2 * cosine2);
            return scale_ * ratio * ratio;
        }
        case DistributionKind::beckmann:
            return scale_ * std::exp(-sine2 / (cosine2 * w2)) / (cosine2 * cosine2);
    }
    return 0;
}

double Distribution::spread() const {
    switch (kind_) {
        case DistributionKind::phong:
            return std::sqrt(2 / (width_ + 1));
        case DistributionKind::blinn:
            return 2 * std::sqrt(2 / (width_ + 2));
        default:
            return 2 * width_;
    }
}

double Distribution::cone(double share) const {
    const double w2 = width_ * width_;
    switch (kind_) {
        case DistributionKind::phong:
            return std::acos(std::pow(share, 1 / width_));
        case DistributionKind::blinn:
            return 2 * std::acos(std::pow(share, 1 / width_));
        case DistributionKind::gauss:
            return 2 * width_ * std::sqrt(-std::log(share));
        case DistributionKind::trowbridge_reitz: {
            const double sine2 = w2 * (1 / std::sqrt(share) - 1) / (1 - w2);
            return w2 < 1 && sine2 < 1 ? 2 * std::asin(std::sqrt(sine2)) : pi;
        }
        case DistributionKind::beckmann:
            // 1 / cos^4 lifts the tail: with t = tan^2, (1 + t)^2 exp(-t / m^2) = share.
            for (double t = -w2 * std::log(share), next = 0;; t = next) {
                next = w2 * (2 * std::log1p(t) - std::log(share));
                if (std::abs(next - t) < 1e-3 * t) return 2 * std::atan(std::sqrt(next));
                if (!(next < 1e3)) return pi;
            }
    }
    return pi;
}

namespace {

/// Smith's Lambda of the Trowbridge-Reitz distribution of width c.
double smith_lambda(double cosine, double c) {
    const double cosine2 = cosine * cosine;
    const double tangent2 = std::max(0.0, 1 - cosine2) / cosine2;
    return (std::sqrt(1 + c * c * tangent2) - 1) / 2;
}

} // namespace

GlossKernel::GlossKernel(const Gloss& gloss, const Vec3& normal, const Vec3& eye)
    : gloss_(gloss),
      normal_(normal),
      eye_(eye),
      peak_(reflect(-eye, normal)),
      nv_(normal.dot(eye)),
      outside_(gloss.mode == GlossMode::lobe ? gloss.reflectance(nv_) : Rgb(1 / (4 * nv_))) {}

double GlossKernel::shaded(double nh, double nl, double vh) const {
    switch (gloss_.shadowing) {
        case Shadowing::none:
            return 1;
        case Shadowing::cavities:
            return std::min(1.0, 2 * nh * std::min(nv_, nl) / vh);
        case Shadowing::smith: {
            const double c = gloss_.distribution.width();
            return 1 / (1 + smith_lambda(nv_, c) + smith_lambda(nl, c));
        }
    }
    return 1;
}

LobeChart GlossKernel::chart() const {
    return gloss_.distribution.of_half_vectors() ? LobeChart(peak_, spread(), normal_, eye_)
                                                 : LobeChart(peak_, spread());
}

Rgb GlossKernel::operator()(const Vec3& light) const {
    const double nl = normal_.dot(light);
    if (!(nl > 0) || !(nv_ > 0)) return {};
    if (!gloss_.distribution.of_half_vectors())
        return outside_ *
               gloss_.distribution.density(peak_.dot(light), peak_.cross(light).length2());
    const Vec3 sum = light + eye_;
    const double length2 = sum.length2(), length = std::sqrt(length2);
    const double nh = (nl + nv_) / length, vh = length / 2;
    const double density = gloss_.distribution.density(nh, normal_.cross(sum).length2() / length2);
    if (gloss_.mode == GlossMode::lobe) return outside_ * (density * nh / (4 * vh));
    return outside_ * gloss_.reflectance(vh) * (density * shaded(nh, nl, vh));
}

} // namespace keiko
