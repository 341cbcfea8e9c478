#pragma once

#include "keiko/light/areas/area_gloss.h"
#include "keiko/light/sky/sky_panels.h"
#include "keiko/math/rgb.h"

namespace keiko {

/// A lobe's kernel (GlossKernel, FlakeKernel) times the luminance of a panel of the sky, as a share
/// of that at the zenith or of the ground's: with SkyWidth, what AreaGloss integrates.
template <class Kernel>
class SkyKernel {
public:
    /// References are kept.
    SkyKernel(const Kernel& kernel, const SkyWidth& width) : kernel_(kernel), width_(width) {}

    /// 1/sr for the unit direction that light comes from.
    Rgb operator()(const Vec3& towards) const {
        return kernel_(towards) * width_.luminance(towards);
    }
    /// Unit direction of the lobe's middle.
    const Vec3& peak() const { return kernel_.peak(); }
    /// Chart in which the lobe is a round bell.
    LobeChart chart() const { return kernel_.chart(); }
    /// Half angle in radians of the cone about the peak beyond which the kernel is below `share` of
    /// its value there, however bright the sky is.
    double cone(double share) const {
        return kernel_.cone(share * width_.luminance(kernel_.peak()) / width_.brightest());
    }

private:
    const Kernel& kernel_;
    const SkyWidth& width_;
};

} // namespace keiko
