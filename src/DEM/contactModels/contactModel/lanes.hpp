// SPDX-License-Identifier: GPL-3.0-or-later
//
// Between particles (structures) and Reals (one particle's value per lane): gathering and
// scattering groups of four doubles at once, as small matrix transposes where the processor
// has them.
#pragma once

#include "contactModels/contactModel/Real.hpp"

#include <type_traits>
#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace dem
{

template<class Real>
inline constexpr int laneCount = std::is_same_v<Real, double> ? 1 : packWidth;

template<class Real>
[[gnu::always_inline]] inline Real loadReal(const double* p)
{
    if constexpr (std::is_same_v<Real, double>) return *p;
    else return Real(p, std::experimental::element_aligned);
}

template<class Real>
[[gnu::always_inline]] inline void storeReal(double* p, const Real& v)
{
    if constexpr (std::is_same_v<Real, double>) *p = v;
    else v.copy_to(p, std::experimental::element_aligned);
}

template<class Real>
[[gnu::always_inline]] inline double lane(const Real& v, int l)
{
    if constexpr (std::is_same_v<Real, double>)
    {
        (void)l;
        return v;
    }
    else return v[std::size_t(l)];
}

//- Three components and what follows them in memory
template<class Real>
struct V4 { V3<Real> v; Real w; };

//- from[l] points to four doubles on a 32-byte boundary
template<class Real>
[[gnu::always_inline]] inline V4<Real> gather4(const double* const* from)
{
    if constexpr (std::is_same_v<Real, double>)
    {
        return {{from[0][0], from[0][1], from[0][2]}, from[0][3]};
    }
#if defined(__AVX2__)
    else if constexpr (packWidth == 4)
    {
        const __m256d a = _mm256_load_pd(from[0]), b = _mm256_load_pd(from[1]);
        const __m256d c = _mm256_load_pd(from[2]), d = _mm256_load_pd(from[3]);
        const __m256d ab0 = _mm256_unpacklo_pd(a, b), ab1 = _mm256_unpackhi_pd(a, b);
        const __m256d cd0 = _mm256_unpacklo_pd(c, d), cd1 = _mm256_unpackhi_pd(c, d);
        return
        {
            {
                Real(_mm256_permute2f128_pd(ab0, cd0, 0x20)),
                Real(_mm256_permute2f128_pd(ab1, cd1, 0x20)),
                Real(_mm256_permute2f128_pd(ab0, cd0, 0x31))
            },
            Real(_mm256_permute2f128_pd(ab1, cd1, 0x31))
        };
    }
#endif
    else
    {
        const auto component = [&](int k)
        {
            return Real([&](auto l) { return from[int(l)][k]; });
        };
        return {{component(0), component(1), component(2)}, component(3)};
    }
}

//- Add to the four doubles at to[l], lane by lane in order: two lanes may be the same particle
template<class Real>
[[gnu::always_inline]] inline void addTo(double* const* to, const V3<Real>& v)
{
#if defined(__AVX2__)
    if constexpr (!std::is_same_v<Real, double> && packWidth == 4)
    {
        const __m256d x = static_cast<__m256d>(v.x), y = static_cast<__m256d>(v.y);
        const __m256d z = static_cast<__m256d>(v.z), w = _mm256_setzero_pd();
        const __m256d xy0 = _mm256_unpacklo_pd(x, y), xy1 = _mm256_unpackhi_pd(x, y);
        const __m256d zw0 = _mm256_unpacklo_pd(z, w), zw1 = _mm256_unpackhi_pd(z, w);
        const __m256d lane4[4] =
        {
            _mm256_permute2f128_pd(xy0, zw0, 0x20),
            _mm256_permute2f128_pd(xy1, zw1, 0x20),
            _mm256_permute2f128_pd(xy0, zw0, 0x31),
            _mm256_permute2f128_pd(xy1, zw1, 0x31)
        };
        for (int l = 0; l < 4; ++l)
        {
            _mm256_store_pd(to[l], _mm256_add_pd(_mm256_load_pd(to[l]), lane4[l]));
        }
        return;
    }
    else
#endif
    {
        for (int l = 0; l < laneCount<Real>; ++l)
        {
            to[l][0] += lane(v.x, l);
            to[l][1] += lane(v.y, l);
            to[l][2] += lane(v.z, l);
        }
    }
}

}
