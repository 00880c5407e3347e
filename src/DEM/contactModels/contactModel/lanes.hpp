// SPDX-License-Identifier: GPL-3.0-or-later
//
// Between particles (structures) and Reals (one particle's value per lane): gathering and
// scattering groups of four doubles at once, as small matrix transposes where the processor
// has them.
#pragma once

#include "contactModels/contactModel/Real.hpp"
#include "contacts/ContactList.hpp"

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
#if defined(__AVX512F__)
    else if constexpr (packWidth == 8)
    {
        // rows l and l + 4 side by side, then two transposes of four by four
        __m512d row[4];
        for (int l = 0; l < 4; ++l)
        {
            row[l] = _mm512_insertf64x4
            (
                _mm512_castpd256_pd512(_mm256_load_pd(from[l])), _mm256_load_pd(from[l + 4]), 1
            );
        }
        const __m512d xz0 = _mm512_unpacklo_pd(row[0], row[1]);
        const __m512d yw0 = _mm512_unpackhi_pd(row[0], row[1]);
        const __m512d xz2 = _mm512_unpacklo_pd(row[2], row[3]);
        const __m512d yw2 = _mm512_unpackhi_pd(row[2], row[3]);
        const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
        const __m512i high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
        return
        {
            {
                Real(_mm512_permutex2var_pd(xz0, low, xz2)),
                Real(_mm512_permutex2var_pd(yw0, low, yw2)),
                Real(_mm512_permutex2var_pd(xz0, high, xz2))
            },
            Real(_mm512_permutex2var_pd(yw0, high, yw2))
        };
    }
#endif
#if defined(__AVX2__)
    else if constexpr (packWidth == 4)
    {
        // lanes 0 and 2, and 1 and 3, side by side: the second half comes by the load
        const auto halves = [&](int l, int k)
        {
            return _mm256_insertf128_pd
            (
                _mm256_castpd128_pd256(_mm_load_pd(from[l] + k)),
                _mm_load_pd(from[l + 2] + k), 1
            );
        };
        const __m256d even = halves(0, 0), odd = halves(1, 0);
        const __m256d even2 = halves(0, 2), odd2 = halves(1, 2);
        return
        {
            {
                Real(_mm256_unpacklo_pd(even, odd)), Real(_mm256_unpackhi_pd(even, odd)),
                Real(_mm256_unpacklo_pd(even2, odd2))
            },
            Real(_mm256_unpackhi_pd(even2, odd2))
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

//- Add sign*v to a member of the loads of particles index[0..], lane by lane in order: two
//  lanes may be the same particle
template<class Real, int sign = 1>
[[gnu::always_inline]] inline void addTo
(
    Load* loads, const int* index, double (Load::*member)[4], const V3<Real>& v
)
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
            double* to = (loads + index[l])->*member;
            const __m256d old = _mm256_load_pd(to);
            _mm256_store_pd
            (
                to, sign > 0 ? _mm256_add_pd(old, lane4[l]) : _mm256_sub_pd(old, lane4[l])
            );
        }
        return;
    }
    else
#endif
    {
        for (int l = 0; l < laneCount<Real>; ++l)
        {
            double* to = (loads + index[l])->*member;
            to[0] += sign*lane(v.x, l);
            to[1] += sign*lane(v.y, l);
            to[2] += sign*lane(v.z, l);
        }
    }
}

//- Add a force, times sign, and a torque likewise
template<class Real, int sign = 1>
[[gnu::always_inline]] inline void addLoad
(
    Load* loads, const int* index, const V3<Real>& force, const V3<Real>& torque
)
{
#if defined(__AVX512F__)
    if constexpr (!std::is_same_v<Real, double> && packWidth == 8)
    {
        // a Load is as wide as a register: rows of force and torque, side by side
        const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
        const __m512i high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
        const auto rows = [&](const V3<Real>& v, __m512d* row)
        {
            // lane l of row k: component l of what lane k has, then of lane k + 4
            const __m512d x = static_cast<__m512d>(v.x), y = static_cast<__m512d>(v.y);
            const __m512d z = static_cast<__m512d>(v.z), w = _mm512_setzero_pd();
            const __m512d xy0 = _mm512_unpacklo_pd(x, y), xy1 = _mm512_unpackhi_pd(x, y);
            const __m512d zw0 = _mm512_unpacklo_pd(z, w), zw1 = _mm512_unpackhi_pd(z, w);
            row[0] = _mm512_permutex2var_pd(xy0, low, zw0);
            row[1] = _mm512_permutex2var_pd(xy1, low, zw1);
            row[2] = _mm512_permutex2var_pd(xy0, high, zw0);
            row[3] = _mm512_permutex2var_pd(xy1, high, zw1);
        };
        __m512d f[4], t[4];
        rows(sign > 0 ? force : Real(-1)*force, f);
        rows(torque, t);
        for (int l = 0; l < 8; ++l)
        {
            const __m512d load =
                l < 4
              ? _mm512_insertf64x4(f[l], _mm512_castpd512_pd256(t[l]), 1)
              : _mm512_shuffle_f64x2(f[l - 4], t[l - 4], 0xee);
            double* to = loads[index[l]].f;
            _mm512_store_pd(to, _mm512_add_pd(_mm512_load_pd(to), load));
        }
        return;
    }
#endif
    addTo<Real, sign>(loads, index, &Load::f, force);
    addTo<Real>(loads, index, &Load::t, torque);
}

}
