#include "keiko/light/luminance/gloss_kernel.h"

#include <algorithm>
#include <cmath>

namespace keiko {
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
