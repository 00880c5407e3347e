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

// Means over neighbours: facets of a castellated and snapped mesh alternate
constexpr int averages = 2;

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
    std::size_t nVertices_ = 0;
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
        nVertices_ = vertices.size();
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

    //- K of all facets; edged: those with an edge sharper than the angle, which have none
    std::vector<Eigen::Matrix3d> tensors(double sharp, std::vector<char>& edged) const
    {
        std::vector<Eigen::Matrix3d> result(size(), Eigen::Matrix3d::Zero());
        edged.assign(size(), 0);
        for (std::size_t k = 0; k < size(); ++k)
        {
            const Facet& f = facets_[k];
            for (std::size_t c = 0; c < 3; ++c)
            {
                const double angle = bend(k, c);
                edged[k] |= std::fabs(angle) > sharp;
                const Vec3 e = f.x[(c + 1)%3] - f.x[c];
                result[k] += 0.5*angle/(f.area*e.norm())*(e*e.transpose());
            }
        }
        return result;
    }

    //- The mean over all facets about the corners of each, those with sharp edges left out
    void average(const std::vector<char>& edged, std::vector<Eigen::Matrix3d>& tensors) const
    {
        std::vector<std::pair<Eigen::Matrix3d, double>> corner
        (
            nVertices_, {Eigen::Matrix3d::Zero(), 0.0}
        );
        for (std::size_t k = 0; k < size(); ++k)
        {
            if (edged[k]) continue;
            for (const int v : facets_[k].vertex)
            {
                corner[std::size_t(v)].first += facets_[k].area*tensors[k];
                corner[std::size_t(v)].second += facets_[k].area;
            }
        }
        for (std::size_t k = 0; k < size(); ++k)
        {
            if (edged[k]) continue;
            Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
            double weight = 0;
            for (const int v : facets_[k].vertex)
            {
                sum += corner[std::size_t(v)].first;
                weight += corner[std::size_t(v)].second;
            }
            tensors[k] = sum/weight;
        }
    }

    //- Principal curvatures in the plane of a facet, the larger size first
    std::pair<double, double> principal(std::size_t k, const Eigen::Matrix3d& tensor) const
    {
        const Vec3& n = facets_[k].normal;
        const Eigen::Matrix3d P = Eigen::Matrix3d::Identity() - n*n.transpose();
        const Eigen::Matrix3d K = P*tensor*P;
        const double trace = K.trace();
        const double root = std::sqrt(std::max(0.0, 2*K.squaredNorm() - trace*trace));
        const double high = 0.5*(trace + root), low = 0.5*(trace - root);
        return
            std::fabs(low) > std::fabs(high)
          ? std::make_pair(low, high) : std::make_pair(high, low);
    }
};

}


MeasuredCurvature measureCurvature(const Walls& walls, int patch)
{
    const Surface surface(walls, patch);
    const double sharp = MeasuredCurvature::sharpest*M_PI/180;
    std::vector<char> sharpEdges;
    std::vector<Eigen::Matrix3d> tensors = surface.tensors(sharp, sharpEdges);
    for (int k = 0; k < averages; ++k) surface.average(sharpEdges, tensors);

    Weighted first, second;
    double area = 0, edged = 0;
    for (std::size_t k = 0; k < surface.size(); ++k)
    {
        area += surface.area(k);
        if (sharpEdges[k])
        {
            edged += surface.area(k);
            continue;
        }
        const auto curvatures = surface.principal(k, tensors[k]);
        first.push_back({curvatures.first, surface.area(k)});
        second.push_back({curvatures.second, surface.area(k)});
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
