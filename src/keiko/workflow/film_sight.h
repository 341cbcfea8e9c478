#pragma once

#include "keiko/film/film.h"
#include "keiko/scene/camera.h"
#include "keiko/workflow/analysis_mode.h"

#include <cmath>
#include <optional>
#include <vector>

namespace keiko {

/// Surface at a pixel's centre.
struct Seen {
    Vec3 place, ray, normal; ///< world, mm; unit; unit and towards the viewpoint
    bool turned = false;     ///< the layer's normal points away from the viewpoint
    /// Cosine of the angle between the normal and the way to the viewpoint, 0 to 1.
    double facing() const { return -normal.dot(ray); }
};

/// Body as a film with the look_layers() of a mode shows it, pixel by pixel.
class FilmSight {
public:
    /// `ground`: number of a face that is no part of the body. Film and camera must outlive it.
    FilmSight(const Film& film, const Camera& camera, std::optional<int> ground)
        : film_(film), camera_(camera), ground_(ground) {}

    int width() const { return film_.color.width; }
    int height() const { return film_.color.height; }
    /// Number of the face in the film; -1 without a surface.
    float face(int x, int y) const { return *film_.aovs.at(Aov::face).pixel(x, y); }
    /// Share of the pixel that shows a surface.
    double alpha(int x, int y) const { return double{*film_.alpha.pixel(x, y)}; }
    /// True if the pixel's centre shows the body.
    bool is_body(int x, int y) const {
        return face(x, y) >= 0 && !(ground_ && static_cast<int>(face(x, y)) == *ground_);
    }
    /// Channels of a layer.
    const float* layer(Aov aov, int x, int y) const { return film_.aovs.at(aov).pixel(x, y); }
    /// Surface at the pixel's centre; nullopt without one.
    std::optional<Seen> at(int x, int y) const;

private:
    const Film& film_;
    const Camera& camera_;
    std::optional<int> ground_;
};

/// One number a pixel, and its change from pixel to pixel on one face or patch.
class PixelValues {
public:
    /// `of(x, y)` is the pixel's number; NaN without one. Numbers change smoothly where the layer
    /// `within` is the same. `sight` must outlive it.
    template <class F>
    PixelValues(const FilmSight& sight, const F& of, Aov within = Aov::face)
        : sight_(sight), within_(within) {
        for (int y = 0; y < sight.height(); ++y)
            for (int x = 0; x < sight.width(); ++x) values_.push_back(of(x, y));
    }

    /// Row by row from the top.
    const std::vector<double>& all() const { return values_; }
    /// The pixel's number.
    double at(int x, int y) const {
        return values_[static_cast<std::size_t>(y) * static_cast<std::size_t>(sight_.width()) +
                       static_cast<std::size_t>(x)];
    }
    /// Half of the range of values over the pixel, by its slopes in x and y.
    double reach(int x, int y) const { return (slope(x, y, 1, 0) + slope(x, y, 0, 1)) / 2; }
    /// Length of the gradient, per pixel.
    double gradient(int x, int y) const { return std::hypot(slope(x, y, 1, 0), slope(x, y, 0, 1)); }

private:
    bool is_continued(int x, int y, int other_x, int other_y) const;
    /// Change from a pixel to the next, the smaller one of either side: the other may be beyond a
    /// fold.
    double slope(int x, int y, int dx, int dy) const;

    const FilmSight& sight_;
    Aov within_;
    std::vector<double> values_;
};

/// Picture of display colours: `color(x, y, seen)` where a surface is seen, shaded by how it faces
/// the eye, and a dark backdrop, mixed by the share of the pixel that each covers.
template <class F>
Image shaded_picture(const FilmSight& sight, const F& color) {
    const Rgb backdrop(0.07);
    Image picture(sight.width(), sight.height(), 3);
    for (int y = 0; y < sight.height(); ++y)
        for (int x = 0; x < sight.width(); ++x) {
            const auto seen = sight.at(x, y);
            const double alpha = seen ? sight.alpha(x, y) : 0;
            const Rgb own = seen ? color(x, y, *seen) * (0.55 + 0.45 * seen->facing()) : backdrop;
            const Rgb mixed = own * alpha + backdrop * (1 - alpha);
            float* pixel = picture.pixel(x, y);
            pixel[0] = static_cast<float>(mixed.r);
            pixel[1] = static_cast<float>(mixed.g);
            pixel[2] = static_cast<float>(mixed.b);
        }
    return picture;
}

/// The picture with a line of words at its lower left, broken where it is too long.
Image with_caption(Image picture, const std::string& words);

} // namespace keiko
