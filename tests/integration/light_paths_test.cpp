#include "keiko/light/tubes/tube_hit.h"
#include "keiko/light/tubes/tube_lamp.h"
#include "keiko/stream/light_points.h"
#include "keiko/workflow/solve_radiosity.h"

#include "tests/support/path_tracer.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/stream/cut_text.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>

// `keiko radiosity` and `keiko illuminance --solution` against paths of light.

namespace keiko {
namespace {

using test::DiffuseHit, test::DiffuseScene, test::Estimate, test::Random;

Scene opened(const std::filesystem::path& file) {
    SceneOptions options;
    options.shadows = true;
    return open_scene({&file, 1}, options);
}

/// Rows of `keiko illuminance`, without the header.
std::vector<std::vector<double>> lux_of(const Scene& scene, const std::string& points) {
    std::string text;
    light_points(scene, test::cut_text(points, 1000), [&](std::string_view part) {
        text += part;
        return true;
    });
    std::vector<std::vector<double>> rows;
    std::istringstream lines(text);
    std::string line, number;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::istringstream numbers(line);
        for (rows.emplace_back(); std::getline(numbers, number, ',');)
            rows.back().push_back(std::stod(number));
    }
    return rows;
}

/// Gives a scene its solution, through a file.
void solve(Scene& scene, const std::filesystem::path& file) {
    write_solution(file, solve_radiosity(scene));
    take_solution(scene, read_solution(file), file.string());
}

double luminance_of(const Vec3& c) {
    return luminance(Rgb(c.x, c.y, c.z));
}

/// Compares points of `keiko illuminance` with paths: the sums to 1 %, beside the confidence of the
/// paths, which is three standard errors and below 0.5 %.
void expect_as_by_paths(const Scene& scene, const std::string& points, const DiffuseScene& truth,
                        int paths) {
    const auto rows = lux_of(scene, points);
    const ParsedRays receivers = rays_of({.text = points}, point_header);
    ASSERT_EQ(rows.size(), receivers.rays.size());
    Random random(11);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Ray& at = receivers.rays[i];
        const Estimate paths_tell =
            test::reflected_light(truth, at.origin, at.direction.normalized(), paths, random);
        const double reflected = rows[i][rows[i].size() - 2], sum = rows[i].back();
        const double by_paths = luminance_of(paths_tell.mean), direct = sum - reflected;
        const double confidence = 3 * luminance_of(paths_tell.error);
        std::printf(
            "point %zu: direct %.3f, reflected %.3f, by paths %.3f +- %.3f: %+.2f %% of "
            "the sum, %+.2f %% of the reflected\n",
            i, direct, reflected, by_paths, confidence,
            100 * (reflected - by_paths) / (direct + by_paths),
            100 * (reflected - by_paths) / by_paths);
        EXPECT_LT(confidence, 5e-3 * (direct + by_paths)) << "point " << i;
        EXPECT_NEAR(reflected, by_paths, 1e-2 * (direct + by_paths) + confidence) << "point " << i;
    }
}

/// A closed room with a wall of each colour, a ball and a block, of analytic shapes.
class Room {
public:
    static constexpr std::array<double, 3> size{4000, 3000, 2600};
    static inline const Vec3 lamp{1300, 1100, 1500}, ball{2800, 1900, 700};
    static constexpr double radius = 500, intensity = 1000;
    static inline const Vec3 block_low{700, 1700, 0}, block_high{1500, 2300, 900};
    static inline const std::array<Vec3, 6> walls{
        Vec3(0.7, 0.1, 0.1), Vec3(0.1, 0.2, 0.7),  Vec3(0.6, 0.6, 0.5),
        Vec3(0.2, 0.6, 0.2), Vec3(0.4, 0.35, 0.3), Vec3(0.8, 0.8, 0.8)}; // x0, x1, y0, y1, z0, z1
    static inline const Vec3 of_ball{0.7, 0.7, 0.2}, of_block{0.5, 0.3, 0.6};

    static std::string text() {
        std::ostringstream out;
        out << "format = \"keiko-scene/1\"\n";
        const auto material = [&](const Vec3& c) {
            out << "material = { diffuse = [" << c.x << ", " << c.y << ", " << c.z
                << "], refractive_index = 1 }\n";
        };
        const auto vector = [&](const char* name, const Vec3& v) {
            out << name << " = [" << v.x << ", " << v.y << ", " << v.z << "]\n";
        };
        for (unsigned wall = 0; wall < 6; ++wall) {
            const unsigned axis = wall / 2;
            Vec3 origin(0), u(0), v(0);
            if (wall % 2 == 1) origin[axis] = size[axis];
            u[(axis + 1) % 3] = size[(axis + 1) % 3], v[(axis + 2) % 3] = size[(axis + 2) % 3];
            out << "[[primitive]]\nkind = \"plane\"\n";
            vector("origin", origin), vector("u", u), vector("v", v), material(walls[wall]);
        }
        out << "[[primitive]]\nkind = \"sphere\"\nradius = " << radius << "\n";
        vector("center", ball), material(of_ball);
        const Vec3 extent = block_high - block_low;
        out << "[[primitive]]\nkind = \"box\"\n";
        vector("origin", block_low), vector("u", Vec3(extent.x, 0, 0));
        vector("v", Vec3(0, extent.y, 0)), vector("w", Vec3(0, 0, extent.z)), material(of_block);
        out << "[[point]]\nintensity = " << intensity << "\n";
        vector("position", lamp);
        return out.str();
    }

    static std::optional<DiffuseHit> hit(const Vec3& from, const Vec3& way) {
        double nearest = std::numeric_limits<double>::infinity();
        std::optional<DiffuseHit> found;
        const auto meet = [&](double t, const Vec3& normal, const Vec3& reflectance) {
            if (!(t > 1e-7) || !(t < nearest)) return;
            nearest = t, found = DiffuseHit{from + way * t, normal, reflectance};
        };
        for (unsigned axis = 0; axis < 3; ++axis)
            if (way[axis] != 0) {
                const bool far = way[axis] > 0;
                Vec3 normal(0);
                normal[axis] = far ? -1 : 1;
                meet(((far ? size[axis] : 0) - from[axis]) / way[axis], normal,
                     walls[2 * axis + (far ? 1 : 0)]);
            }
        const Vec3 off = from - ball;
        const double b = off.dot(way), rest = b * b - off.length2() + radius * radius;
        // From the ball itself no way out meets it again.
        if (rest > 0 && off.length() > radius * (1 + 1e-12)) {
            const double t = -b - std::sqrt(rest);
            meet(t, (off + way * t) / radius, of_ball);
        }
        meet_block(from, way, meet);
        return found;
    }

    /// One point: its light has no randomness.
    static Vec3 direct(const Vec3& point, const Vec3& normal, Random&) {
        const Vec3 way = lamp - point;
        const double cosine = normal.dot(way.normalized());
        if (!(cosine > 0)) return Vec3(0);
        const auto before = hit(point, way.normalized());
        if (before && (before->position - point).length() < way.length() * (1 - 1e-9))
            return Vec3(0);
        return Vec3(intensity * cosine / (way.length2() * 1e-6));
    }

private:
    template <class Meet>
    static void meet_block(const Vec3& from, const Vec3& way, const Meet& meet) {
        double begin = -std::numeric_limits<double>::infinity(), end = -begin;
        Vec3 normal(0);
        for (unsigned axis = 0; axis < 3; ++axis) {
            const bool rising = way[axis] > 0;
            const double low = (rising ? block_low[axis] : block_high[axis]) - from[axis];
            const double high = (rising ? block_high[axis] : block_low[axis]) - from[axis];
            if (low / way[axis] > begin) {
                begin = low / way[axis], normal = Vec3(0);
                normal[axis] = rising ? -1 : 1;
            }
            end = std::min(end, high / way[axis]);
        }
        if (begin < end) meet(begin, normal, of_block);
    }
};

TEST(LightPaths, OfAColouredRoomIsWhatPathsTell) {
    const test::TemporaryFolder folder;
    Scene scene = opened(folder.file("room.toml", Room::text()));
    solve(scene, folder.path() / "room.solution");
    // Free floor, beside the block and in its corner with the floor, walls near corners, ceiling,
    // the ball above and below, on the block.
    const std::string points =
        "2000,600,0,0,0,1\n1600,2000,0,0,0,1\n1510,2000,0,0,0,1\n0,1500,1300,1,0,0\n"
        "20,2980,0,0,0,1\n3000,3000,2000,0,-1,0\n2000,1500,2600,0,0,-1\n"
        "2800,1900,1200,0,0,1\n2800,1900,200,0,0,-1\n2300,1900,700,-1,0,0\n"
        "1000,2000,900,0,0,1\n2000,1500,1300,0.6,0,0.8\n";
    expect_as_by_paths(scene, points, {Room::hit, Room::direct}, 2000000);
}

/// Light of tubes at a point by one random place of each that faces it, past bodies.
class TubeSamples {
public:
    explicit TubeSamples(const Scene& scene) : tracer_(scene.seen()) {
        for (const LightSource& source : scene.rig->sources) {
            const CPlane& row = std::get<CPlane>(source);
            rows_.push_back(CPlaneFrame(row)), luminances_.push_back(row.luminance);
        }
    }
    Vec3 operator()(const Vec3& point, const Vec3& normal, Random& random) const {
        Vec3 sum(0);
        for (std::size_t row = 0; row < rows_.size(); ++row)
            for (int lamp = 0; lamp < rows_[row].lamps; ++lamp)
                sum += of_lamp(row, lamp, point, normal, random);
        return sum;
    }

private:
    Vec3 of_lamp(std::size_t row, int number, const Vec3& point, const Vec3& normal,
                 Random& random) const {
        const TubeLamp lamp = lamp_of(rows_[row], number, luminances_[row]);
        const Vec3 axis = (lamp.b - lamp.a).normalized(), from = point - lamp.a;
        const Vec3 off = from - axis * from.dot(axis), towards = off.normalized();
        const double radius = lamp.diameter / 2, length = (lamp.b - lamp.a).length();
        const double seen = std::acos(radius / off.length());
        const double phi = seen * test::uniform(random, -1, 1);
        const Vec3 out = towards * std::cos(phi) + axis.cross(towards) * std::sin(phi);
        const Vec3 at = lamp.a + axis * (length * test::uniform(random, 0, 1)) + out * radius;
        const Vec3 way = at - point;
        const double cosines = std::max(0.0, normal.dot(way)) * std::max(0.0, -out.dot(way));
        if (cosines == 0) return Vec3(0);
        Ray ray;
        ray.origin = point, ray.direction = way, ray.t_min = 1e-6, ray.t_max = 1;
        const auto tube = nearest_tube(rows_[row], point, way);
        if ((tube && tube->lamp != number) || tracer_.any(ray)) return Vec3(0);
        const double lux = length * radius * 2 * seen * cosines / std::pow(way.length(), 4);
        return Vec3(lamp.luminance.r, lamp.luminance.g, lamp.luminance.b) * lux;
    }

    const Tracer& tracer_;
    std::vector<CPlaneFrame> rows_;
    std::vector<Rgb> luminances_;
};

/// The workshop of the gallery, with painted windows: light through glass is another test's. No
/// coats, since reflectances then depend on the direction.
std::string workshop() {
    const std::filesystem::path surfaces = test::repository("surfaces");
    std::ifstream file(surfaces / "workshop-scene.toml");
    std::ostringstream all;
    all << "materials = \"workshop.toml\"\n";
    for (std::string line; std::getline(file, line);) {
        const auto replace = [&](const std::string& old, const std::string& by) {
            if (const auto at = line.find(old); at != std::string::npos)
                line.replace(at, old.size(), by);
        };
        replace("file = \"", "file = \"" + surfaces.string() + "/");
        for (const char* name : {"privacy-glass", "dark-red", "dark-blue", "rubber", "silver"})
            replace('"' + std::string(name) + '"', "\"matt-" + std::string(name) + '"');
        all << line << '\n';
    }
    return all.str();
}

/// Paints without coats for it.
std::string matt_materials() {
    std::ostringstream out;
    out << "format = \"keiko-materials/1\"\n";
    const auto add = [&](const char* name, const char* diffuse) {
        out << "[[material]]\nname = \"matt-" << name << "\"\ndiffuse = " << diffuse
            << "\nrefractive_index = 1\n";
    };
    add("privacy-glass", "0.05"), add("dark-red", "[0.3, 0.03, 0.03]");
    add("dark-blue", "[0.03, 0.05, 0.2]"), add("rubber", "0.04"), add("silver", "0.4");
    return out.str();
}

TEST(LightPaths, OfTheWorkshopIsWhatPathsTell) {
    const test::TemporaryFolder folder;
    folder.file("workshop.toml", matt_materials());
    Scene scene = opened(folder.file("scene.toml", workshop()));
    solve(scene, folder.path() / "workshop.solution");
    const DiffuseScene truth{
        [&](const Vec3& from, const Vec3& way) -> std::optional<DiffuseHit> {
            Ray ray;
            ray.origin = from, ray.direction = way, ray.t_min = 1e-6;
            const auto hit = scene.seen().nearest(ray);
            if (!hit) return std::nullopt;
            const Rgb& rho = scene.seen_materials()[hit->face].diffuse;
            return DiffuseHit{hit->position, hit->normal.dot(way) < 0 ? hit->normal : -hit->normal,
                              Vec3(rho.r, rho.g, rho.b)};
        },
        TubeSamples(scene)};
    // In the open, beside the car, on the bench, on the shelf below, on a wall.
    expect_as_by_paths(scene,
                       "4000,700,0,0,0,1\n3000,1250,0,0,0,1\n"
                       "3000,5330,900,0,0,1\n4000,4850,270,0,0,1\n8000,3000,1500,-1,0,0\n",
                       truth, 150000);
}

} // namespace
} // namespace keiko
