/*---------------------------------------------------------------------------*\
    dustFoam: adhesive dust in ventilation ducts
-------------------------------------------------------------------------------
License
    This file is part of dustFoam.

    dustFoam is free software: you can redistribute it and/or modify it under
    the terms of the GNU General Public License as published by the Free
    Software Foundation, either version 3 of the License, or (at your option)
    any later version.

    dustFoam is distributed in the hope that it will be useful, but WITHOUT ANY
    WARRANTY; without even the implied warranty of MERCHANTABILITY or FITNESS
    FOR A PARTICULAR PURPOSE.  See the GNU General Public License for more
    details.

    You should have received a copy of the GNU General Public License along
    with dustFoam.  If not, see <http://www.gnu.org/licenses/>.

\*---------------------------------------------------------------------------*/

#include "nearWall.H"

#include "face.H"

#include <algorithm>
#include <utility>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

Foam::scalar Foam::wallProfile::f(const scalar s) const
{
    return
        s <= s1
      ? A*s
      : A*s1 + (1 - A*s1)*Foam::log(s/s1)/Foam::log(1/s1);
}


Foam::scalar Foam::wallProfile::F(const scalar s) const
{
    const scalar low = min(s, s1);
    scalar sum = 0.5*A*sqr(low);
    if (s > s1)
    {
        sum +=
            A*s1*(s - s1)
          + (1 - A*s1)*(s*Foam::log(s/s1) - s + s1)/Foam::log(1/s1);
    }
    return sum;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::nearWall::place Foam::nearWall::fromPlane
(
    const triangle& t,
    const point& x
)
{
    return {max((x - t.a) & t.n, scalar(0)), t.n, 0};
}


Foam::nearWall::place Foam::nearWall::fromTriangles
(
    const UList<triangle>& triangles,
    const point& x
)
{
    scalar best = GREAT;
    point foot = x;
    label corners = 0;      // 1: foot on an edge, 2: at a corner
    const triangle* nearest = nullptr;

    for (const triangle& t : triangles)
    {
        // Ericson, Real-Time Collision Detection (2005), 5.1.5
        const vector ab = t.b - t.a;
        const vector ac = t.c - t.a;
        const vector ax = x - t.a;
        const scalar d1 = ab & ax, d2 = ac & ax;
        const vector bx = x - t.b;
        const scalar d3 = ab & bx, d4 = ac & bx;
        const vector cx = x - t.c;
        const scalar d5 = ab & cx, d6 = ac & cx;
        const scalar va = d3*d6 - d5*d4;
        const scalar vb = d5*d2 - d1*d6;
        const scalar vc = d1*d4 - d3*d2;

        point here;
        label at = 2;
        if (d1 <= 0 && d2 <= 0)
        {
            here = t.a;
        }
        else if (d3 >= 0 && d4 <= d3)
        {
            here = t.b;
        }
        else if (d6 >= 0 && d5 <= d6)
        {
            here = t.c;
        }
        else if (vc <= 0 && d1 >= 0 && d3 <= 0)
        {
            here = t.a + ab*(d1/(d1 - d3));
            at = 1;
        }
        else if (vb <= 0 && d2 >= 0 && d6 <= 0)
        {
            here = t.a + ac*(d2/(d2 - d6));
            at = 1;
        }
        else if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        {
            here = t.b + (t.c - t.b)*((d4 - d3)/((d4 - d3) + (d5 - d6)));
            at = 1;
        }
        else
        {
            here = x - t.n*(ax & t.n);
            at = 0;
        }

        const scalar distance = magSqr(x - here);
        if (distance < best)
        {
            best = distance;
            foot = here;
            corners = at;
            nearest = &t;
        }
    }

    const scalar y = Foam::sqrt(best);
    const scalar height = (x - foot) & nearest->n;

    // Seams between triangles of one plane are no edges; nor can an edge be
    // seen from behind the wall
    if (corners == 0 || height > (1 - 1e-6)*y || y <= VSMALL)
    {
        return {max(height, scalar(0)), nearest->n, 0};
    }
    return {y, (x - foot)/y, corners};
}


Foam::nearWall::place Foam::nearWall::seen(const wall& w, const point& x)
{
    return
        w.flat
      ? fromPlane(w.triangles.first(), x)
      : fromTriangles(w.triangles, x);
}


Foam::vector Foam::nearWall::alongOne
(
    const point& x,
    const vector& d,
    const vector& U,
    const tensor& B,
    const wallProfile* profile
) const
{
    const place p = seen(walls_[0], x);
    const scalar yRef = walls_[0].yRef;
    const scalar s = p.y/yRef;

    // s and its integral from the wall
    const scalar f = profile ? profile->f(s) : s;
    const scalar F = profile ? profile->F(s) : 0.5*sqr(s);

    // At the height of the centre; its change along n; its change along the wall
    const vector W0 = U + ((d + (yRef - p.y)*p.n) & B);
    const scalar along = tr(B) - (p.n & B & p.n);
    const vector dW = profile ? vector(Zero) : vector(p.n & B);
    const scalar dWn = p.n & dW;

    scalar un;
    if (p.m == 0)
    {
        un = -F*yRef*along;
    }
    else
    {
        un =
            f*(p.m*((p.n & W0) - yRef*dWn) - yRef*along)/(1 + p.m)
          + 2*F*yRef*p.m*dWn/(2 + p.m);
    }

    const vector W = W0 + (p.y - yRef)*dW;
    return f*W + (un - f*(p.n & W))*p.n;
}


Foam::vector Foam::nearWall::turned(const point& x, vector u) const
{
    DynamicList<std::pair<scalar, vector>> order(walls_.size());
    for (const wall& w : walls_)
    {
        const place p = seen(w, x);
        order.append({min(scalar(1), p.y/w.yRef), p.n});
    }
    std::stable_sort
    (
        order.begin(),
        order.end(),
        [](const auto& a, const auto& b)
        {
            return a.first > b.first;
        }
    );
    for (const auto& o : order)
    {
        u -= (o.second & u)*(1 - o.first)*o.second;
    }
    return u;
}


Foam::labelList Foam::nearWall::split(const UList<wallFace>& faces)
{
    const label n = faces.size();
    labelList group(identity(n));

    // Face each other at 135 degrees or less: two walls
    const auto corner = [&](const label i, const label j)
    {
        return
            (faces[i].n & faces[j].n) < 0.7
         && ((faces[j].centre - faces[i].centre) & faces[i].n) > SMALL
               *mag(faces[j].centre - faces[i].centre)
         && faces[i].slip == faces[j].slip;
    };
    const auto shareEdge = [&](const label i, const label j)
    {
        label common = 0;
        for (const point& p : faces[i].points)
        {
            common += faces[j].points.found(p);
        }
        return common > 1;
    };
    const auto join = [&](const label a, const label b)
    {
        for (label& g : group)
        {
            g = g == b ? a : g;
        }
    };

    for (label i = 0; i < n; ++i)
    {
        for (label j = i + 1; j < n; ++j)
        {
            if
            (
                group[i] != group[j]
             && faces[i].slip == faces[j].slip
             && shareEdge(i, j)
             && !corner(i, j)
             && !corner(j, i)
            )
            {
                join(group[i], group[j]);
            }
        }
    }

    // Parts that do not hang together here, but make no corner either
    for (label i = 0; i < n; ++i)
    {
        for (label j = i + 1; j < n; ++j)
        {
            bool apart =
                group[i] == group[j] || faces[i].slip != faces[j].slip;
            for (label k = 0; k < n && !apart; ++k)
            {
                for (label l = 0; l < n && !apart; ++l)
                {
                    apart =
                        group[k] == group[i]
                     && group[l] == group[j]
                     && (corner(k, l) || corner(l, k));
                }
            }
            if (!apart)
            {
                join(group[i], group[j]);
            }
        }
    }

    return group;
}


void Foam::nearWall::addTriangles
(
    const wallFace& f,
    DynamicList<triangle>& triangles
)
{
    const face all(identity(f.points.size()));
    faceList cut(all.nTriangles());
    label n = 0;
    all.triangles(f.points, n, cut);

    for (const face& corners : cut)
    {
        triangle t;
        t.a = f.points[corners[0]];
        t.b = f.points[corners[1]];
        t.c = f.points[corners[2]];
        t.n = (t.b - t.a)^(t.c - t.a);
        const scalar area = mag(t.n);
        if (area > VSMALL)
        {
            t.n /= (t.n & f.n) < 0 ? -area : area;
            triangles.append(t);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nearWall::nearWall
(
    const UList<wallFace>& faces,
    const point& centre,
    const UList<point>& cellPoints,
    const scalar size
)
:
    nNoSlip_(0)
{
    const labelList group(split(faces));

    forAll(faces, i)
    {
        if (group.find(group[i]) != i)
        {
            continue;
        }

        wall w;
        w.slip = faces[i].slip;
        w.flat = true;
        nNoSlip_ += !w.slip;

        forAll(faces, j)
        {
            if (group[j] == group[i])
            {
                addTriangles(faces[j], w.triangles);
            }
        }
        if (w.triangles.empty())
        {
            nNoSlip_ -= !w.slip;
            continue;
        }

        const auto onPlane = [&](const point& x)
        {
            const place p = fromTriangles(w.triangles, x);
            return
                p.m == 0
             && mag(p.y - ((x - w.triangles[0].a) & w.triangles[0].n))
              < 1e-6*size;
        };
        for (const triangle& t : w.triangles)
        {
            w.flat = w.flat && (t.n & w.triangles[0].n) > 1 - 1e-10;
        }
        for (const point& x : cellPoints)
        {
            w.flat = w.flat && onPlane(x);
        }
        w.flat = w.flat && onPlane(centre);

        // The centre of a badly bent cell may lie on its wall or behind it
        w.yRef = max(seen(w, centre).y, 0.02*size);
        walls_.append(std::move(w));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::nearWall::factor(const point& x) const
{
    scalar p = 1;
    for (const wall& w : walls_)
    {
        if (!w.slip)
        {
            p *= seen(w, x).y/w.yRef;
        }
    }
    return p;
}


Foam::vector Foam::nearWall::reaching
(
    const point& x,
    const vector& change
) const
{
    return turned(x, min(scalar(1), factor(x))*change);
}


Foam::vector Foam::nearWall::velocity
(
    const point& x,
    const vector& d,
    const vector& U,
    const tensor& B,
    const wallProfile* profile
) const
{
    if (height() > 0)
    {
        return alongOne(x, d, U, B, profile);
    }

    const vector W = U + (d & B);

    if (!nNoSlip_)
    {
        vector u = W;
        for (const wall& w : walls_)
        {
            const place p = seen(w, x);
            if (p.y < w.yRef)
            {
                const vector foot = W - p.y*(p.n & B);
                u -= (p.n & foot)*(1 - p.y/w.yRef)*p.n;
            }
        }
        return u;
    }

    return turned(x, factor(x)*W);
}


// ************************************************************************* //
