// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace dem
{

//- A particle as the contact kernels read it; velocities as predicted for the full step, so
//  that the scheme is of second order with damping too
struct alignas(32) Body
{
    double x[3], r;     // [m]
    double v[3], invM;  // [m/s], [1/kg]
    double w[3], invI;  // [rad/s], [1/(kg m2)]
};

//- How springs move on in one evaluation: by the trapezoidal rule, half a step with the old
//  velocity and half with the new. What is kept in the history between evaluations is
//  ahead by `after`, i.e. by half a step of the velocities of then.
struct SpringStep
{
    double turned = 0;  // step over which the pair has turned since the last evaluation [s]
    double before = 0;  // slip time before the forces are evaluated [s]
    double after = 0;   // slip time after it [s]
};

//- Force [N] and torque [N m] on a particle; the fourth components are zero
struct alignas(64) Load
{
    double f[4];
    double t[4];
};

//- Contacts of one law: flat columns, one entry per contact.
struct ContactList
{
    std::vector<int> i, j;                  // bodies; j = wall patch in a wall list
    std::vector<double> overlap;            // [m]; written for pairs, read for walls
    std::vector<double> nx, ny, nz;         // normal from i into the wall (wall lists only)
    std::vector<std::vector<double>> constants;
    std::vector<char> same;                 // by constant: all contacts have one value
    std::vector<std::vector<double>> history;
    std::vector<char> ended;
    std::vector<int> tag;                   // the owner's reference

    void setUp(int nConstants, int nHistory, bool wall)
    {
        constants.assign(std::size_t(nConstants), {});
        same.assign(std::size_t(nConstants), 1);
        history.assign(std::size_t(nHistory), {});
        wall_ = wall;
        clear();
    }

    std::size_t size() const { return i.size(); }
    bool isWall() const { return wall_; }

    void clear()
    {
        i.clear(); j.clear(); overlap.clear(); ended.clear(); tag.clear();
        nx.clear(); ny.clear(); nz.clear();
        for (auto& c : constants) c.clear();
        for (auto& c : history) c.clear();
    }

    //- Append a contact with the given constants and history (null: zero)
    void append(int iIn, int jIn, int tagIn, const double* c, const double* h)
    {
        i.push_back(iIn);
        j.push_back(jIn);
        tag.push_back(tagIn);
        overlap.push_back(0);
        ended.push_back(0);
        if (wall_)
        {
            nx.push_back(0); ny.push_back(0); nz.push_back(0);
        }
        for (std::size_t k = 0; k < constants.size(); ++k)
        {
            same[k] = constants[k].empty() || (same[k] && constants[k][0] == c[k]);
            constants[k].push_back(c[k]);
        }
        for (std::size_t k = 0; k < history.size(); ++k)
        {
            history[k].push_back(h ? h[k] : 0);
        }
    }

    void swap(std::size_t a, std::size_t b)
    {
        std::swap(i[a], i[b]);
        std::swap(j[a], j[b]);
        std::swap(tag[a], tag[b]);
        std::swap(overlap[a], overlap[b]);
        std::swap(ended[a], ended[b]);
        if (wall_)
        {
            std::swap(nx[a], nx[b]); std::swap(ny[a], ny[b]); std::swap(nz[a], nz[b]);
        }
        for (auto& c : constants) std::swap(c[a], c[b]);
        for (auto& c : history) std::swap(c[a], c[b]);
    }

    void popBack()
    {
        i.pop_back(); j.pop_back(); tag.pop_back(); overlap.pop_back(); ended.pop_back();
        if (wall_)
        {
            nx.pop_back(); ny.pop_back(); nz.pop_back();
        }
        for (auto& c : constants) c.pop_back();
        for (auto& c : history) c.pop_back();
    }

private:

    bool wall_ = false;
};

}
