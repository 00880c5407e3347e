// SPDX-License-Identifier: GPL-3.0-or-later
//
// Normal impacts by the closed forms of the contact laws and an integrator of ten digits,
// with nothing of the library:
//
//     collide LAW e E gamma R m v ...     prints v restitution time peakOverlap
#include "contactFormulas.hpp"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv)
{
    if (argc < 8) return 1;
    formula::Contact c;
    c.E = std::atof(argv[3]);
    c.G = 0;
    c.gamma = std::atof(argv[4]);
    c.R = std::atof(argv[5]);
    c.m = std::atof(argv[6]);
    for (int k = 7; k < argc; ++k)
    {
        const double v = std::atof(argv[k]);
        const formula::Collision r = formula::collide(argv[1], c, v, std::atof(argv[2]));
        std::printf("%s %.9g %.9g %.9g\n", argv[k], r.restitution, r.time, r.peakOverlap);
    }
}
