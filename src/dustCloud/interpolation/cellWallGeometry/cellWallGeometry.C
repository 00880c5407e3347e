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

#include "cellWallGeometry.H"
#include "rounded.H"
#include "syncTools.H"
#include "processorPolyPatch.H"
#include "wallPolyPatch.H"
#include "bitSet.H"

#include <array>
#include <map>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(cellWallGeometry, 0);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- By x, then y, then z
static bool before(const point& a, const point& b)
{
    return
        a.x() != b.x() ? a.x() < b.x()
      : a.y() != b.y() ? a.y() < b.y()
      : a.z() < b.z();
}


//- Area and centre of a face, as OpenFOAM does it
static void measure(const UList<point>& f, point& centre, vector& area)
{
    point middle(Zero);
    for (const point& p : f)
    {
        middle += p;
    }
    middle /= f.size();

    scalar sum = 0;
    centre = Zero;
    area = Zero;
    forAll(f, i)
    {
        const point& p = f[i];
        const point& next = f[(i + 1)%f.size()];
        const vector a = (next - p)^(middle - p);
        const scalar size = mag(a);
        area += 0.5*a;
        sum += size;
        centre += size*(p + next + middle);
    }
    centre = sum > VSMALL ? centre/(3*sum) : middle;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::point> Foam::cellWallGeometry::ordered
(
    const face& f,
    const UList<point>& points
)
{
    label first = 0;
    forAll(f, i)
    {
        if (before(points[f[i]], points[f[first]]))
        {
            first = i;
        }
    }
    const bool forward = before
    (
        points[f[f.fcIndex(first)]],
        points[f[f.rcIndex(first)]]
    );

    List<point> result(f.size());
    label i = first;
    for (point& p : result)
    {
        p = points[f[i]];
        i = forward ? f.fcIndex(i) : f.rcIndex(i);
    }
    return result;
}


Foam::labelList Foam::cellWallGeometry::ordered(const cell& c) const
{
    labelList faces(c);
    std::sort
    (
        faces.begin(),
        faces.end(),
        [this](const label a, const label b)
        {
            return before(faceCentres_[a], faceCentres_[b]);
        }
    );
    return faces;
}


void Foam::cellWallGeometry::calcCentres()
{
    const pointField& points = mesh_.points();
    vectorField areas(mesh_.nFaces());

    faceCentres_.setSize(mesh_.nFaces());
    forAll(faceCentres_, facei)
    {
        vector& area = areas[facei];
        measure(ordered(mesh_.faces()[facei], points), faceCentres_[facei], area);

        // Out of the owner
        if ((area & mesh_.faceAreas()[facei]) < 0)
        {
            area = -area;
        }
    }

    centres_.setSize(mesh_.nCells());
    forAll(centres_, celli)
    {
        const labelList faces(ordered(mesh_.cells()[celli]));

        point middle(Zero);
        for (const label facei : faces)
        {
            middle += faceCentres_[facei];
        }
        middle /= faces.size();

        point sum(Zero);
        scalar volume = 0;
        for (const label facei : faces)
        {
            const point& f = faceCentres_[facei];
            const scalar pyramid =
                (mesh_.faceOwner()[facei] == celli ? 1 : -1)
               *(areas[facei] & (f - middle));
            volume += pyramid;
            sum += pyramid*(0.75*f + 0.25*middle);
        }
        centres_[celli] = mag(volume) > VSMALL ? sum/volume : middle;
    }
}


void Foam::cellWallGeometry::findWallFaces
(
    DynamicList<wallFace>& faces,
    Map<DynamicList<label>>& ofPoint
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const pointField& points = mesh_.points();

    const auto add = [&](const UList<point>& f, const label patchi, vector area)
    {
        wallFace w;
        w.points = f;
        w.patch = patchi;
        w.slip = kinds_[patchi] == slip;
        vector canonical;
        measure(ordered(face(identity(f.size())), f), w.centre, canonical);
        w.n = (canonical & area) < 0 ? canonical : -canonical;
        w.n /= max(mag(w.n), VSMALL);
        faces.append(w);
    };

    // Points that other ranks know, too
    std::map<std::array<scalar, 3>, label> shared;
    bitSet isShared(mesh_.nPoints());
    for (const polyPatch& patch : patches)
    {
        if (isA<processorPolyPatch>(patch))
        {
            for (const label pointi : patch.meshPoints())
            {
                const point& p = points[pointi];
                shared[{p.x(), p.y(), p.z()}] = pointi;
                isShared.set(pointi);
            }
        }
    }

    List<List<List<point>>> all(Pstream::nProcs());
    List<List<vector>> allAreas(Pstream::nProcs());
    List<labelList> allPatches(Pstream::nProcs());
    DynamicList<List<point>> told;
    DynamicList<vector> toldAreas;
    DynamicList<label> toldPatches;

    forAll(kinds_, patchi)
    {
        if (kinds_[patchi] == open)
        {
            continue;
        }
        forAll(patches[patchi], i)
        {
            const face& f = patches[patchi][i];
            const vector& area =
                mesh_.faceAreas()[patches[patchi].start() + i];
            bool tell = false;
            add(f.points(points), patchi, area);
            for (const label pointi : f)
            {
                ofPoint(pointi).append(faces.size() - 1);
                tell = tell || isShared.test(pointi);
            }
            if (tell)
            {
                told.append(faces.last().points);
                toldAreas.append(area);
                toldPatches.append(patchi);
            }
        }
    }

    if (!Pstream::parRun())
    {
        return;
    }

    all[Pstream::myProcNo()] = told;
    allAreas[Pstream::myProcNo()] = toldAreas;
    allPatches[Pstream::myProcNo()] = toldPatches;
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    Pstream::gatherList(allAreas);
    Pstream::scatterList(allAreas);
    Pstream::gatherList(allPatches);
    Pstream::scatterList(allPatches);

    forAll(all, proci)
    {
        if (proci == Pstream::myProcNo())
        {
            continue;
        }
        forAll(all[proci], i)
        {
            DynamicList<label> here;
            for (const point& p : all[proci][i])
            {
                const auto found = shared.find({p.x(), p.y(), p.z()});
                if (found != shared.end())
                {
                    here.append(found->second);
                }
            }
            if (here.size())
            {
                add(all[proci][i], allPatches[proci][i], allAreas[proci][i]);
                for (const label pointi : here)
                {
                    ofPoint(pointi).append(faces.size() - 1);
                }
            }
        }
    }
}


void Foam::cellWallGeometry::findWalls()
{
    DynamicList<wallFace> faces;
    Map<DynamicList<label>> ofPoint;
    findWallFaces(faces, ofPoint);

    wallOf_.setSize(mesh_.nCells(), -1);

    forAll(wallOf_, celli)
    {
        DynamicList<label> mine;
        bool touches = false;
        for (const label facei : mesh_.cells()[celli])
        {
            for (const label pointi : mesh_.faces()[facei])
            {
                const auto found = ofPoint.cfind(pointi);
                if (found.found())
                {
                    touches = true;
                    mine.append(*found);
                }
            }
        }
        if (!touches)
        {
            continue;
        }

        std::sort
        (
            mine.begin(),
            mine.end(),
            [&](const label a, const label b)
            {
                return
                    a != b
                 && (
                        before(faces[a].centre, faces[b].centre)
                     || (
                            // the two sides of a thin wall
                            !before(faces[b].centre, faces[a].centre)
                         && before(faces[a].n, faces[b].n)
                        )
                    );
            }
        );
        const auto end = std::unique(mine.begin(), mine.end());
        DynamicList<wallFace> list;
        for (auto i = mine.begin(); i != end; ++i)
        {
            list.append(faces[*i]);
        }

        wallOf_[celli] = walls_.size();
        walls_.append
        (
            nearWall
            (
                list,
                centres_[celli],
                mesh_.cells()[celli].points(mesh_.faces(), mesh_.points()),
                // volumes differ in their last bits, too
                rounded(cbrt(mesh_.cellVolumes()[celli]))
            )
        );
    }
}


void Foam::cellWallGeometry::calcNeighbours()
{
    pointField across;
    syncTools::swapBoundaryCellPositions(mesh_, centres_, across);

    start_.setSize(mesh_.nCells() + 1);
    start_[0] = 0;
    neighbours_.reserve(2*mesh_.nFaces());

    forAll(centres_, celli)
    {
        const nearWall* near = walls(celli);
        const bool holds = near && !near->slips();
        const label first = neighbours_.size();
        symmTensor M(Zero);
        scalar sum = 0;

        for (const label facei : ordered(mesh_.cells()[celli]))
        {
            neighbour n;
            n.q = 1;
            vector d;
            if (mesh_.isInternalFace(facei))
            {
                n.from = mesh_.faceOwner()[facei] == celli
                  ? mesh_.faceNeighbour()[facei]
                  : mesh_.faceOwner()[facei];
                d = centres_[n.from] - centres_[celli];
            }
            else
            {
                const label boundaryi = facei - mesh_.nInternalFaces();
                const label patchi =
                    mesh_.boundaryMesh().patchID()[boundaryi];
                const bool coupled = mesh_.boundaryMesh()[patchi].coupled();
                if (!coupled && holds && kinds_[patchi] != open)
                {
                    continue;
                }
                n.from = mesh_.nCells() + boundaryi;
                d =
                    (coupled ? across[boundaryi] : faceCentres_[facei])
                  - centres_[celli];
            }

            scalar w = 1/max(magSqr(d), VSMALL);
            if (holds)
            {
                const scalar s = near->factor(centres_[celli] + d);
                if (s < 0.05)
                {
                    continue;
                }
                n.q = 1/s;
                w *= sqr(s);
            }
            M += w*sqr(d);
            sum += w*magSqr(d);
            n.g = w*d;
            neighbours_.append(n);
        }

        // Neighbours in one plane say nothing of the direction across it: no
        // change along it then
        if (det(M) < 1e-4*pow3(sum/3))
        {
            M += 1e-2*sum*symmTensor::I;
        }
        if (sum <= VSMALL)
        {
            M = symmTensor::I;
        }
        const symmTensor inverse(inv(M));
        for (label i = first; i < neighbours_.size(); ++i)
        {
            neighbours_[i].g = inverse & neighbours_[i].g;
        }
        start_[celli + 1] = neighbours_.size();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellWallGeometry::cellWallGeometry
(
    const fvMesh& mesh,
    const labelUList& kinds
)
:
    MeshObject<fvMesh, GeometricMeshObject, cellWallGeometry>(mesh),
    kinds_(kinds)
{
    calcCentres();
    findWalls();
    calcNeighbours();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::cellWallGeometry& Foam::cellWallGeometry::get
(
    const fvMesh& mesh,
    const labelUList& kinds
)
{
    const cellWallGeometry& geometry = New(mesh, kinds);
    if (geometry.kinds_ == kinds)
    {
        return geometry;
    }
    Delete(mesh);
    return New(mesh, kinds);
}


void Foam::cellWallGeometry::gradients
(
    const UList<vector>& cells,
    const UList<vector>& boundary,
    const bool solenoidal,
    List<tensor>& grad
) const
{
    grad.setSize(centres_.size());

    forAll(grad, celli)
    {
        tensor G(Zero);
        for (label i = start_[celli]; i < start_[celli + 1]; ++i)
        {
            const neighbour& n = neighbours_[i];
            const vector& U =
                n.from < cells.size()
              ? cells[n.from]
              : boundary[n.from - cells.size()];
            G += n.g*(n.q*U - cells[celli]);
        }

        const nearWall* near = walls(celli);
        if (solenoidal && (!near || near->slips()))
        {
            G -= (tr(G)/3)*tensor::I;
        }
        grad[celli] = G;
    }
}


void Foam::cellWallGeometry::ranges
(
    const UList<vector>& cells,
    const UList<vector>& boundary,
    List<vector>& low,
    List<vector>& high
) const
{
    low = cells;
    high = cells;

    forAll(low, celli)
    {
        const auto add = [&](const vector& U)
        {
            low[celli] = min(low[celli], U);
            high[celli] = max(high[celli], U);
        };
        for (label i = start_[celli]; i < start_[celli + 1]; ++i)
        {
            const label from = neighbours_[i].from;
            add
            (
                from < cells.size()
              ? cells[from]
              : boundary[from - cells.size()]
            );
        }
        if (walls(celli))
        {
            add(Zero);
        }
    }
}


// ************************************************************************* //
