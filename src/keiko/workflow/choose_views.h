#pragma once

#include "keiko/base/export.h"
#include "keiko/placement/best_view.h"
#include "keiko/workflow/open_scene.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Views of the pictures of a scene. Names are those of standard views, "auto" for the view that
/// shows the body best, "scene" for the scene file's own and NAME.toml for a view file; those of
/// the scene's analysis come before them. Without names: all views of the analysis, or else the
/// scene's own, or else `automatic` views from different sides, the best first. Throws Error for an
/// unknown name.
std::vector<NamedView> choose_views(const Scene& scene, std::span<const std::string> names,
                                    int automatic, const Job& job = {});

/// Views of pictures of another size than the scene's, in pixels.
std::vector<NamedView> choose_views(const Scene& scene, std::span<const std::string> names,
                                    int automatic, int width, int height, const Job& job = {});

/// Throws Error, before the long work, for a name that choose_views would refuse for any scene, or
/// a view file that it could not read. Views of `analysis` may be named, too.
void require_view_names(std::span<const std::string> names,
                        const std::optional<Analysis>& analysis = {});

/// Throws Error if two views have the same name, by which pictures are named.
void require_different_names(std::span<const NamedView> views);

} // namespace keiko
