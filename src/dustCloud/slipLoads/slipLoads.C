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

#include "slipLoads.H"
#include "modelTable.H"

#include "InjectionModelList.H"
#include "DispersionModel.H"
#include "PatchInteractionModel.H"
#include "StochasticCollisionModel.H"
#include "SurfaceFilmModel.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::slipLoads::add(const volVectorField& U, const vector& v)
{
    for (const vector& Ui : U.primitiveField())
    {
        slip_ = max(slip_, mag(Ui - v));
    }
    for (const fvPatchVectorField& patch : U.boundaryField())
    {
        for (const vector& Ui : patch)
        {
            slip_ = max(slip_, mag(Ui - v));
        }
    }
}


void Foam::slipLoads::findSpeeds(const dustCloud& cloud)
{
    const volVectorField& U = cloud.U();

    add(U, Zero);
    speed_ = slip_;
    const dictionary& injectors =
        cloud.subModelProperties().subDict("injectionModels");
    for (const entry& e : injectors)
    {
        if
        (
            e.isDict() && e.dict().found("U0")
         && !e.dict().lookupEntry("U0", keyType::LITERAL).stream()[0].isWord()
        )
        {
            const vector U0(e.dict().get<vector>("U0"));
            speed_ = max(speed_, mag(U0));
            add(U, U0);
        }
    }
    for (const dustParcel& p : cloud)
    {
        speed_ = max(speed_, mag(p.U()));
        slip_ = max(slip_, max(mag(p.U()), mag(U[p.cell()] - p.U())));
    }

    reduce(slip_, maxOp<scalar>());
    reduce(speed_, maxOp<scalar>());
}


Foam::scalar Foam::slipLoads::drag
(
    const dustCloud& cloud,
    const scalar d,
    const scalar density
) const
{
    const fvMesh& mesh = cloud.mesh();
    const wordList laws
    (
        modelTable::drags(cloud.subModelProperties().subDict("particleForces"))
    );
    scalar Sp = 0;

    if (mesh.nCells() && laws.size())
    {
        const label celli = findMax(mag(cloud.U().primitiveField())());
        dustParcel p(mesh, mesh.C()[celli], celli);
        p.d() = d;
        p.rho() = density;
        p.U() = vector(slip_, 0, 0);

        dustParcel::trackingData td(cloud);
        td.rhoc() = cloud.rho()[celli];
        td.muc() = cloud.mu()[celli];
        td.Uc() = Zero;
        const scalar Re = td.rhoc()*slip_*d/max(td.muc(), ROOTVSMALL);

        for (const auto& force : cloud.forces())
        {
            if (laws.found(force.type()))
            {
                Sp += force.calcCoupled
                (
                    p, td, 1, p.mass(), Re, td.muc()
                ).Sp();
            }
        }
    }
    return returnReduce(Sp, maxOp<scalar>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::slipLoads::slipLoads
(
    const dustCloud& cloud,
    const dustSizes& sizes
)
:
    slip_(0),
    speed_(0)
{
    findSpeeds(cloud);

    const bool heavy =
        cloud.subModelProperties().subDict("particleForces").found("gravity");

    for (const dustSizes::kind& kind : sizes.kinds())
    {
        dem::RatioDust dust{int(kind.material), {}};
        for (const scalar d : kind.diameters)
        {
            if (d <= 0 || (dust.loads.size() && d == 2*dust.loads.back().radius))
            {
                continue;
            }
            dem::RatioLoad load;
            load.radius = 0.5*d;
            load.mass = sizes.properties().mass(kind.material, d);
            const scalar Sp = drag
            (
                cloud, d, sizes.properties().density(kind.material)
            );
            const scalar weight = heavy ? load.mass*mag(cloud.g().value()) : 0;
            load.force = Sp*slip_ + weight;
            // As it falls in still air, if that is faster
            load.speed = max(speed_, Sp > 0 ? weight/Sp : 0);
            load.relaxationTime = Sp > 0 ? load.mass/Sp : 0;
            dust.loads.push_back(load);
        }
        dusts_.push_back(dust);
    }
}


// ************************************************************************* //
