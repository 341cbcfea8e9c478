#pragma once

#include "keiko/render/lighting/error_budget.h"
#include "keiko/render/lighting/interpolant.h"
#include "keiko/render/lighting/light_samples.h"

namespace keiko {

/// Test whether lights are interpolated over rectangles of a grid from those at a few of their
/// places.
class InterpolationTest {
public:
    /// Test with the visible luminance `seen` of each place besides; the error allowed for all
    /// lights together is `error` of the visible luminance. Keeps references to all; computes into
    /// `lights`.
    InterpolationTest(const Integrator& integrator, const ShadingGrid& grid,
                      std::span<const Rgb> seen, double error, LightSamples& lights)
        : integrator_(integrator), grid_(grid), seen_(seen), error_(error), lights_(lights) {}

    /// Interpolated lights, by rising number.
    struct Accepted {
        Lights parabolas; ///< of degree two: Interpolant::parabolas of the rectangle
        Lights lines;     ///< linear, which in each quarter is Interpolant::lines
        Lights seen;      ///< with a visibility that is linear in each quarter
        /// Subset of all these for which that only holds in quarters without a shadow: they are
        /// visible from all tested places, but something may come between. Empty for small squares:
        /// shadows narrower than two pixels are not searched for there.
        Lights threatened;

        /// All interpolated lights.
        Lights all() const { return united(seen, united(lines, parabolas)); }
    };
    /// Accepted subset of the lights that are open over a rectangle; `known` is the light of the
    /// others there. The accepted lights reduce `left`, the remaining allowed error.
    Accepted tell(const Rectangle& r, const LightPolynomial& known, const UnresolvedLights& open,
                  double& left);

private:
    /// A place by which lights are judged.
    struct Test {
        Pixel place;
        ErrorBudget allowed;
    };
    Test test_at(const Pixel& p, const DirectLight& total) const;
    /// Sum of some lights at places.
    auto sum_of(std::span<const std::size_t> lights) const {
        return [this, lights](const Pixel& p) { return lights_.sum(p.x, p.y, lights); };
    }

    Lights threatened(const Rectangle& r, const Lights& lights) const;
    std::vector<Test> middles_of(const Rectangle& r, const LightPolynomial& known,
                                 const UnresolvedLights& open);
    std::vector<Test> odd_places_of(const Rectangle& r, const LightPolynomial& known,
                                    const UnresolvedLights& open, const Lights& hopeful);
    std::vector<LightError> doubts_in_parabolas(const Rectangle& r,
                                                const std::vector<Test>& middles,
                                                const std::vector<Test>& odd, const Lights& lights,
                                                double left) const;
    bool sees_alike(const Rectangle& r, const std::vector<Test>& odd, std::size_t light) const;
    void test(const Interpolant& fit, const std::vector<Test>& tests, double most,
              std::vector<LightError>& errors) const;
    void test_seen(const Rectangle& r, const std::vector<Test>& tests, double most,
                   std::vector<LightError>& errors) const;
    std::optional<DirectLight> wrong_if_seen_linearly(const LinearlySeen& linear,
                                                      const Pixel& p) const;

    const Integrator& integrator_;
    const ShadingGrid& grid_;
    std::span<const Rgb> seen_;
    double error_;
    LightSamples& lights_;
};

} // namespace keiko
