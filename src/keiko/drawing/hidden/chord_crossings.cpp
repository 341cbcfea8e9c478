#include "keiko/drawing/hidden/chord_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace keiko {
namespace {

constexpr int most_halvings = 2; ///< a bulge is then a 16th

/// A part of a curve and its chord in the image.
struct Chord {
    double begin = 0, end = 0; ///< parameters of the curve
    ImagePoint a, b;           ///< there

    double nearest() const { return std::min(a.depth, b.depth); }
    double farthest() const { return std::max(a.depth, b.depth); }
    /// Distance of an image point from the chord's line, with a sign.
    double side(const Vec2& point) const {
        const Vec2 along = b.at - a.at;
        const double length = along.length();
        return length > 0 ? along.cross(point - a.at) / length : 0;
    }
};

/// Distances of the ends of one chord from the line of another one, with signs.
struct Sides {
    double first, second;

    /// A point on the line always counts to one side, so that a chain of chords that touches a line
    /// crosses it once or not at all.
    bool differ() const { return (first < 0) != (second < 0); }
    bool are_clear(double bulge) const {
        return std::abs(first) > bulge && std::abs(second) > bulge;
    }
    bool exclude(double bulge) const { return !differ() && are_clear(bulge); }
    bool are_within(double distance) const {
        return std::abs(first) < distance && std::abs(second) < distance;
    }
};

class Search {
public:
    Search(const CurveCourse& a, const CurveCourse& b, const ImageProjection& projection,
           const CrossingLimits& limits)
        : a_(a), b_(b), projection_(projection), limits_(limits) {}

    Chord chord(const CurveCourse& curve, std::size_t i) const {
        const auto begin = static_cast<double>(i);
        return {begin, begin + 1, projection_.image(curve.points[i]),
                projection_.image(curve.points[i + 1])};
    }

    void run(const Chord& a, const Chord& b, int halvings) {
        const double bulge = 2 * limits_.bulge / std::pow(4, halvings); // of both chords
        if (!(a.farthest() - b.nearest() > limits_.least) || are_apart(a, b, bulge)) return;
        const Sides of_b{a.side(b.a.at), a.side(b.b.at)}, of_a{b.side(a.a.at), b.side(a.b.at)};
        if (of_a.exclude(bulge) || of_b.exclude(bulge)) return;
        if (of_a.are_within(limits_.same) && of_b.are_within(limits_.same)) return;
        const bool clear = of_a.are_clear(bulge) && of_b.are_clear(bulge);
        if (clear || halvings == most_halvings) {
            if (of_a.differ() && of_b.differ()) found.push_back(crossing(a, b));
            return;
        }
        for (const Chord& half : halves(a, a_))
            for (const Chord& other : halves(b, b_)) run(half, other, halvings + 1);
    }

    std::vector<CurveMeeting> found;

private:
    static bool are_apart(const Chord& a, const Chord& b, double bulge) {
        for (int k = 0; k < 2; ++k)
            if (std::min(a.a.at[k], a.b.at[k]) > std::max(b.a.at[k], b.b.at[k]) + bulge ||
                std::min(b.a.at[k], b.b.at[k]) > std::max(a.a.at[k], a.b.at[k]) + bulge)
                return true;
        return false;
    }

    std::array<Chord, 2> halves(const Chord& chord, const CurveCourse& curve) const {
        const double middle = (chord.begin + chord.end) / 2;
        const ImagePoint there = projection_.image(curve.at(middle));
        return {{{chord.begin, middle, chord.a, there}, {middle, chord.end, there, chord.b}}};
    }

    CurveMeeting crossing(const Chord& a, const Chord& b) const {
        const Vec2 x = a.b.at - a.a.at, y = b.b.at - b.a.at, way = b.a.at - a.a.at;
        const double area = x.cross(y);
        const double s = projection_.share_in_space(way.cross(y) / area, a.a.depth, a.b.depth);
        const double r = projection_.share_in_space(way.cross(x) / area, b.a.depth, b.b.depth);
        return {a.begin + s * (a.end - a.begin), b.begin + r * (b.end - b.begin)};
    }

    const CurveCourse &a_, &b_;
    const ImageProjection& projection_;
    CrossingLimits limits_;
};

} // namespace

std::vector<CurveMeeting> chord_crossings(const CurveCourse& a, std::size_t i, const CurveCourse& b,
                                          std::size_t j, const ImageProjection& projection,
                                          const CrossingLimits& limits) {
    Search search(a, b, projection, limits);
    search.run(search.chord(a, i), search.chord(b, j), 0);
    return std::move(search.found);
}

} // namespace keiko
