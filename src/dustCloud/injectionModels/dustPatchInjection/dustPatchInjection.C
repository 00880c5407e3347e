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
#include "patchWalls.H"
#include "dustProperties.H"

#include "dustPatchInjection.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(dustPatchInjection, 0);

    InjectionModel<dustCloud::kinematicCloudType>::
        adddictionaryConstructorToTable<dustPatchInjection>
        addDustPatchInjectionToTable_;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dustPatchInjection::makeTriangles()
{
    const fvMesh& mesh = this->owner().mesh();

    List<vectorField> velocities(1);
    if (gasVelocity_)
    {
        velocities[0] = this->owner().U().boundaryField()[patchID_];
    }
    else
    {
        velocities[0] =
            vectorField(mesh.boundaryMesh()[patchID_].size(), U0_);
    }

    triangles_.clear();
    scalar sum = 0;

    for
    (
        const patchWalls::triangle& t :
        patchWalls::gather(mesh, labelList(1, patchID_), velocities)
    )
    {
        triangle mine;
        mine.vertices = t.vertices;
        mine.U = t.value;

        // OpenFOAM's faces point out of the domain
        const vector area =
            -0.5
           *(
                (t.vertices[1] - t.vertices[0])
              ^ (t.vertices[2] - t.vertices[0])
            );
        if (mag(area) < VSMALL)
        {
            continue;
        }
        mine.normal = area/mag(area);

        const scalar inflow =
            gasVelocity_ ? max(mine.U & area, scalar(0)) : mag(area);
        if (inflow <= 0)
        {
            continue;
        }
        sum += inflow;
        mine.cumulative = sum;
        triangles_.append(mine);
    }

    for (triangle& t : triangles_)
    {
        t.cumulative /= sum;
    }
}


Foam::dictionary Foam::dustPatchInjection::completed(const dictionary& dict)
{
    dictionary full(dict);
    full.set("parcelBasisType", word("fixed"));
    full.set("nParticle", 1);
    full.set("massTotal", 0);
    return full;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dustPatchInjection::dustPatchInjection
(
    const dictionary& dict,
    cloudType& owner,
    const word& modelName
)
:
    InjectionModel<cloudType>(completed(dict), owner, modelName, typeName),
    patchName_(dict.get<word>("patch")),
    patchID_(owner.mesh().boundaryMesh().findPatchID(patchName_)),
    parcelsPerSecond_(dict.get<scalar>("parcelsPerSecond")),
    duration_(dict.lookupOrDefault<scalar>("duration", GREAT)),
    parcelsTotal_(dict.lookupOrDefault<label>("parcelsTotal", labelMax)),
    gasVelocity_(false),
    U0_(Zero),
    seed_(dict.lookupOrDefault<label>("seed", 1)),
    random_(0),
    sizes_(distributionModel::New(dict.subDict("sizeDistribution"), random_)),
    next_(this->template getModelProperty<label>("next")),
    redrawn_(this->template getModelProperty<label>("redrawn")),
    leftOut_(this->template getModelProperty<label>("leftOut")),
    d_(0),
    U_(Zero),
    number_(-1)
{
    dustProperties::checkKeywords
    (
        dict,
        {
            "type", "patch", "SOI", "parcelsPerSecond", "duration",
            "parcelsTotal", "U0", "seed", "sizeDistribution", "injectorID",
            "active", "parcelBasisType", "nParticle", "massTotal"
        }
    );

    if (patchID_ < 0)
    {
        wordList names;
        for (const polyPatch& pp : owner.mesh().boundaryMesh())
        {
            if (!pp.coupled())
            {
                names.append(pp.name());
            }
        }
        dustProperties::error
        (
            dict,
            "patch",
            "there is no patch '" + patchName_ + "'",
            dustProperties::listed(names)
        );
    }
    if (parcelsPerSecond_ <= 0)
    {
        dustProperties::error
        (
            dict,
            "parcelsPerSecond",
            "is " + Foam::name(parcelsPerSecond_),
            "> 0 1/s"
        );
    }

    ITstream& is = dict.lookup("U0");
    const token first(is);
    if (first.isWord())
    {
        gasVelocity_ = first.wordToken() == "gas";
        if (!gasVelocity_)
        {
            dustProperties::error
            (
                dict,
                "U0",
                "unknown value '" + first.wordToken() + "'",
                "gas, or a velocity (Ux Uy Uz) in m/s"
            );
        }
    }
    else
    {
        U0_ = dict.get<vector>("U0");
    }

    makeTriangles();
}


Foam::dustPatchInjection::dustPatchInjection(const dustPatchInjection& im)
:
    InjectionModel<cloudType>(im),
    patchName_(im.patchName_),
    patchID_(im.patchID_),
    parcelsPerSecond_(im.parcelsPerSecond_),
    duration_(im.duration_),
    parcelsTotal_(im.parcelsTotal_),
    gasVelocity_(im.gasVelocity_),
    U0_(im.U0_),
    seed_(im.seed_),
    random_(0),
    sizes_(im.sizes_.clone()),
    triangles_(im.triangles_),
    next_(im.next_),
    redrawn_(im.redrawn_),
    leftOut_(im.leftOut_),
    d_(0),
    U_(Zero),
    number_(-1)
{}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

bool Foam::dustPatchInjection::prepareForNextTimeStep
(
    const scalar time,
    label& newParcels,
    scalar& newVolumeFraction
)
{
    // Due before this gas step began
    const scalar passed =
        time - this->owner().db().time().deltaTValue() - this->SOI_;
    const scalar limit = min(passed, duration_);

    // Particle 0 is due at once; the tolerance is for times that are sums
    const scalar due =
        passed < -SMALL ? 0 : std::floor(limit*parcelsPerSecond_ + 1e-6) + 1;
    const label last = label
    (
        min
        (
            due,
            min
            (
                std::ceil(duration_*parcelsPerSecond_ - 1e-6),
                scalar(parcelsTotal_)
            )
        )
    );

    newParcels = max(last - next_, label(0));
    newVolumeFraction = 1;
    placed_.clear();
    placedDiameters_.clear();

    if (newParcels && gasVelocity_)
    {
        makeTriangles();
    }
    return newParcels && triangles_.size();
}


void Foam::dustPatchInjection::postInjectCheck
(
    const label parcelsAdded,
    const scalar massAdded
)
{
    // As the base class does, but without a message
    this->parcelsAddedTotal_ += returnReduce(parcelsAdded, sumOp<label>());
    this->massInjected_ += returnReduce(massAdded, sumOp<scalar>());
    this->time0_ = this->owner().db().time().value();
    ++this->nInjections_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dustPatchInjection::timeEnd() const
{
    return
        this->SOI_
      + min(duration_, scalar(parcelsTotal_)/parcelsPerSecond_);
}


Foam::label Foam::dustPatchInjection::parcelsToInject
(
    const scalar time0,
    const scalar time1
)
{
    return label(max(scalar(0), (time1 - time0)*parcelsPerSecond_));
}


Foam::scalar Foam::dustPatchInjection::volumeToInject
(
    const scalar time0,
    const scalar time1
)
{
    return time1 - time0;
}


void Foam::dustPatchInjection::setPositionAndCell
(
    const label,
    const label,
    const scalar,
    vector& position,
    label& cellOwner,
    label& tetFacei,
    label& tetPti
)
{
    // The owner is complete by now
    const dustCloud& cloud = dynamic_cast<const dustCloud&>(this->owner());
    const fvMesh& mesh = this->owner().mesh();
    const Time& time = this->owner().db().time();

    number_ = next_++;
    cellOwner = -1;
    tetFacei = -1;
    tetPti = -1;

    // Since it was due
    const scalar passed = max
    (
        scalar(0),
        time.value() - time.deltaTValue() - this->SOI_
      - number_/parcelsPerSecond_
    );

    for (label attempt = 0; attempt < 100; ++attempt)
    {
        random_ = Random(dustCloud::seed(seed_, number_, attempt));

        const scalar share = random_.sample01<scalar>();
        const triangle& t = *std::lower_bound
        (
            triangles_.begin(),
            triangles_.end() - 1,
            share,
            [](const triangle& a, const scalar s) { return a.cumulative < s; }
        );

        // Uniform in the triangle
        scalar a = random_.sample01<scalar>();
        scalar b = random_.sample01<scalar>();
        if (a + b > 1)
        {
            a = 1 - a;
            b = 1 - b;
        }
        d_ = sizes_->sample();
        U_ = t.U;

        position =
            t.vertices[0]
          + a*(t.vertices[1] - t.vertices[0])
          + b*(t.vertices[2] - t.vertices[0])
          + 0.5*d_*t.normal
          + passed*U_;

        // All of what follows is the same on all ranks
        word what;
        bool free = cloud.overlapAt(position, d_, what) < 0;

        forAll(placed_, i)
        {
            free =
                free
             && mag(placed_[i] - position)
              > 0.5*(placedDiameters_[i] + d_);
        }

        label rank = -1;
        if (free)
        {
            cellOwner = mesh.findCell(position);
            rank = cellOwner >= 0 ? Pstream::myProcNo() : -1;
            reduce(rank, maxOp<label>());
        }
        if (rank >= 0)
        {
            if (rank != Pstream::myProcNo())
            {
                cellOwner = -1;
            }
            placed_.append(position);
            placedDiameters_.append(d_);
            return;
        }
        ++redrawn_;
    }
    cellOwner = -1;
    ++leftOut_;

    if (leftOut_ == 1)
    {
        WarningInFunction
            << this->modelName() << ": no free place for particle "
            << number_ << " at patch " << patchName_ << " after 100 tries."
            << " It is left out; said once, the number is in"
            << " uniform/lagrangian" << endl;
    }
}


void Foam::dustPatchInjection::setProperties
(
    const label,
    const label,
    const scalar,
    parcelType& parcel
)
{
    parcel.U() = U_;
    parcel.d() = d_;

    // The cloud makes an identity of it
    parcel.origId() = number_;
}


#if OPENFOAM >= 2212
void Foam::dustPatchInjection::info()
{
    InjectionModel<cloudType>::info();
#else
void Foam::dustPatchInjection::info(Ostream& os)
{
    InjectionModel<cloudType>::info(os);
#endif

    if (this->writeTime())
    {
        this->setModelProperty("next", next_);
        this->setModelProperty("redrawn", redrawn_);
        this->setModelProperty("leftOut", leftOut_);
    }
}


// ************************************************************************* //
