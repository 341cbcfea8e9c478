#pragma once

#include "keiko/base/error.h"
#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/radiosity/radiosity_solution.h"
#include "keiko/workflow/open_scene.h"

#include <filesystem>
#include <memory>
#include <string>

namespace KEIKO_API keiko {

/// Light that the diffuse surfaces of a scene reflect onto each other under its rig
/// (docs/theory/radiosity.md), divided as `scene.radiosity` says. Glass is left out,
/// and so are maps of reflectances, the environment and volumes. Its `deviation` must be below half
/// of the thinnest sheet, or else elements of both skins may cross. The scene must have been opened
/// with shadows. A stop of the job while light is shot ends it early, with a solution whose
/// `remaining` says so. Throws Error for a scene without lamps and for one with a material that
/// reflects all light, FieldError for one that needs too many elements, and Cancelled for a stop
/// before light is shot.
RadiositySolution solve_radiosity(const Scene& scene, const Job& job = {});

/// Warnings of what a scene has that solve_radiosity() leaves out: maps of reflectances, an
/// environment that lights, volumes.
Diagnostics radiosity_remarks(const Scene& scene);

/// Writes a solution (keiko-solution/1) as a whole or not at all. Throws Error, also for one whose
/// `remaining` is not finite.
void write_solution(const std::filesystem::path& path, const RadiositySolution& solution);

/// Solution of such a file. Throws Error for a file that is none.
RadiositySolution read_solution(const std::filesystem::path& path);

/// Reflected light of a solution in its scene, at the levels of a rig's lamps. No form factor is
/// computed. Throws Error naming `source`, the solution, if it is of other geometry, other
/// reflectances, or lamps that differ from those of the rig in more than levels.
std::shared_ptr<const ReflectedLight> reflected_light(const Scene& scene, const LightRig& rig,
                                                      const RadiositySolution& solution,
                                                      const std::string& source);

/// Gives a scene the reflected light of a solution, at the levels of its own lamps. Throws as
/// reflected_light, and for a scene without lamps.
void take_solution(Scene& scene, const RadiositySolution& solution, const std::string& source);

} // namespace keiko
