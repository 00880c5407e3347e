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

// First: includes DEM.hpp
#include "dustSizes.H"

#include "distributionModel.H"
#include "dustParcel.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dustSizes::kind& Foam::dustSizes::find(const label material)
{
    for (kind& k : kinds_)
    {
        if (k.material == material)
        {
            return k;
        }
    }
    kinds_.push_back(kind{material, FixedList<scalar, 3>(scalar(0)), 0});
    return kinds_.back();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dustSizes::addInjector(const dictionary& injector)
{
    kind& k = find(properties_.material(injector));
    const dictionary* dictPtr = injector.findDict("sizeDistribution");
    if (!dictPtr)
    {
        return;
    }
    Random random(0);
    const autoPtr<distributionModel> sizes
    (
        distributionModel::New(*dictPtr, random)
    );
    const scalar low = sizes->minValue();
    const scalar high = sizes->maxValue();

    // Not meanValue(): to OpenFOAM that of the distribution without its bounds,
    // or something else. Random numbers of its own, the same on all ranks
    const label nSamples = 100000;
    scalar sum = 0;
    for (label i = 0; i < nSamples; ++i)
    {
        sum += sizes->sample();
    }
    // Of equal sizes that size, not what their sum makes of it
    const scalar mean = min(max(sum/nSamples, low), high);

    const label n = k.injectors++;
    FixedList<scalar, 3>& d = k.diameters;
    d[0] = n ? min(d[0], low) : low;
    d[1] = (n*d[1] + mean)/(n + 1);
    d[2] = max(d[2], high);
}


void Foam::dustSizes::addParticles(const Cloud<dustParcel>& cloud)
{
    const label nMaterials = label(properties_.materials().size());
    scalarList smallest(nMaterials, GREAT);
    scalarList largest(nMaterials, Zero);
    scalarList sum(nMaterials, Zero);
    labelList n(nMaterials, Zero);
    for (const dustParcel& p : cloud)
    {
        const label i = p.material();
        smallest[i] = min(smallest[i], p.d());
        largest[i] = max(largest[i], p.d());
        sum[i] += p.d();
        ++n[i];
    }
    Pstream::listCombineGather(smallest, minEqOp<scalar>());
    Pstream::listCombineScatter(smallest);
    Pstream::listCombineGather(largest, maxEqOp<scalar>());
    Pstream::listCombineScatter(largest);
    Pstream::listCombineGather(sum, plusEqOp<scalar>());
    Pstream::listCombineScatter(sum);
    Pstream::listCombineGather(n, plusEqOp<label>());
    Pstream::listCombineScatter(n);

    forAll(n, i)
    {
        if (!n[i])
        {
            continue;
        }
        FixedList<scalar, 3>& d = find(i).diameters;
        d[0] = d[0] > 0 ? min(d[0], smallest[i]) : smallest[i];
        d[2] = max(d[2], largest[i]);
        // Of equal sizes that size, not what their sum on some ranks makes of it
        d[1] = d[1] > 0 ? d[1] : min(max(sum[i]/n[i], d[0]), d[2]);
    }

    if (kinds_.empty())
    {
        // Nobody yet
        find(properties_.index(properties_.dustMaterials()[0]));
    }
}


Foam::DynamicList<Foam::labelPair> Foam::dustSizes::meetings
(
    const dem::Walls& walls
) const
{
    DynamicList<labelPair> pairs;
    const label nMaterials = label(properties_.materials().size());

    for (const kind& dust : kinds_)
    {
        for (label i = 0; i < nMaterials; ++i)
        {
            bool met = i == dust.material;
            for (const kind& other : kinds_)
            {
                met = met || (other.material == i && i > dust.material);
            }
            for (const dem::WallPatch& patch : walls.patches)
            {
                met = met || patch.material == i;
            }
            if (met)
            {
                pairs.append(labelPair(dust.material, i));
            }
        }
    }
    return pairs;
}


Foam::scalar Foam::dustSizes::smallest() const
{
    scalar d = 0;
    for (const kind& k : kinds_)
    {
        if (k.diameters[0] > 0)
        {
            d = d > 0 ? min(d, k.diameters[0]) : k.diameters[0];
        }
    }
    return d;
}


Foam::scalar Foam::dustSizes::largest() const
{
    scalar d = 0;
    for (const kind& k : kinds_)
    {
        d = max(d, k.diameters[2]);
    }
    return d;
}



// ************************************************************************* //
