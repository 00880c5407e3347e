// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves the particles of one island over one particle step.
//
// Without a contact the island flies in closed form to its next touch. With one it takes
// contact steps of h = T/stepsPerContact, T the shortest period of its contacts as they are
// now, or shorter where stability asks for it (contactPeriod.hpp): many contacts on one light
// particle, strong dashpots. One contact step, v_n -> v_n+1:
//     x_n+1 = x_n + p1 v_n + p2 (b + F_n/m)              (freeFlight.hpp; b: gas, gravity)
//     v_h = e v_n + p1 b + (p1 - p2/h) F_n/m
//     F_n+1 from x_n+1 and the predictor v_h + (p2/h) F*/m,  F* = F_n
//     v_n+1 = v_h + (p2/h) F_n+1/m
// i.e. exact in the drag for a contact force that changes linearly, at any tau_p/h; without
// drag velocity Verlet (p1 = h, p2 = h^2/2). Of second order, damping included, where the
// force is smooth. Small islands, at steps well below the stability bound, keep that order
// where it is not, and take
//   - F* = F_n + (F_n - F_n-1)/2: with F_n dashpots take too much, with the whole
//     extrapolation as much too little;
//   - steps that end where a contact begins or ends, because the force jumps there;
//   - steps graded as h (t/tau)^(1/2), tau = T/16, where a force begins or ends with an
//     infinite slope (dashpots with overlap^(1/4), the end of a neck): t is the time since
//     overlap 0 or until the end, by the speed of now. The first of them is h^2/(4 tau).
// Proof: tests/verification/DEM/{convergence,pslRebound}.cpp, tests/unit/DEM/stability.cpp
//
// Candidates for new contacts are pairs whose boxes overlap. In an island of many the boxes are
// little more than the path that each has on its own, and grow when a particle leaves that.
// A candidate is looked at again when the fastest particle has gone half of its gap.
//
// Rest: a particle falls asleep, and is then a fixed boundary for those awake, when for a
// whole window (3 normal periods) it has had
//     kinetic energy < 0.1 F_C delta_C,  |force| < 0.1 F_C,
//     |torque| < max(0.02 F_C r, M_y)     (M_y: rolling yields)
// times restTolerance, F_C and delta_C the weakest of its contacts as softened, and when it
// holds on to a wall, directly or by particles at rest. (One that rocks, with less energy
// than would let it roll, has no damping: it counts as quiet after 30 windows.) It wakes when
// |force| > F_C/2 or |torque| > F_C r/2 times restTolerance, what its resting neighbours give
// to it included; when a contact of it ends; or when the gas force on it has changed by
// 0.1 min(F_C, M_y/r). Contacts between two that rest keep load and history. A cluster that
// flies is judged by its motion beyond that of a rigid body of the same momentum and angular
// momentum; at the end of the particle step it may become a RigidAggregate.
#pragma once

#include "contacts/ContactRecord.hpp"
#include "neighbourSearch/BoxGrid.hpp"
#include "particles/GasExchange.hpp"
#include "particles/GasLoad.hpp"
#include "particles/Particle.hpp"
#include "system/StepReport.hpp"
#include "timeIntegration/TimeSettings.hpp"
#include "walls/WallSearch.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace dem
{

class RigidAggregate;

//- Share of the weakest pull-off force, or moment that rolls over the radius, by which the load
//  on a particle at rest may change
inline constexpr double wakeForceChange = 0.1;

//- Whether a resting particle must wake because its gas load has changed, or because it was
//  moved from outside (negative wakeForce)
inline bool wakes(const RestState& rest, const GasLoad& gas)
{
    if (rest.wakeForce < 0) return true;
    const Vec3 now = gas.Sp*gas.Uc + gas.Su;
    const Vec3 then(rest.force[0], rest.force[1], rest.force[2]);
    return (now - then).squaredNorm() > rest.wakeForce*rest.wakeForce;
}

//- Where a particle is searched for: within width(t) of a point that flies at v from where the
//  particle begins. So near to it until something pushes it; then it gets away.
struct Corridor
{
    Vec3 v = Vec3::Zero();      // [m/s]
    double near = 1e30;         // [m]
    double from = 0;            // when it can first be pushed [s]
    double away = 0;            // how fast it then gets away, at most [m/s]

    double width(double t) const { return near + away*std::max(t - from, 0.0); }
};

class IslandIntegrator
{
public:

    IslandIntegrator
    (
        const MaterialTable& materials,
        const TimeSettings& time,
        const WallSearch& walls,
        const Periodic& periodic
    );

    // Loading, in this order: particles, their wall surfaces, contacts

        void clear();

        //- Particles in order of id. corridor: where it can get in this step
        void addParticle
        (
            const Particle& p, const GasLoad& g, const RestState& rest,
            const Corridor& corridor = {}
        );

        //- Surfaces that the last particle can reach in this step
        void addSurfaces(const std::vector<int>& surfaces);

        //- A contact of particle i (with local particle j, or with a wall: j = -1)
        void addContact(int i, int j, const ContactRecord& record);


    //- Move everything over dt; time [s] is only for messages. Errors: numericalError
    void run(double dt, double time, StepReport& report);


    // Results

        std::size_t size() const { return particles_.size(); }
        const Particle& particle(int i) const { return particles_[std::size_t(i)]; }
        const Vec3& gasImpulse(int i) const { return impulse_[std::size_t(i)]; }

        //- Of all particles, over the last run(), which was over dt
        std::vector<GasExchange> gasExchange(double dt) const;

        const RestState& rest(int i) const { return rest_[std::size_t(i)]; }

        //- How fast particle i has left its corridor, on average since it began [m/s]; 0: it
        //  has not
        double outran(int i) const { return outran_[std::size_t(i)]; }

        //- Contacts of particle i as the lower partner
        std::vector<ContactRecord> contacts(int i) const;


private:

    struct Candidate
    {
        int i, j;
        bool touching;
        double touch;       // contact begins at this gap of the surfaces [m]
    };

    //- Where a particle may be until candidates are looked for again
    struct Roam
    {
        Corridor corridor;
        bool all;           // its box holds all of that
    };

    //- A candidate within the skin, and the value of path_ up to which it need not be looked at
    struct Near
    {
        int candidate;
        double due;
    };

    //- A contact that is not in a list: of a sleeping cluster, or before and after run()
    struct Stored
    {
        int j;              // local partner, -1 = wall
        ContactRecord record;
    };

    //- What a list entry refers to, by its tag
    struct Entry
    {
        int candidate;      // pairs: index into candidates_
        int materialJ;
        double neck;        // the contact ends at overlap -neck [m]
        double edge;        // overlap about which steps are graded [m]
        double pullOff;     // [N]
        RollingYield yield;
        double a0, R, m;
        double turning;     // (r_i/I_i + r_j/I_j)/2 [1/(kg m)]

        // In dense islands: its bound, which holds up to this overlap [m] and between these
        // speeds [m/s]; boundSpeed < 0: not known
        ContactBound bound;
        double boundOverlap, boundSpeed, slowest;
    };

    struct LawLists
    {
        ContactList pairs, walls;
    };

    //- Weakest contact of a particle, for the rest criterion
    struct Weakest
    {
        double pullOff, delta;
        RollingYield yield;
    };

    //- Velocities before the kick that still is to come (complete()); otherwise as in Body
    struct alignas(64) Motion
    {
        double v[3], invM;      // [m/s], [1/kg]
        double w[3], invI;      // [rad/s], [1/(kg m2)]
    };

    //- What a force and a torque make of the second kick [s/kg], [s/(kg m2)]
    struct Push { double v, w; };

    //- Flight over the current h, per particle
    struct Flight
    {
        double e, p1, p2, early, late;
        double eSpin, earlySpin, lateSpin;
        double b[3];                        // [m/s2]
        double driven[3], drivenSpin[3];    // what the gas adds over h [m/s], [rad/s]
    };

    //- Of all contacts of one particle, see contactPeriod.hpp
    struct Sums
    {
        double stiffness = 0, damping = 0;
        double rolling = 0, rollingDamping = 0;
        double twisting = 0, twistingDamping = 0;
    };

    // Contacts
    void contactConstants(int i, int j, int patch, int materialJ, double* c) const;
    void begin(int i, int j, int patch, int candidate, const ContactRecord* record);
    void remove(ContactList& list, std::size_t k);
    void store(const ContactList& list, std::size_t k, bool wall);
    bool endMarked(StepReport& report);
    bool follows(int i, const Vec3& n) const;
    bool form(StepReport& report);
    void findCandidates(double dt);
    void addCandidate(int i, int j);
    void keepInBoxes(double time);
    void widen(int i, const Box& path);
    int findCandidate(int i, int j) const;
    void activateStored();
    void activateStored(std::size_t i);
    void wake(std::vector<int>& woken, StepReport& report);
    void wakeLoaded(StepReport& report);
    void findBoundary();
    Load storedLoad(int i);

    // Stepping
    void step(double h, double next, StepReport& report);
    void foresee(double h);

    // Energy ledger
    ContactEnergy energyOf(std::size_t law, const ContactList& list, std::size_t k) const;
    double dashpotBetween
    (
        std::size_t law, const ContactList& list, std::size_t k,
        const ContactEnergy& before, const ContactEnergy& after, double h
    ) const;
    template<class Moving> double kinetic(const std::vector<Moving>& moving) const;
    void openLedger(double h, EnergyLedger& ledger);
    void closeLedger(double h, EnergyLedger& ledger);
    void prepareSprings(double h);
    template<bool gas> double drift(double h);
    void complete();
    Push pushOf(std::size_t k, double h) const;
    void setFlight(double h);
    bool evaluate(const SpringStep& step, StepReport& report);
    double mass(std::size_t i) const { return particles_[i].mass; }
    double inertia(std::size_t i) const;
    void updateWalls();
    void refreshNear();
    void noteOutran();
    void findNearSurfaces(int i);
    ContactBound contactBound
    (
        std::size_t l, const ContactList& list, std::size_t k, double overlap, double speed
    ) const;
    void addToSums(const ContactList& list, std::size_t k, const ContactBound& b);
    Sums mostOfSums() const;
    static double boundOf(const Sums& most);
    double boundNow();
    double longestStep() const;
    double contactStep(double time, StepReport& report);
    double meetingStep(double h, int looks) const;
    Vec3 acceleration(int i) const;
    double stiffestStep(double speed) const;
    double timeToTouch(bool contact) const;
    double gradedStep(double h, double& end) const;
    void checkRest(double elapsed, StepReport& report);
    void rests(std::size_t k, double since);
    void judge
    (
        std::size_t k, double energy, double force, double torque, double elapsed
    );
    double wakeForceOf(std::size_t k) const;
    void findFlying();
    template<class F> void forFlying(F&& f);
    void freezeFlying(StepReport& report);
    double gap(const Candidate& c) const;
    bool meets(const Candidate& c) const;
    bool comesNear(int candidate);
    double wallTouch(int i, int patch) const;
    double accelerationBound(int i) const;
    bool anyContact() const;
    void fail(const std::string& what, int i, int j, double time) const;

    const MaterialTable& materials_;
    TimeSettings time_;
    const WallSearch& wallSearch_;
    const Periodic& periodic_;

    std::vector<Particle> particles_;
    std::vector<GasLoad> gas_;
    std::vector<RestState> rest_;
    std::vector<Vec3> impulse_;
    std::vector<double> reach_;             // longest neck [m]
    std::vector<double> outran_;            // [m/s]
    std::vector<std::vector<Stored>> stored_;
    std::vector<Roam> roam_;
    std::vector<Box> boxes_;                // that the particles stay within, surfaces included
    std::unique_ptr<BoxGrid> grid_;         // of boxes_; none for few particles
    std::vector<Candidate> candidates_;     // two that can touch, i < j
    std::size_t sorted_ = 0;                // so many of them by i, then j
    std::vector<std::size_t> surfaceEnd_;   // of each particle in surfaces_
    std::vector<int> surfaces_;

    std::vector<Body> bodies_;
    std::vector<Motion> motion_;
    std::vector<Load> loads_;
    std::vector<Load> previousLoads_, lastLoads_;   // small islands only
    std::vector<Motion> kicked_;            // for the ledger
    std::vector<Flight> flight_;
    std::vector<int> awake_;
    std::vector<LawLists> lists_;           // by law
    std::vector<Entry> entries_;
    std::vector<int> freeEntries_;
    std::vector<ContactEnergy> energies_;   // by tag, before the step
    std::vector<double> due_;               // by candidate: no touch before path_ is that [m]
    std::vector<Near> near_;                // candidates within the skin
    std::vector<std::vector<int>> nearSurfaces_;
    std::vector<int> nearWalls_;            // awake, with near surfaces
    std::vector<std::vector<WallHit>> hits_;
    std::vector<std::vector<char>> hitTaken_;
    std::vector<Weakest> weakest_;
    std::vector<std::pair<int, int>> flying_;   // cluster without a hold, particle
    std::vector<char> flies_;                   // by particle: it is in one of them
    double window_ = 0;                         // [s] for the rest criterion
    std::vector<int> boundary_;             // at rest, in contact with one that is awake
    std::vector<Load> frozen_;              // of those at rest: from contacts at rest
    std::vector<char> frozenKnown_;         // frozen_ holds for the contacts stored now
    std::vector<char> marked_;              // scratch, all 0 between calls
    std::vector<int> woken_;
    std::vector<std::vector<int>> holders_; // of stored pair contacts, by higher partner
    ContactList scratch_;
    std::vector<std::vector<double>> wallTouch_;    // [m], by material and patch

    std::vector<Sums> sums_;
    std::vector<Vec3> accelerations_;
    double period_ = 0;         // [s] shortest at the last look
    double bound_ = 0;          // [s] stability bound of the step then
    double springLead_ = 0.5;   // share of a step by which springs are ahead of the loads
    double ahead_ = 0;          // [s] that is
    double owed_ = 0;           // [s] step of which the second kick is still to come
    bool ended_ = false;        // evaluate() has found contacts that end
    double contactStep_ = 0;    // [s] as it is now, 0 = not known
    double previousStep_ = 0;   // [s] from previousLoads_ to loads_; 0 = there are none
    double flightStep_ = -1;    // h that flight_ is made for
    double skin_ = 0;           // [m] how far beyond touch near_ looks
    double left_ = 0;           // [s] of this run
    double elapsed_ = 0;        // [s] of this run
    double path_ = 0;           // [m] that the fastest at each time has made since run()
    double refreshed_ = 0;      // [m] path_ at refreshNear()
    double fastest_ = 0;        // [m/s]
    double strongest_ = 0;      // [m/s2] acceleration at the last look
    bool deep_ = false;         // an overlap comes near what laws cover
    double smallest_ = 0;       // [m] radius
    bool vacuum_ = false;       // no gas force on any particle
    bool refined_ = false;      // small islands well below the bound
    bool exactEvents_ = true;   // end steps where contacts begin and end
};

}
