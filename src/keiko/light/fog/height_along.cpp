#include "keiko/light/fog/height_along.h"

#include "keiko/math/sincos_2pi.h"

#include <cmath>
#include <numbers>

namespace keiko {

HeightAlong::HeightAlong(const HeightField& field, const Segment& segment)
    : start_(segment.a.z - field.height),
      rise_(segment.b.z - segment.a.z),
      count_(2 * field.waves.size()),
      numbers_(6 * count_) {
    const Vec3 way = segment.b - segment.a;
    std::size_t next = 0;
    // A product of two sines is a difference of two cosines.
    const auto add = [&](double amplitude, double phase, double turn) {
        amplitudes()[next] = amplitude, phases()[next] = phase, turns()[next] = turn;
        const double k = 2 * std::numbers::pi * turn;
        bend_ += std::abs(amplitude) * k * k;
        ++next;
    };
    for (const Wave& wave : field.waves) {
        const Vec2 start = wave.turns(segment.a.x, segment.a.y);
        const double x = way.x / wave.wavelength.x, y = way.y / wave.wavelength.y;
        add(wave.amplitude / 2, start.x - start.y, x - y);
        add(-wave.amplitude / 2, start.x + start.y, x + y);
    }
}

HeightAlong::Value HeightAlong::at(double t) const {
    const auto places = column(3), cosines = column(4), sines = column(5);
    for (std::size_t i = 0; i < count_; ++i) places[i] = phases()[i] + turns()[i] * t;
    sincos_2pi(places, cosines, sines);
    double height = 0, slope = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        height += amplitudes()[i] * cosines[i];
        slope += amplitudes()[i] * turns()[i] * sines[i];
    }
    return {start_ + rise_ * t - height, rise_ + 2 * std::numbers::pi * slope};
}

} // namespace keiko
