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
#include "cellCrossing.H"
#include "injectorPast.H"

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

    bounds_ = boundBox();
    fastest_ = 0;
    for (triangle& t : triangles_)
    {
        t.cumulative /= sum;
        fastest_ = max(fastest_, mag(t.U));
        for (const point& x : t.vertices)
        {
            bounds_.add(x);
            bounds_.add(x + 0.5*sizes_->maxValue()*t.normal);
        }
    }
    findCrossing(velocities[0]);
}


void Foam::dustPatchInjection::findCrossing(const vectorField& U)
{
    const fvMesh& mesh = this->owner().mesh();
    const labelUList& cells = mesh.boundary()[patchID_].faceCells();
    const vectorField& Sf = mesh.boundary()[patchID_].Sf();

    crossing_ = 0;
    forAll(cells, facei)
    {
        if (gasVelocity_ && (U[facei] & Sf[facei]) >= 0)
        {
            continue;
        }
        const label celli = cells[facei];
        crossing_ = max(crossing_, cellCrossing(mesh, celli, U[facei]));
        crossing_ =
            max(crossing_, cellCrossing(mesh, celli, this->owner().U()[celli]));
    }
    reduce(crossing_, maxOp<scalar>());
}


void Foam::dustPatchInjection::checkInput(const dictionary& dict) const
{
    if (patchID_ < 0)
    {
        wordList names;
        for (const polyPatch& pp : this->owner().mesh().boundaryMesh())
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
    const auto positive = [&dict](const word& keyword, const scalar value)
    {
        if (!(value > 0 && std::isfinite(value)))
        {
            dustProperties::error
            (
                dict,
                keyword,
                "is " + Foam::name(value),
                "a positive number"
            );
        }
    };
    positive("duration", dict.lookupOrDefault<scalar>("duration", GREAT));
    positive
    (
        "parcelsTotal",
        scalar(dict.lookupOrDefault<label>("parcelsTotal", labelMax))
    );
}


Foam::injectionClock Foam::dustPatchInjection::makeClock
(
    const dictionary& dict
)
{
    const scalar duration = dict.lookupOrDefault<scalar>("duration", GREAT);
    const label total = dict.lookupOrDefault<label>("parcelsTotal", labelMax);
    const scalar SOI = this->SOI_;
    const scalar now = this->owner().db().time().value();
    const injectorPast past
    (
        this->dict(), this->modelName(), typeName,
        this->owner().outputProperties(), this->owner().db().time()
    );
    const scalar started =
        this->template getModelProperty<scalar>("start", GREAT) + past.shift();

    const auto clock = [&](const scalar start, const scalar offset)
    {
        return injectionClock
        (
            start, rate_.value(), rate_.profile(), rate_.perParticle(), offset,
            start + duration, total
        );
    };

    if (known())
    {
        const bool sameUnit =
            this->template getModelProperty<word>("rateKeyword", "")
         == rate_.keyword();
        const bool sameStart =
            this->template getModelProperty<scalar>("SOI") == SOI;
        before_ =
            !rate_.byMass() ? scalar(next_)
          : sameUnit ? this->template getModelProperty<scalar>("before")
          : 0;
        if
        (
            sameStart
         && sameUnit
         && this->template getModelProperty<scalar>("rate") == rate_.value()
         && this->template getModelProperty<word>("profile", "") == rate_.digest()
        )
        {
            return clock
            (
                started,
                this->template getModelProperty<scalar>("offset")
            );
        }
        const scalar from = max(SOI, now);
        injectionClock changed(clock(sameStart ? started : from, 0));
        changed.setDue(before_, from);
        Info<< "Injector " << this->modelName() << ": SOI or the rate are not"
            << " as they were; particle " << next_ << " is due at "
            << changed.due(before_) << " s" << nl << endl;
        return changed;
    }
    if (SOI < now && !next_)
    {
        Info<< "Injector " << this->modelName() << ": SOI " << SOI
            << " s is before the start; injection begins at " << now << " s"
            << nl << endl;
    }
    return clock(next_ ? SOI : max(SOI, now), 0);
}


Foam::dictionary Foam::dustPatchInjection::completed(const dictionary& dict)
{
    dictionary full(dict);
    full.set("parcelBasisType", word("fixed"));
    full.set("nParticle", 1);
    full.set("massTotal", 0);
    if (!full.found("SOI"))
    {
        full.set("SOI", 0);
    }
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
    gasVelocity_(false),
    U0_(Zero),
    seed_(dict.lookupOrDefault<label>("seed", 1)),
    random_(0),
    sizes_(distributionModel::New(dict.subDict("sizeDistribution"), random_)),
    fastest_(0),
    crossing_(0),
    rate_(dict, dustProperties(owner.particleProperties())),
    key_(this->template getModelProperty<label>("key", -1)),
    next_(this->template getModelProperty<label>("next")),
    before_(0),
    redrawn_(this->template getModelProperty<label>("redrawn")),
    leftOut_(this->template getModelProperty<label>("leftOut")),
    withoutFlow_(this->template getModelProperty<label>("withoutFlow")),
    clock_(makeClock(dict))
{
    checkInput(dict);

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
    gasVelocity_(im.gasVelocity_),
    U0_(im.U0_),
    seed_(im.seed_),
    random_(0),
    sizes_(im.sizes_.clone()),
    triangles_(im.triangles_),
    bounds_(im.bounds_),
    fastest_(im.fastest_),
    crossing_(im.crossing_),
    rate_(im.rate_),
    key_(im.key_),
    next_(im.next_),
    before_(im.before_),
    redrawn_(im.redrawn_),
    leftOut_(im.leftOut_),
    withoutFlow_(im.withoutFlow_),
    clock_(im.clock_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dustPatchInjection::check(const bool gasFrozen) const
{
    bool outward = flows() && !gasVelocity_;
    for (const triangle& t : triangles_)
    {
        outward = outward && (U0_ & t.normal) < 0;
    }
    if (outward)
    {
        dustProperties::error
        (
            this->dict(),
            "U0",
            "leads out of the domain through patch " + patchName_,
            "a velocity into the domain"
        );
    }
    if (flows() || !has())
    {
        return;
    }
    const string reason("no gas flows in through patch " + patchName_);
    if (gasFrozen)
    {
        dustProperties::error
        (
            this->dict(),
            "U0",
            reason + ", and the gas is frozen: nothing would enter",
            "a patch where gas flows in, or a velocity (Ux Uy Uz) in m/s"
        );
    }
    Info<< "Injector " << this->modelName() << ": " << reason.c_str()
        << " at the start; nothing enters until it does" << nl << endl;
}


void Foam::dustPatchInjection::newGas()
{
    if (gasVelocity_)
    {
        makeTriangles();
    }
    else
    {
        findCrossing
        (
            vectorField(this->owner().mesh().boundary()[patchID_].size(), U0_)
        );
    }
}


void Foam::dustPatchInjection::draw
(
    const label number,
    const label attempt,
    point& x,
    scalar& d,
    vector& U
) const
{
    // Its size is the same wherever it is put: large ones need more attempts,
    // and would become rare
    d = diameter(number);
    random_ = Random(dustCloud::seed(seed_, number, attempt));

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
    U = t.U;
    x =
        t.vertices[0]
      + a*(t.vertices[1] - t.vertices[0])
      + b*(t.vertices[2] - t.vertices[0])
      + 0.5*d*t.normal;
}


Foam::scalar Foam::dustPatchInjection::diameter(const label number) const
{
    // Of the same row of numbers as its first place, which takes three
    random_ = Random(dustCloud::seed(seed_, number, 0));
    for (label i = 0; i < 3; ++i)
    {
        random_.sample01<scalar>();
    }
    return sizes_->sample();
}


void Foam::dustPatchInjection::pass()
{
    before_ += rate_.byMass() ? rate_.mass(diameter(next_)) : 1;
    ++next_;
}


void Foam::dustPatchInjection::passWithoutFlow()
{
    if (++withoutFlow_ == 1)
    {
        WarningInFunction
            << this->modelName() << ": no gas flows in through patch "
            << patchName_ << " at " << due() << " s, when particle "
            << next_ << " is due. It is left out, and so is what is due before"
            << " gas flows in; said once, the number is in the verdict" << endl;
    }
    pass();
}


void Foam::dustPatchInjection::leaveOut(const label number)
{
    if (++leftOut_ == 1)
    {
        WarningInFunction
            << this->modelName() << ": no free place for particle "
            << number << " at patch " << patchName_ << " after 100 tries."
            << " It is left out; said once, the number is in the verdict"
            << endl;
    }
}


void Foam::dustPatchInjection::count()
{
    ++this->parcelsAddedTotal_;
    this->time0_ = this->owner().db().time().value();
}


Foam::scalar Foam::dustPatchInjection::timeEnd() const
{
    return clock_.end();
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
        this->setModelProperty("type", word(typeName));
        this->setModelProperty("time", this->owner().db().time().value());
        this->setModelProperty("key", key_);
        this->setModelProperty("next", next_);
        this->setModelProperty("redrawn", redrawn_);
        this->setModelProperty("leftOut", leftOut_);
        this->setModelProperty("withoutFlow", withoutFlow_);
        this->setModelProperty("before", before_);
        this->setModelProperty("start", scalar(clock_.start()));
        this->setModelProperty("offset", scalar(clock_.offset()));
        this->setModelProperty("rate", rate_.value());
        this->setModelProperty("rateKeyword", rate_.keyword());
        this->setModelProperty("profile", rate_.digest());
        this->setModelProperty("SOI", this->SOI_);
    }
}


// ************************************************************************* //
