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

#include "patchWalls.H"
#include "dustProperties.H"
#include "patchCurvature.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "wallPolyPatch.H"
#include "wedgePolyPatch.H"
#include "Pstream.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static dem::Vec3 toVec3(const vector& v)
{
    return dem::Vec3(v.x(), v.y(), v.z());
}


//- Lexicographic order of points
static int compare(const point& a, const point& b)
{
    for (direction i = 0; i < 3; ++i)
    {
        if (a[i] != b[i])
        {
            return a[i] < b[i] ? -1 : 1;
        }
    }
    return 0;
}


//- Which patches are walls to the dust, and which are mirrors.
//  FatalError on what is neither these, nor open, nor coupled by a
//  translation
static void sort
(
    const polyBoundaryMesh& patches,
    labelList& walls,
    labelList& mirrors
)
{
    for (const polyPatch& pp : patches)
    {
        if (isA<wallPolyPatch>(pp))
        {
            walls.append(pp.index());
        }
        else if
        (
            isA<symmetryPlanePolyPatch>(pp)
         || isA<symmetryPolyPatch>(pp)
         || isA<emptyPolyPatch>(pp)
        )
        {
            mirrors.append(pp.index());
        }
        else if (isA<wedgePolyPatch>(pp))
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " is of type wedge: towards the"
                << " axis the wedge is narrower than the dust, which cannot"
                << " come nearer to it than its radius over the sine of half"
                << " the angle" << nl
                << "    allowed: a full three-dimensional mesh; or a sector of"
                << " it, a quarter say, between patches of type symmetryPlane"
                << exit(FatalError);
        }
        else if
        (
            polyPatch::constraintType(pp.type())
         && !isA<processorPolyPatch>(pp)
         && pp.type() != cyclicPolyPatch::typeName
        )
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " is of type " << pp.type()
                << ", which is not supported by the contact engine:"
                << " a particle there would not feel those on the other side."
                << nl << "    allowed: wall, patch, cyclic, symmetryPlane,"
                << " symmetry, empty" << exit(FatalError);
        }
    }
}


static wordList names(const polyBoundaryMesh& patches, const labelUList& which)
{
    wordList result;
    for (const label patchi : which)
    {
        result.append(patches[patchi].name());
    }
    return result;
}


//- Entries of patchMaterials that are nobody's
static void checkEntries
(
    const dictionary& patchMaterials,
    const wordList& wallNames
)
{
    for (const entry& e : patchMaterials)
    {
        const keyType& key = e.keyword();
        bool used = false;

        for (const word& name : wallNames)
        {
            used = used || key.match(name, key.isLiteral());
        }
        if (!used)
        {
            dustProperties::error
            (
                patchMaterials,
                key,
                "is not a patch of type wall in this mesh",
                dustProperties::listed(wallNames)
            );
        }
    }
}


//- Wall patches with their materials
static void addPatches
(
    dem::Walls& walls,
    const wordList& wallNames,
    const dictionary& properties,
    const dem::MaterialTable& table
)
{
    const dictionary& patchMaterials = properties.subDict("patchMaterials");
    checkEntries(patchMaterials, wallNames);

    wordList materials;
    for (const dem::Material& m : table.materials())
    {
        materials.append(word(m.name));
    }
    const string materialNames(dustProperties::listed(materials));

    for (const word& name : wallNames)
    {
        if (!patchMaterials.found(name, keyType::REGEX))
        {
            dustProperties::error
            (
                properties,
                "patchMaterials",
                "wall patch '" + name + "' has no material",
                name + " followed by one of " + materialNames
            );
        }

        const word material
        (
            patchMaterials.get<word>(name, keyType::REGEX)
        );

        dem::WallPatch patch;
        patch.name = name;
        try
        {
            patch.material = table.index(material);
        }
        catch (const dem::inputError&)
        {
            dustProperties::error
            (
                patchMaterials,
                name,
                "unknown material '" + material + "'",
                materialNames
            );
        }
        walls.patches.push_back(patch);
    }
}


//- Triangles of the last patches of the walls, which are these of the mesh;
//  returns how many have no area and are left out
static label addTriangles
(
    dem::Walls& walls,
    const polyMesh& mesh,
    const labelList& patchIDs
)
{
    const label first = label(walls.patches.size()) - patchIDs.size();
    label nDropped = 0;

    for (const patchWalls::triangle& t : patchWalls::gather(mesh, patchIDs))
    {
        const vector e1 = t.vertices[1] - t.vertices[0];
        const vector e2 = t.vertices[2] - t.vertices[0];
        const vector e3 = t.vertices[2] - t.vertices[1];
        const scalar longest = max(magSqr(e1), max(magSqr(e2), magSqr(e3)));

        // height over longest edge
        if (mag(e1 ^ e2) <= 1e-8*longest)
        {
            ++nDropped;
            continue;
        }

        // OpenFOAM's faces point out of the mesh, the DEM's to the particles
        walls.triangles.push_back
        (
            dem::WallTriangle
            {
                toVec3(t.vertices[0]),
                toVec3(t.vertices[2]),
                toVec3(t.vertices[1]),
                int(first + patchIDs.find(t.patch))
            }
        );
    }
    return nDropped;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::List<Foam::patchWalls::triangle> Foam::patchWalls::gather
(
    const polyMesh& mesh,
    const labelList& patchIDs,
    const UList<vectorField>& values
)
{
    // As plain numbers: patch, 9 coordinates, 3 values
    const label width = 13;
    DynamicList<scalar> mine;

    forAll(patchIDs, i)
    {
        const polyPatch& pp = mesh.boundaryMesh()[patchIDs[i]];
        faceList triangles;

        forAll(pp, facei)
        {
            const face& f = pp[facei];
            const label n = f.nTriangles();
            label triI = 0;

            triangles.setSize(n);
            f.triangles(mesh.points(), triI, triangles);

            const vector value =
                values.size() ? values[i][facei] : vector(Zero);

            for (label t = 0; t < triI; ++t)
            {
                // The lowest vertex first; the orientation stays
                label first = 0;
                for (label v = 1; v < 3; ++v)
                {
                    if
                    (
                        compare
                        (
                            mesh.points()[triangles[t][v]],
                            mesh.points()[triangles[t][first]]
                        ) < 0
                    )
                    {
                        first = v;
                    }
                }

                mine.append(patchIDs[i]);
                for (label v = 0; v < 3; ++v)
                {
                    const point& p =
                        mesh.points()[triangles[t][(first + v) % 3]];
                    mine.append(p.x());
                    mine.append(p.y());
                    mine.append(p.z());
                }
                mine.append(value.x());
                mine.append(value.y());
                mine.append(value.z());
            }
        }
    }

    List<scalarList> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = mine;
    #if OPENFOAM >= 2206
    Pstream::allGatherList(all);
    #else
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    #endif

    DynamicList<triangle> result;
    for (const scalarList& numbers : all)
    {
        for (label i = 0; i < numbers.size(); i += width)
        {
            triangle t;
            t.patch = label(numbers[i]);
            for (label v = 0; v < 3; ++v)
            {
                const scalar* x = &numbers[i + 1 + 3*v];
                t.vertices[v] = point(x[0], x[1], x[2]);
            }
            const scalar* x = &numbers[i + 10];
            t.value = vector(x[0], x[1], x[2]);
            result.append(t);
        }
    }

    std::sort
    (
        result.begin(),
        result.end(),
        [](const triangle& a, const triangle& b)
        {
            if (a.patch != b.patch)
            {
                return a.patch < b.patch;
            }
            for (label v = 0; v < 3; ++v)
            {
                const int c = compare(a.vertices[v], b.vertices[v]);
                if (c)
                {
                    return c < 0;
                }
            }
            return false;
        }
    );

    return List<triangle>(result);
}


dem::Periodic Foam::patchWalls::periodic(const polyMesh& mesh)
{
    dem::Periodic result;
    const boundBox& bounds = mesh.bounds();

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!isA<cyclicPolyPatch>(pp) && !isA<processorCyclicPolyPatch>(pp))
        {
            continue;
        }
        const coupledPolyPatch& cyclic = refCast<const coupledPolyPatch>(pp);
        const vector step
        (
            cyclic.separation().size() ? cyclic.separation()[0] : vector(Zero)
        );
        direction d = 0;
        for (direction k = 1; k < 3; ++k)
        {
            d = mag(step[k]) > mag(step[d]) ? k : d;
        }
        const scalar length = mag(step[d]);

        if
        (
            Pstream::parRun()
         || !cyclic.parallel()
         || cyclic.separation().size() != 1
         || mag(mag(step) - length) > 1e-6*length
         || mag(length - bounds.span()[d]) > 1e-6*length
        )
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " is of type " << pp.type()
                << (
                       Pstream::parRun()
                     ? ": the contact engine is periodic on one rank only"
                     : ", but does not lead from one end of the mesh to the"
                       " other along x, y or z"
                   )
                << nl << "    allowed: translational cyclic patches over the"
                << " whole extent of the mesh, in a serial run"
                << exit(FatalError);
        }
        result.low[d] = bounds.min()[d];
        result.length[d] = length;
    }
    return result;
}


dem::Walls Foam::patchWalls::New
(
    const polyMesh& mesh,
    const dictionary& properties,
    const dem::MaterialTable& table
)
{
    labelList wallPatches;
    labelList mirrors;
    sort(mesh.boundaryMesh(), wallPatches, mirrors);

    dem::Walls walls;
    addPatches
    (
        walls,
        names(mesh.boundaryMesh(), wallPatches),
        properties,
        table
    );
    const label nDropped = addTriangles(walls, mesh, wallPatches);

    Info<< "Walls: " << walls.triangles.size() << " triangles of "
        << wallPatches.size() << " patches";
    if (nDropped)
    {
        Info<< " (" << nDropped << " without area left out)";
    }
    Info<< nl;
    patchCurvature::set(walls, properties);

    // Behind them: without curvature, and nobody asks for their material
    for (const label patchi : mirrors)
    {
        const polyPatch& pp = mesh.boundaryMesh()[patchi];
        walls.patches.push_back({pp.name(), dem::mirror});
        Info<< "  patch " << pp.name() << " (" << pp.type() << "): mirror for"
            << " the dust, which touches it without friction, adhesion, loss"
            << " or deposit";
        if (isA<emptyPolyPatch>(pp))
        {
            Info<< nl << "    The gas is that of two dimensions; the dust moves"
                << " in three between front and back. OpenFOAM's injectors"
                << " start it in the middle, dustPatchInjection everywhere.";
        }
        Info<< nl;
    }
    addTriangles(walls, mesh, mirrors);
    Info<< endl;

    walls.reportImpacts = properties.subOrEmptyDict("cloudFunctions").size();

    return walls;
}


Foam::labelList Foam::patchWalls::patches
(
    const dem::Walls& walls,
    const polyMesh& mesh
)
{
    labelList result;
    for (const dem::WallPatch& patch : walls.patches)
    {
        result.append(mesh.boundaryMesh().findPatchID(patch.name));
    }
    return result;
}


dem::MaterialTable Foam::patchWalls::table
(
    const dem::Walls& walls,
    dem::MaterialTable table
)
{
    for (const dem::WallPatch& patch : walls.patches)
    {
        if (patch.material == dem::mirror)
        {
            table.addMirrors();
        }
    }
    return table;
}


// ************************************************************************* //
