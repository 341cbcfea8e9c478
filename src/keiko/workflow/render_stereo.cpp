#include "keiko/workflow/render_stereo.h"

#include "keiko/base/job_steps.h"
#include "keiko/film/stereo_film.h"

namespace keiko {

Film render_stereo(const Scene& scene, const LightRig& rig, const Camera& camera,
                   const Stereo& stereo, StereoLayout layout, const PictureOptions& options,
                   const Job& job) {
    const StereoPair eyes = stereo_pair(camera, stereo);
    JobSteps steps(job, 2);
    const Film left = render_view(scene, rig, eyes.left, options, steps.next(1));
    const Film right = render_view(scene, rig, eyes.right, options, steps.next(1));
    return layout == StereoLayout::anaglyph ? anaglyph(left, right) : side_by_side(left, right);
}

} // namespace keiko
