#pragma once

#include <array>

namespace keiko {

/// How something changes with the picture's x and y, per pixel.
template <class Jet>
struct Slopes {
    Jet x, y;
};

/// Something smooth in a picture as a cubic in the place around a pixel's centre: by Taylor's
/// theorem from its value there and its slopes there and at the centres of four neighbours. `Jet`:
/// the value, or a derivative of it; it has +, - and * by a number.
template <class Jet>
class CubicFootprint {
public:
    CubicFootprint(const Jet& value, const Slopes<Jet>& centre, const Slopes<Jet>& left,
                   const Slopes<Jet>& right, const Slopes<Jet>& above, const Slopes<Jet>& below)
        : value_(value),
          x_(centre.x),
          y_(centre.y),
          xx_((right.x - left.x) * 0.5),
          xy_((below.x - above.x + right.y - left.y) * 0.25),
          yy_((below.y - above.y) * 0.5),
          xxx_(right.x - x_ * 2 + left.x),
          xxy_(right.y - y_ * 2 + left.y),
          xyy_(below.x - x_ * 2 + above.x),
          yyy_(below.y - y_ * 2 + above.y) {}

    /// At a place relative to the centre, in pixels.
    Jet at(double x, double y) const {
        return value_ + x_ * x + y_ * y + xx_ * (x * x / 2) + xy_ * (x * y) + yy_ * (y * y / 2) +
               xxx_ * (x * x * x / 6) + xxy_ * (x * x * y / 2) + xyy_ * (x * y * y / 2) +
               yyy_ * (y * y * y / 6);
    }
    /// At the pixel's corners, row by row.
    std::array<Jet, 4> corners() const {
        const Jet even = value_ + (xx_ + yy_) * (1.0 / 8), twisted = xy_ * (1.0 / 4);
        const Jet across = x_ * 0.5 + xxx_ * (1.0 / 48) + xyy_ * (1.0 / 16);
        const Jet along = y_ * 0.5 + yyy_ * (1.0 / 48) + xxy_ * (1.0 / 16);
        const Jet up = even - along, down = even + along;
        return {up + twisted - across, up - twisted + across, down - twisted - across,
                down + twisted + across};
    }
    Slopes<Jet> slopes(double x, double y) const {
        return {x_ + xx_ * x + xy_ * y + xxx_ * (x * x / 2) + xxy_ * (x * y) + xyy_ * (y * y / 2),
                y_ + xy_ * x + yy_ * y + xxy_ * (x * x / 2) + xyy_ * (x * y) + yyy_ * (y * y / 2)};
    }

private:
    Jet value_, x_, y_, xx_, xy_, yy_, xxx_, xxy_, xyy_, yyy_;
};

} // namespace keiko
