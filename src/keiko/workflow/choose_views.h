#pragma once

#include "keiko/placement/best_view.h"
#include "keiko/workflow/open_scene.h"

#include <span>
#include <string>
#include <vector>

namespace keiko {

/// A picture to be made: the views asked for by name, "auto" being the one that shows the body
/// best, "scene" the scene file's own and NAME.toml that of a view file. No names: the scene's own,
/// or else `automatic` views from different sides, the best first. Throws Error for an unknown
/// name.
std::vector<NamedView> choose_views(const Scene& scene, std::span<const std::string> names,
                                    int automatic, const Job& job = {});

/// Throws Error for a name that choose_views would refuse for any scene, or a view file that it
/// could not read: before the long work.
void require_view_names(std::span<const std::string> names);

/// Pictures are named after views. Throws Error where two have the same name.
void require_different_names(std::span<const NamedView> views);

} // namespace keiko
