// SPDX-License-Identifier: GPL-3.0-or-later
#include "walls/WallSearch.hpp"

#include "particles/errors.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace dem
{

namespace
{

// Where on a triangle the nearest point lies
enum Feature { face = 0, edgeAB, edgeBC, edgeCA, vertexA, vertexB, vertexC };

// Nearest point on a triangle (Ericson, Real-Time Collision Detection, 5.1.5)
Vec3 nearestOnTriangle(const Vec3& p, const WallTriangle& t, int& feature)
{
    const Vec3 ab = t.b - t.a, ac = t.c - t.a, ap = p - t.a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) { feature = vertexA; return t.a; }

    const Vec3 bp = p - t.b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) { feature = vertexB; return t.b; }

    const double vc = d1*d4 - d3*d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0)
    {
        feature = edgeAB;
        return t.a + d1/(d1 - d3)*ab;
    }

    const Vec3 cp = p - t.c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) { feature = vertexC; return t.c; }

    const double vb = d5*d2 - d1*d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
    {
        feature = edgeCA;
        return t.a + d2/(d2 - d6)*ac;
    }

    const double va = d3*d6 - d5*d4;
    if (va <= 0 && (d4 - d3) >= 0 && (d5 - d6) >= 0)
    {
        feature = edgeBC;
        return t.b + (d4 - d3)/((d4 - d3) + (d5 - d6))*(t.c - t.b);
    }

    feature = face;
    const double denominator = 1/(va + vb + vc);
    return t.a + vb*denominator*ab + vc*denominator*ac;
}

}


bool Walls::empty() const
{
    return
        triangles.empty() && planes.empty() && cylinders.empty() && spheres.empty();
}


double closingTime(double gap, double closingSpeed, double bound)
{
    if (gap <= 0) return closingSpeed > 0 ? 0 : 1e300;
    const double root =
        std::sqrt(closingSpeed*closingSpeed + 2*bound*gap);
    const double denominator = root + closingSpeed;
    return denominator > 1e-290*gap ? 2*gap/denominator : 1e300;
}


WallSearch::WallSearch(Walls walls)
:
    walls_(std::move(walls)),
    cosFeature_(std::cos(walls_.featureAngle*M_PI/180))
{
    deriveCurvature(walls_);
    const auto checkPatch = [&](int patch)
    {
        if (patch < 0 || patch >= int(walls_.patches.size()))
        {
            throw inputError
            (
                "walls", "a surface of patch " + std::to_string(patch),
                "0 to " + std::to_string(int(walls_.patches.size()) - 1)
            );
        }
    };
    for (auto& s : walls_.planes)
    {
        checkPatch(s.patch);
        s.normal.normalize();
    }
    for (auto& s : walls_.cylinders)
    {
        checkPatch(s.patch);
        s.axis.normalize();
    }
    for (const auto& s : walls_.spheres) checkPatch(s.patch);

    const std::size_t n = walls_.triangles.size();
    topology_.resize(n);
    order_.resize(n);
    centre_.resize(n);

    const auto less = [](const Vec3& a, const Vec3& b)
    {
        return std::lexicographical_compare
        (
            a.data(), a.data() + 3, b.data(), b.data() + 3
        );
    };
    std::map<Vec3, int, decltype(less)> vertices(less);

    for (std::size_t k = 0; k < n; ++k)
    {
        const WallTriangle& t = walls_.triangles[k];
        checkPatch(t.patch);
        const Vec3 area = (t.b - t.a).cross(t.c - t.a);
        if (!(area.norm() > 0))
        {
            throw inputError
            (
                "walls", "triangle " + std::to_string(k) + " has no area",
                "triangles with three different corners"
            );
        }
        Topology& topo = topology_[k];
        topo.normal = area.normalized();
        order_[k] = int(k);
        centre_[k] = (t.a + t.b + t.c)/3;

        const Vec3* corner[3] = {&t.a, &t.b, &t.c};
        for (int c = 0; c < 3; ++c)
        {
            topo.vertex[std::size_t(c)] =
                vertices.emplace(*corner[c], int(vertices.size())).first->second;
        }
    }

    if (n) build(0, int(n));
}


int WallSearch::build(int first, int last)
{
    const int self = int(nodes_.size());
    nodes_.push_back({Vec3::Zero(), Vec3::Zero(), -1, -1, first, last});
    Vec3 low = Vec3::Constant(1e300), high = -low;
    Vec3 cLow = low, cHigh = high;
    for (int k = first; k < last; ++k)
    {
        const std::size_t t = std::size_t(order_[std::size_t(k)]);
        const WallTriangle& tri = walls_.triangles[t];
        low = low.cwiseMin(tri.a).cwiseMin(tri.b).cwiseMin(tri.c);
        high = high.cwiseMax(tri.a).cwiseMax(tri.b).cwiseMax(tri.c);
        cLow = cLow.cwiseMin(centre_[t]);
        cHigh = cHigh.cwiseMax(centre_[t]);
    }

    Node node{low, high, -1, -1, first, last};
    if (last - first > 4)
    {
        int axis;
        (cHigh - cLow).maxCoeff(&axis);
        const int middle = (first + last)/2;
        std::nth_element
        (
            order_.begin() + first, order_.begin() + middle, order_.begin() + last,
            [&](int a, int b)
            {
                const double ca = centre_[std::size_t(a)][axis];
                const double cb = centre_[std::size_t(b)][axis];
                return ca < cb || (ca == cb && a < b);
            }
        );
        node.left = build(first, middle);
        node.right = build(middle, last);
    }
    nodes_[std::size_t(self)] = node;
    return self;
}


WallHit WallSearch::shapeHit(int shape, const Vec3& x) const
{
    // shapes are numbered planes, cylinders, spheres
    std::size_t s = std::size_t(shape);
    if (s < walls_.planes.size())
    {
        const WallPlane& w = walls_.planes[s];
        return {-w.normal, w.normal.dot(x - w.point), w.patch};
    }
    s -= walls_.planes.size();

    const auto round = [](const Vec3& out, double radius, bool inside, int patch)
    {
        const double d = out.norm();
        const Vec3 n = d > 0 ? Vec3(out/d) : Vec3(Vec3::UnitX());
        return
            inside
          ? WallHit{n, radius - d, patch}
          : WallHit{-n, d - radius, patch};
    };

    if (s < walls_.cylinders.size())
    {
        const WallCylinder& w = walls_.cylinders[s];
        Vec3 out = x - w.point;
        out -= w.axis.dot(out)*w.axis;
        return round(out, w.radius, w.inside, w.patch);
    }
    s -= walls_.cylinders.size();
    const WallSphere& w = walls_.spheres[s];
    return round(x - w.centre, w.radius, w.inside, w.patch);
}


int WallSearch::patchOf(int surface) const
{
    std::size_t s = std::size_t(surface);
    if (s < walls_.triangles.size()) return walls_.triangles[s].patch;
    s -= walls_.triangles.size();
    if (s < walls_.planes.size()) return walls_.planes[s].patch;
    s -= walls_.planes.size();
    if (s < walls_.cylinders.size()) return walls_.cylinders[s].patch;
    return walls_.spheres[s - walls_.cylinders.size()].patch;
}


double WallSearch::nearest(int surface, const Vec3& x, Vec3& point, int& feature) const
{
    const int nTriangles = int(walls_.triangles.size());
    if (surface < nTriangles)
    {
        point = nearestOnTriangle
        (
            x, walls_.triangles[std::size_t(surface)], feature
        );
        return (point - x).norm();
    }
    const WallHit hit = shapeHit(surface - nTriangles, x);
    point = x + hit.distance*hit.n;
    feature = face;
    return hit.distance;
}


void WallSearch::query
(
    const Vec3& low, const Vec3& high, std::vector<int>& surfaces
) const
{
    surfaces.clear();
    if (!nodes_.empty())
    {
        int stack[64];
        int depth = 0;
        stack[depth++] = 0;
        while (depth)
        {
            const Node& node = nodes_[std::size_t(stack[--depth])];
            if
            (
                (node.low.array() > high.array()).any()
             || (node.high.array() < low.array()).any()
            ) continue;
            if (node.left < 0)
            {
                for (int k = node.first; k < node.last; ++k)
                {
                    const int t = order_[std::size_t(k)];
                    const WallTriangle& tri = walls_.triangles[std::size_t(t)];
                    const Vec3 tLow = tri.a.cwiseMin(tri.b).cwiseMin(tri.c);
                    const Vec3 tHigh = tri.a.cwiseMax(tri.b).cwiseMax(tri.c);
                    if
                    (
                        (tLow.array() <= high.array()).all()
                     && (tHigh.array() >= low.array()).all()
                    )
                    {
                        surfaces.push_back(t);
                    }
                }
            }
            else
            {
                stack[depth++] = node.left;
                stack[depth++] = node.right;
            }
        }
        // the order of contacts must not depend on the tree
        std::sort(surfaces.begin(), surfaces.end());
    }

    const int nTriangles = int(walls_.triangles.size());
    const int nShapes = int
    (
        walls_.planes.size() + walls_.cylinders.size() + walls_.spheres.size()
    );
    const Vec3 middle = 0.5*(low + high);
    const double half = 0.5*(high - low).norm();
    for (int s = 0; s < nShapes; ++s)
    {
        if (shapeHit(s, middle).distance <= half) surfaces.push_back(nTriangles + s);
    }
}


bool WallSearch::within(int surface, const Vec3& x, double range) const
{
    Vec3 point;
    int feature;
    return nearest(surface, x, point, feature) <= range;
}


void WallSearch::hits
(
    const Vec3& x, double range, const int* surfaces, std::size_t nSurfaces,
    std::vector<WallHit>& result
) const
{
    struct Local { int triangle; int feature; double distance; Vec3 point; bool front; };
    static thread_local std::vector<Local> local;
    local.clear();
    result.clear();

    const int nTriangles = int(walls_.triangles.size());
    for (std::size_t k = 0; k < nSurfaces; ++k)
    {
        const int s = surfaces[k];
        if (s >= nTriangles)
        {
            const WallHit hit = shapeHit(s - nTriangles, x);
            if (hit.distance <= range) result.push_back(hit);
            continue;
        }
        Local l;
        l.triangle = s;
        l.distance = nearest(s, x, l.point, l.feature);
        l.front = topology_[std::size_t(s)].normal.dot(x - l.point) >= 0;
        // a little more than range: what is nearer across an edge must be seen
        if (l.distance <= range*(1 + 1e-9)) local.push_back(l);
    }
    const std::size_t nShapeHits = result.size();
    if (local.empty() && nShapeHits < 2) return;

    // Nearer; or the same point, of which speaks the triangle that is seen from the front,
    // then the lower
    const auto outdoes = [](const Local& o, const Local& l)
    {
        const double tie = 1e-9*l.distance;
        if (std::fabs(o.distance - l.distance) > tie) return o.distance < l.distance;
        return o.front != l.front ? o.front : o.triangle < l.triangle;
    };

    for (const Local& l : local)
    {
        const Topology& topo = topology_[std::size_t(l.triangle)];
        // seen from behind, it is some other surface's back
        bool minimum = l.front;

        if (l.feature != face)
        {
            // the corners that its edge, or its corner, has
            const bool edge = l.feature <= edgeCA;
            const std::size_t first = std::size_t(l.feature - (edge ? edgeAB : vertexA));
            const int p = topo.vertex[first];
            const int q = edge ? topo.vertex[(first + 1)%3] : p;
            for (const Local& o : local)
            {
                const auto& v = topology_[std::size_t(o.triangle)].vertex;
                const bool shares =
                    (v[0] == p || v[1] == p || v[2] == p)
                 && (v[0] == q || v[1] == q || v[2] == q);
                if (o.triangle != l.triangle && shares)
                {
                    minimum = minimum && !outdoes(o, l);
                }
            }
        }

        if (minimum && l.distance > 0)
        {
            const int patch = walls_.triangles[std::size_t(l.triangle)].patch;
            result.push_back({(l.point - x)/l.distance, l.distance, patch});
        }
    }

    // One contact per smooth surface: nearest first, the rest within the feature angle go
    std::stable_sort
    (
        result.begin() + std::ptrdiff_t(nShapeHits), result.end(),
        [](const WallHit& a, const WallHit& b) { return a.distance < b.distance; }
    );
    std::size_t kept = nShapeHits;
    for (std::size_t k = nShapeHits; k < result.size(); ++k)
    {
        bool own = true;
        for (std::size_t o = nShapeHits; o < kept; ++o)
        {
            own = own && result[o].n.dot(result[k].n) < cosFeature_;
        }
        if (own) result[kept++] = result[k];
    }
    result.resize(kept);
    std::stable_sort
    (
        result.begin(), result.end(),
        [](const WallHit& a, const WallHit& b) { return a.distance < b.distance; }
    );
}


double WallSearch::timeToTouch
(
    const Vec3& x, const Vec3& v, double bound, double radius,
    const std::vector<double>& touch, const int* surfaces, std::size_t nSurfaces
) const
{
    double shortest = 1e300;
    const int nTriangles = int(walls_.triangles.size());
    for (std::size_t k = 0; k < nSurfaces; ++k)
    {
        Vec3 point;
        int feature;
        const int s = surfaces[k];
        const double distance = nearest(s, x, point, feature);
        if (!(distance > 0)) continue;
        const Vec3 n = (point - x)/distance;
        if
        (
            s < nTriangles && feature == face
         && topology_[std::size_t(s)].normal.dot(n) > 0
        ) continue;

        // From inside a round wall the gap is not convex: allow for the whole speed
        const bool round = s >= nTriangles + int(walls_.planes.size());
        const double closing = round ? v.norm() : v.dot(n);
        shortest = std::min
        (
            shortest,
            closingTime
            (
                std::max
                (
                    distance - radius - touch[std::size_t(patchOf(s))],
                    gapResolution(x, radius)
                ),
                closing, bound
            )
        );
    }
    return shortest;
}

}
