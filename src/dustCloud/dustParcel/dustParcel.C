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

#include "dustParcel.H"
#include "Cloud.H"
#include "IOstreams.H"
#include "processorPolyPatch.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(dustParcel, 0);
    defineTemplateTypeNameAndDebug(Cloud<dustParcel>, 0);
}

Foam::string Foam::dustParcel::propertyList_ =
    Foam::dustParcel::propertyList();

const std::size_t Foam::dustParcel::sizeofFields
(
    offsetof(dustParcel, blob_) - offsetof(dustParcel, omega_)
);


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dustParcel::dustParcel
(
    const polyMesh& mesh,
    const barycentric& coordinates,
    const label celli,
    const label tetFacei,
    const label tetPti
)
:
    KinematicParcel<particle>(mesh, coordinates, celli, tetFacei, tetPti),
    omega_(Zero),
    x_(position()),
    state_(fresh),
    moved_(false),
    owed_(Zero),
    given_(Zero),
    response_(0),
    held_(false),
    loadHolds_(false),
    material_(-1),
    load_(scalar(0)),
    blob_(),
    demIndex_(-1),
    loaded_(false),
    since_(0),
    nonCoupled_(Zero),
    kick_(Zero)
{}


Foam::dustParcel::dustParcel
(
    const polyMesh& mesh,
    const vector& position,
    const label celli
)
:
    KinematicParcel<particle>(mesh, position, celli),
    omega_(Zero),
    x_(position),
    state_(fresh),
    moved_(false),
    owed_(Zero),
    given_(Zero),
    response_(0),
    held_(false),
    loadHolds_(false),
    material_(-1),
    load_(scalar(0)),
    blob_(),
    demIndex_(-1),
    loaded_(false),
    since_(0),
    nonCoupled_(Zero),
    kick_(Zero)
{}


Foam::dustParcel::dustParcel
(
    const polyMesh& mesh,
    Istream& is,
    bool readFields,
    bool newFormat
)
:
    KinematicParcel<particle>(mesh, is, readFields, newFormat),
    omega_(Zero),
    x_(Zero),
    state_(airborne),
    moved_(false),
    owed_(Zero),
    given_(Zero),
    response_(0),
    held_(false),
    loadHolds_(false),
    material_(-1),
    load_(scalar(0)),
    blob_(),
    demIndex_(-1),
    loaded_(false),
    since_(0),
    nonCoupled_(Zero),
    kick_(Zero)
{
    if (readFields)
    {
        if (is.format() == IOstream::ASCII)
        {
            is >> omega_ >> x_ >> state_ >> moved_ >> owed_ >> given_
                >> response_ >> held_ >> loadHolds_ >> material_ >> load_;
        }
        else
        {
            is.read(reinterpret_cast<char*>(&omega_), sizeofFields);
        }
        is >> blob_;
    }

    is.check(FUNCTION_NAME);
}


Foam::dustParcel::dustParcel(const dustParcel& p, const polyMesh& mesh)
:
    KinematicParcel<particle>(p, mesh),
    omega_(p.omega_),
    x_(p.x_),
    state_(p.state_),
    moved_(p.moved_),
    owed_(p.owed_),
    given_(p.given_),
    response_(p.response_),
    held_(p.held_),
    loadHolds_(p.loadHolds_),
    material_(p.material_),
    load_(p.load_),
    blob_(p.blob_),
    demIndex_(-1),
    loaded_(false),
    since_(0),
    nonCoupled_(Zero),
    kick_(Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dustParcel::endsAt(const polyPatch& pp)
{
    return
        isA<wallPolyPatch>(pp)
     || (!pp.coupled() && polyPatch::constraintType(pp.type()));
}


void Foam::dustParcel::displace(const scalar dt)
{
    const vector s(dt*U());
    const label celli = cell();

    track(s, 0);

    if (!onBoundaryFace())
    {
        x_ += s;
    }
    else if (isA<processorPolyPatch>(mesh().boundaryMesh()[patch()]))
    {
        x_ += s;
        moved_ = true;
    }
    else
    {
        relocate(x_, celli);
    }
}


// * * * * * * * * * * * * * * * Ostream Operator  * * * * * * * * * * * * * //

Foam::Ostream& Foam::operator<<(Ostream& os, const dustParcel& p)
{
    os << static_cast<const KinematicParcel<particle>&>(p);

    if (os.format() == IOstream::ASCII)
    {
        os  << token::SPACE << p.omega_
            << token::SPACE << p.x_
            << token::SPACE << p.state_
            << token::SPACE << p.moved_
            << token::SPACE << p.owed_
            << token::SPACE << p.given_
            << token::SPACE << p.response_
            << token::SPACE << p.held_
            << token::SPACE << p.loadHolds_
            << token::SPACE << p.material_
            << token::SPACE << p.load_;
    }
    else
    {
        os.write
        (
            reinterpret_cast<const char*>(&p.omega_),
            dustParcel::sizeofFields
        );
    }
    os << token::SPACE << p.blob_;

    os.check(FUNCTION_NAME);
    return os;
}


// ************************************************************************* //
