// SPDX-License-Identifier: GPL-3.0-or-later
#include "walls/measureCurvature.hpp"

#include "walls/Walls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace dem
{

namespace
{

//- A value and the area that it stands for
typedef std::vector<std::pair<double, double>> Weighted;

//- The value below which half of the area lies
double median(Weighted values)
{
    std::sort(values.begin(), values.end());
    double total = 0, sum = 0;
    for (const auto& v : values) total += v.second;
    for (const auto& v : values)
    {
        sum += v.second;
        if (sum >= 0.5*total) return v.first;
    }
    return 0;
}

struct Lexicographic
{
    bool operator()(const Vec3& a, const Vec3& b) const
    {
        return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    }
};

//- The triangles of one patch and what lies beyond their edges
class Surface
{
    struct Facet
    {
        std::array<Vec3, 3> x;
        std::array<int, 3> vertex;
        Vec3 normal;
        double area;
    };
    std::vector<Facet> facets_;
    std::map<std::pair<int, int>, std::vector<std::size_t>> edges_;

public:

    Surface(const Walls& walls, int patch)
    {
        std::map<Vec3, int, Lexicographic> vertices;
        for (const WallTriangle& t : walls.triangles)
        {
            if (t.patch != patch) continue;
            Facet f{{t.a, t.b, t.c}, {}, (t.b - t.a).cross(t.c - t.a), 0};
            f.area = 0.5*f.normal.norm();
            f.normal.normalize();
            for (std::size_t c = 0; c < 3; ++c)
            {
                f.vertex[c] = vertices.emplace(f.x[c], int(vertices.size())).first->second;
            }
            for (std::size_t c = 0; c < 3; ++c)
            {
                edges_[ends(f, c)].push_back(facets_.size());
            }
            facets_.push_back(f);
        }
    }

    std::size_t size() const { return facets_.size(); }
    double area(std::size_t k) const { return facets_[k].area; }

    static std::pair<int, int> ends(const Facet& f, std::size_t c)
    {
        return std::minmax(f.vertex[c], f.vertex[(c + 1)%3]);
    }

    //- Angle by which the surface bends at edge c of a facet, convex positive; at a rim of the
    //  patch 0
    double bend(std::size_t k, std::size_t c) const
    {
        const Facet& f = facets_[k];
        const auto& sharing = edges_.at(ends(f, c));
        if (sharing.size() != 2) return 0;
        const Facet& o = facets_[sharing[0] == k ? sharing[1] : sharing[0]];
        const Vec3 along = (f.x[(c + 1)%3] - f.x[c]).normalized();
        return std::atan2(f.normal.cross(o.normal).dot(along), f.normal.dot(o.normal));
    }

    //- Principal curvatures of a facet, the larger size first; false if an edge is sharper than
    //  the angle
    bool curvatures(std::size_t k, double sharp, double& first, double& second) const
    {
        const Facet& f = facets_[k];
        Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
        for (std::size_t c = 0; c < 3; ++c)
        {
            const double angle = bend(k, c);
            if (std::fabs(angle) > sharp) return false;
            const Vec3 e = f.x[(c + 1)%3] - f.x[c];
            tensor += 0.5*angle/(f.area*e.norm())*(e*e.transpose());
        }
        const double trace = tensor.trace();
        const double root = std::sqrt(std::max(0.0, 2*tensor.squaredNorm() - trace*trace));
        first = 0.5*(trace + root);
        second = 0.5*(trace - root);
        if (std::fabs(second) > std::fabs(first)) std::swap(first, second);
        return true;
    }
};

}


MeasuredCurvature measureCurvature(const Walls& walls, int patch)
{
    const Surface surface(walls, patch);
    const double sharp = walls.featureAngle*(1 + 1e-6)*M_PI/180;
    Weighted first, second;
    double area = 0, edged = 0;
    for (std::size_t k = 0; k < surface.size(); ++k)
    {
        area += surface.area(k);
        double k1, k2;
        if (!surface.curvatures(k, sharp, k1, k2))
        {
            edged += surface.area(k);
            continue;
        }
        first.push_back({k1, surface.area(k)});
        second.push_back({k2, surface.area(k)});
    }

    MeasuredCurvature result;
    if (!(area > 0)) return result;
    result.edged = edged/area;
    WallCurvature& typical = result.curvature;
    typical = {median(first), median(second)};
    const double scale = std::max(std::fabs(typical.k1), std::fabs(typical.k2));
    // what a facet can show; less is no curvature
    const double least = 1e-3/std::sqrt(area/double(surface.size()));
    const bool flat = first.empty() || scale < least;
    if (flat) typical = {};

    const double off = flat ? least : MeasuredCurvature::tolerance*scale;
    // facets with sharp edges are flat
    double alike = flat ? area : 0;
    for (std::size_t k = 0; k < first.size(); ++k)
    {
        const bool fits =
            std::fabs(first[k].first - typical.k1) <= off
         && std::fabs(second[k].first - typical.k2) <= off;
        if (flat && !fits) alike -= first[k].second;
        if (!flat && fits) alike += first[k].second;
    }
    result.share = alike/area;
    // a wire's second curvature is the mesh's
    if (std::fabs(typical.k2) <= off) typical.k2 = 0;
    return result;
}

}
