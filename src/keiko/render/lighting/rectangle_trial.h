#pragma once

#include "keiko/render/lighting/allowed_error.h"
#include "keiko/render/lighting/light_fit.h"
#include "keiko/render/lighting/open_lights.h"

namespace keiko {

/// Tries on rectangles of a grid which lights are told over them by those at a few of their places.
class RectangleTrial {
public:
    /// `seen`: what the eye sees of each place besides; what all lights together may be off by is
    /// `error` of what it sees. All are only looked at but `lights`, which are found.
    RectangleTrial(const Integrator& integrator, const SpotGrid& grid, std::span<const Rgb> seen,
                   double error, GridLights& lights)
        : integrator_(integrator), grid_(grid), seen_(seen), error_(error), lights_(lights) {}

    /// Lights that are told, by rising number.
    struct Told {
        Lights parabolas; ///< of degree two: LightFit::parabolas of the rectangle
        Lights lines;     ///< linear, which in each quarter is LightFit::lines
        Lights seen;      ///< what is seen of these is linear in each quarter
        /// Those of all these of which that only holds in quarters in which no shadow is: all
        /// places that were asked see them, but something may come between. Of small squares none:
        /// what is narrower than two pixels is not searched for there.
        Lights threatened;

        Lights all() const { return united(seen, united(lines, parabolas)); }
    };
    /// Of lights that are open over a rectangle, of which `known` is what the others bring to it.
    /// `left` of the error is still allowed, which those that are told lessen.
    Told tell(const Rectangle& r, const LightPolynomial& known, const OpenLights& open,
              double& left);

private:
    /// A place by which lights are judged.
    struct Test {
        Pixel place;
        AllowedError allowed;
    };
    Test test_at(const Pixel& p, const SpotLight& total) const;
    /// What some lights together bring to places.
    auto sum_of(std::span<const std::size_t> lights) const {
        return [this, lights](const Pixel& p) { return lights_.sum(p.x, p.y, lights); };
    }

    Lights threatened(const Rectangle& r, const Lights& lights) const;
    std::vector<Test> middles_of(const Rectangle& r, const LightPolynomial& known,
                                 const OpenLights& open);
    std::vector<Test> odd_places_of(const Rectangle& r, const LightPolynomial& known,
                                    const OpenLights& open, const Lights& hopeful);
    std::vector<Doubt> doubts_in_parabolas(const Rectangle& r, const std::vector<Test>& middles,
                                           const std::vector<Test>& odd, const Lights& lights,
                                           double left) const;
    bool sees_alike(const Rectangle& r, const std::vector<Test>& odd, std::size_t light) const;
    void test(const LightFit& fit, const std::vector<Test>& tests, double most,
              std::vector<Doubt>& doubts) const;
    void test_seen(const Rectangle& r, const std::vector<Test>& tests, double most,
                   std::vector<Doubt>& doubts) const;
    std::optional<SpotLight> wrong_if_seen_linearly(const LinearlySeen& linear,
                                                    const Pixel& p) const;

    const Integrator& integrator_;
    const SpotGrid& grid_;
    std::span<const Rgb> seen_;
    double error_;
    GridLights& lights_;
};

} // namespace keiko
