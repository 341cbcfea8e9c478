#include "keiko/math/sincos_2pi.h"

#include <array>
#include <cstddef>
#include <numbers>

/// Compiled for wide vectors too, and chosen when the program starts. Without contraction both give
/// the same bits. gcc has the thread sanitizer watch the function that chooses too, which runs
/// before the sanitizer is there: no program would start.
#if defined(__x86_64__) && defined(__ELF__) && !defined(__SANITIZE_THREAD__)
#define KEIKO_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define KEIKO_WIDE
#endif

namespace keiko {
namespace {

/// By rounding of the sum: for |x| < 2^51, without a branch or a call.
double nearest_whole(double x) {
    constexpr double shift = 0x1.8p52;
    return (x + shift) - shift;
}

/// Taylor's coefficients 1 / n! with alternating signs from n = `first` on in steps of two.
template <std::size_t count>
constexpr std::array<double, count> alternating(int first) {
    std::array<double, count> coefficients{};
    double factorial = 1, sign = 1;
    for (int n = 2; n <= first; ++n) factorial *= n;
    int n = first;
    for (double& c : coefficients) {
        c = sign / factorial;
        factorial *= (n + 1) * (n + 2);
        n += 2, sign = -sign;
    }
    return coefficients;
}

// For angles up to pi / 2.
constexpr auto of_sine = alternating<12>(1);
constexpr auto of_cosine = alternating<13>(0);

template <std::size_t count>
double polynomial(const std::array<double, count>& c, double z) {
    double sum = c[count - 1];
    for (std::size_t i = count - 1; i-- > 0;) sum = sum * z + c[i];
    return sum;
}

} // namespace

KEIKO_WIDE void sincos_2pi(std::span<const double> turns, std::span<double> cosines,
                           std::span<double> sines) {
    const double* in = turns.data();
    double *cosine = cosines.data(), *sine = sines.data();
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const double halves = nearest_whole(2 * in[i]);
        const double angle = (in[i] - halves / 2) * (2 * std::numbers::pi), z = angle * angle;
        const double odd = halves - 2 * nearest_whole(halves / 2), sign = 1 - 2 * odd * odd;
        cosine[i] = sign * polynomial(of_cosine, z);
        sine[i] = sign * angle * polynomial(of_sine, z);
    }
}

} // namespace keiko
