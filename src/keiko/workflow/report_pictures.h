#pragma once

#include "keiko/film/film.h"
#include "keiko/inspect/inspection.h"
#include "keiko/placement/best_view.h"
#include "keiko/report/content/report.h"
#include "keiko/workflow/open_scene.h"

namespace keiko {

/// Markers of what the first screen shows, in a view: the number of each item whose place is in the
/// picture and not hidden by the body. A marker that would cover another one stands beside it.
std::vector<PictureMarker> markers_in(const Scene& scene, std::span<const ShownItem> items,
                                      const Camera& camera);

/// Zebra in the standing views that show most of the first faults, three at most, in the order of
/// the faults: with markers, and dots on the seams of faults that an eye resolves. `part`: what is
/// shown of the scene, with its picture size.
std::vector<ReportPicture> standing_pictures(const Scene& part, const Report& report,
                                             const Job& job = {});

/// A display picture for the report, which draws the markers itself.
ReportPicture report_picture(const std::string& title, const Image& display,
                             const std::vector<PictureMarker>& markers);

/// The display picture of a film with the markers drawn into it.
Image marked_image(const Film& film, const std::vector<PictureMarker>& markers);

/// Analysis pictures of a body, from the films of its views, which have the look_layers() of a
/// curvature. Each view has two pictures: the Gaussian curvature, by one scale for all, with the
/// visible inflection curves, and zebra.
std::vector<ReportPicture> curvature_pictures(std::span<const NamedView> views,
                                              std::span<const std::pair<std::string, Film>> films,
                                              const Inspection& inspection);

} // namespace keiko
