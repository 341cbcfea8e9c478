#include "keiko/light/spotlight/beam_spread.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace keiko {
namespace {

constexpr double untabulated = std::numeric_limits<double>::quiet_NaN();
constexpr double quarter_turn = 90, half_turn = 180;

/// Intensity under an angle from the axis.
struct ProfilePoint {
    double angle;   ///< degrees, negative to the negative side
    double candela; ///< NaN: not tabulated; no comparison with it holds
};

/// Intensities by ascending angle, linear between the points. The first and the last are not
/// tabulated.
using Profile = std::vector<ProfilePoint>;

Profile reversed(Profile profile) {
    std::reverse(profile.begin(), profile.end());
    for (ProfilePoint& point : profile) point.angle = -point.angle;
    return profile;
}

/// The angles with `angle` among them, if it lies between the first and the last.
std::vector<double> with_angle(std::vector<double> angles, double angle) {
    if (angle > angles.front() && angle < angles.back() &&
        !std::binary_search(angles.begin(), angles.end(), angle))
        angles.insert(std::upper_bound(angles.begin(), angles.end(), angle), angle);
    return angles;
}

/// Points of a half plane of type C by ascending angle from the axis.
Profile half_plane(const IntensityTable& table, double plane, bool opposite) {
    Profile profile;
    for (const double v : with_angle(table.vertical(), quarter_turn))
        profile.push_back({opposite ? half_turn - v : v, table(v, plane)});
    if (opposite) std::reverse(profile.begin(), profile.end());
    return profile;
}

void close_ends(Profile& profile) {
    profile.insert(profile.begin(), {profile.front().angle, untabulated});
    profile.push_back({profile.back().angle, untabulated});
}

Profile profile_of_type_c(const IntensityTable& table, double plane, bool opposite) {
    Profile profile = reversed(half_plane(table, plane + half_turn, opposite));
    const Profile positive = half_plane(table, plane, opposite);
    if (positive.front().angle > 0) profile.push_back({0, untabulated});
    profile.insert(profile.end(), positive.begin(), positive.end());
    close_ends(profile);
    return profile;
}

/// The horizontal angles of a table of type A or B, those to the left too.
std::vector<double> unfolded(const IntensityTable& table) {
    std::vector<double> angles;
    if (table.symmetry() == PlaneSymmetry::lateral)
        for (auto h = table.horizontal().rbegin(); h != table.horizontal().rend(); ++h)
            if (*h > 0) angles.push_back(-*h);
    angles.insert(angles.end(), table.horizontal().begin(), table.horizontal().end());
    return angles;
}

Profile profile_of_type_a_or_b(const IntensityTable& table, bool across) {
    Profile profile;
    for (const double angle : across ? table.vertical() : unfolded(table))
        profile.push_back({angle, across ? table(angle, 0) : table(0, angle)});
    close_ends(profile);
    return profile;
}

Profile profile_of(const PhotometricWeb& web, double plane, bool opposite) {
    return web.type == PhotometricType::c ? profile_of_type_c(web.candela, plane, opposite)
                                          : profile_of_type_a_or_b(web.candela, plane != 0);
}

bool is_ahead(const ProfilePoint& point) {
    return std::abs(point.angle) <= quarter_turn;
}

/// Largest intensity up to 90 degrees from the axis, or beyond.
double largest(const Profile& profile, bool ahead) {
    double candela = 0;
    for (const ProfilePoint& point : profile)
        if (is_ahead(point) == ahead && point.candela > candela) candela = point.candela;
    return candela;
}

/// Last fall of the intensity to `limit`, towards rising angles. Requires a point ahead that has
/// it.
SpreadEdge last_fall(const Profile& profile, double limit) {
    std::size_t inside = profile.size() - 1;
    while (!(is_ahead(profile[inside]) && profile[inside].candela >= limit)) --inside;
    while (profile[inside + 1].candela >= limit) ++inside;
    const ProfilePoint &a = profile[inside], &b = profile[inside + 1];
    if (std::isnan(b.candela)) return {a.angle, false};
    const double t = (a.candela - limit) / (a.candela - b.candela);
    return {a.angle + t * (b.angle - a.angle), true};
}

} // namespace

std::optional<double> BeamSpread::full_angle() const {
    if (!positive.reached || !negative.reached) return {};
    return positive.angle + negative.angle;
}

std::optional<BeamSpread> beam_spread(const PhotometricWeb& web, double share, double plane) {
    Profile profile = profile_of(web, plane, false);
    const double ahead = largest(profile, true), behind = largest(profile, false);
    if (!(ahead > 0 || behind > 0)) return {};
    const bool opposite = behind > ahead;
    if (opposite) profile = profile_of(web, plane, true);
    const double limit = share * std::max(ahead, behind);
    return BeamSpread{last_fall(profile, limit), last_fall(reversed(std::move(profile)), limit),
                      opposite};
}

PrincipalSpreads principal_spreads(const PhotometricWeb& web, double share) {
    return {beam_spread(web, share, 0), beam_spread(web, share, 90)};
}

} // namespace keiko
