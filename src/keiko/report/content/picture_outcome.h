#pragma once

#include "keiko/base/export.h"
#include "keiko/compare/outlines/film_difference.h"
#include "keiko/report/markup/junit_suites.h"

#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Difference of two pictures of a view, prepared for reports.
struct PictureOutcome {
    std::string view;                                           ///< name of the view
    std::string problem{};                                      ///< as PictureDifference::problem
    std::size_t pixels = 0, coverage_flips = 0, face_flips = 0; ///< as FilmDifference
    bool flips_within = true;                                   ///< as FilmDifference::flips_within
    std::vector<LayerDifference> layers{};                      ///< as FilmDifference::layers
    int width = 0, height = 0;                                  ///< pixels
    /// Names of the PNG files of the pictures before, after, and of their difference; empty if
    /// there is none.
    std::string before{}, after{}, difference{};

    /// Copies the numbers of a difference.
    void take(const FilmDifference& found);
    /// True if the pictures were compared and are within the tolerances.
    bool within() const;
};

/// The numbers of a view's layers as an HTML table with a line about its silhouette.
std::string html_layers(const PictureOutcome& picture);

/// Adds a case for the silhouette and for each layer, or one for the problem.
void add_picture_cases(const PictureOutcome& picture, const std::string& class_name,
                       JunitSuite& suite);

} // namespace keiko
