// SPDX-License-Identifier: GPL-3.0-or-later
#include "island/Island.hpp"

#include "island/shareOfGas.hpp"

#include <algorithm>

namespace dem
{

Island::Island
(
    const MaterialTable& materials,
    const TimeSettings& time,
    const WallSearch& walls,
    const Periodic& periodic
)
:
    env_{materials, time, walls, periodic},
    contacts_(env_),
    candidates_(env_),
    boundary_(env_, contacts_),
    forces_(env_),
    control_(env_),
    rest_(env_),
    account_(env_)
{
    contacts_.setUp(state_.contacts);
}


// * * * * * * * * * * * * * * * * * The loop * * * * * * * * * * * * * * * * * * * * * //

void Island::run(const Span& span, StepReport& report)
{
    begin(span);
    if (span.uncut) mark(report);
    firstContacts(report);
    while (control_.left() > 0 && !state_.awake.empty() && !rimWoke_)
    {
        const Step step = control_.next(state_, propagator_, candidates_, report);
        take(step, report);
        control_.took(state_, step);

        // what begins after a flight must not act over all of it
        if (control_.exactEvents() || step.flight) propagator_.complete(state_);
        wake(rest_.overloaded(state_, boundary_.list()), report);
        if (rimWoke_) break;
        if (update(report).any())
        {
            propagator_.forgetLoads();
            control_.event();
        }
        if (rimWoke_) break;
        settle(report);
    }
    if (rimWoke_) candidates_.noteOutran(state_);
    else finish(span, report);
}


//- One step but for its second kick
void Island::take(const Step& step, StepReport& report)
{
    prepareSprings(step.springLead*step.h);
    if (account_.on())
    {
        propagator_.complete(state_);
        account_.open(state_, step.h, report.energy);
    }
    propagator_.drift(state_, step.h, step.refined);
    account_.drifted(state_, report.energy);
    candidates_.follow(state_, step.h, control_.contactStep());
    if (step.refined) propagator_.foresee(state_, step.h);

    boundary_.load(state_);
    const double ahead = step.springLead*step.next;
    ended_ = forces_.evaluate(state_, {step.h, step.h - state_.phase.ahead, ahead}, report);
    state_.phase.owed = step.h;
    if (!account_.on()) return;
    propagator_.complete(state_);
    account_.close(state_, step.h, report.energy);
    if (!state_.contacts.anyListed()) return;
    report.maxStepOverBound =
        std::max(report.maxStepOverBound, step.h/control_.boundNow(state_));
}


//- Let the springs be ahead by this [s]; loads are unchanged
void Island::prepareSprings(double ahead)
{
    if (ahead == state_.phase.ahead) return;
    propagator_.complete(state_);
    forces_.moveSprings(state_, ahead);
}


// * * * * * * * * * * * * * * * * * Contacts * * * * * * * * * * * * * * * * * * * * * //

Changes Island::update(StepReport& report)
{
    Changes changes;
    if (ended_) endContacts(changes, report);
    if (!rimWoke_) beginContacts(changes, report);
    return changes;
}


//- End the contacts that the forces have marked; their load is taken back
void Island::endContacts(Changes& changes, StepReport& report)
{
    ended_ = false;
    if (control_.exactEvents()) propagator_.complete(state_);
    account_.ended(state_, report.energy);
    forces_.takeBackEnded(state_);
    changes.ended = contacts_.end(state_);
    // What has been taken back is as it is at the step's end: in a flight, which may be long, the
    // difference must not act
    if (!state_.contacts.anyListed())
    {
        for (const int i : state_.awake) state_.loads[std::size_t(i)] = Load{};
    }
    report.separations += std::int64_t(changes.ended.size());
    candidates_.parted(state_, changes.ended);
    std::vector<int> bereft = rest_.bereft(state_, changes.ended);
    if (!bereft.empty()) wake(std::move(bereft), report);
    else if (!changes.ended.empty()) boundary_.find(state_, candidates_.walls());
}


//- Begin contacts where surfaces have met; their load is added
void Island::beginContacts(Changes& changes, StepReport& report)
{
    changes.began = candidates_.meet(state_);
    if (changes.began.empty()) return;
    if (control_.exactEvents()) propagator_.complete(state_);
    if (!state_.contacts.anyListed()) mark(report);
    noteTouches(changes.began, report);
    forces_.noteSizes(state_);
    contacts_.begin(state_, changes.began);
    boundary_.find(state_, candidates_.walls());
    forces_.addNew(state_);
    if (!account_.on()) return;
    forces_.eachNew(state_, [&](std::size_t l, const ContactList& list, std::size_t k)
    {
        account_.began(state_, l, list, k, report.energy);
    });
}


WallImpact Island::impact(const Touch& touch) const
{
    const std::size_t i = std::size_t(touch.i);
    const Body& a = state_.bodies[i];
    WallImpact h;
    h.id = state_.particles[i].id;
    h.patch = touch.patch;
    h.time = control_.now();
    h.x = vec(a.x);
    h.v = vec(a.v);
    h.omega = vec(a.w);
    h.n = touch.n;
    return h;
}


void Island::noteTouches(const std::vector<Touch>& touches, StepReport& report) const
{
    for (const Touch& t : touches)
    {
        const Body& a = state_.bodies[std::size_t(t.i)];
        double speed;
        if (t.j < 0)
        {
            speed = vec(a.v).dot(t.n);
            if (!env_.mirrors(t.patch))
            {
                report.followerTouches += follows(state_, t.i, t.n);
                if (env_.walls.walls().reportImpacts) report.wallImpacts.push_back(impact(t));
            }
        }
        else
        {
            const Body& b = state_.bodies[std::size_t(t.j)];
            const Vec3 v = vec(a.v) - vec(b.v);
            speed = v.dot(env_.periodic.nearest(vec(b.x) - vec(a.x)).normalized());
        }
        ++report.touches;
        report.touchSpeed += speed;
        report.touchSpeedSquare += speed*speed;
    }
}


// * * * * * * * * * * * * * * * * * * Rest * * * * * * * * * * * * * * * * * * * * * * //

bool Island::findAtRim(const std::vector<int>& woken)
{
    for (const int i : woken)
    {
        const std::size_t k = std::size_t(i);
        if (!rim_[k]) continue;
        wokeAtRim_[k] = 1;
        rimWoke_ = true;
    }
    return rimWoke_;
}


//- Loads are as they were: what the frozen contacts gave, they go on giving
void Island::wake(std::vector<int> woken, StepReport& report)
{
    if (woken.empty() || findAtRim(woken)) return;
    propagator_.complete(state_);
    rest_.wake(state_, woken, report);
    propagator_.awakeChanged();
    const std::vector<Partners> resumed = contacts_.resume(state_, woken);
    candidates_.woken(state_, woken, resumed);
    boundary_.find(state_, candidates_.walls());
}


//- Let those fall asleep that have been quiet, if it is time to look
void Island::settle(StepReport& report)
{
    const std::optional<double> since = control_.restDue();
    if (!since) return;
    propagator_.complete(state_);
    if (!rest_.judge(state_, *since)) return;
    prepareSprings(0);
    if (!rest_.fallAsleep(state_, account_, report)) return;
    contacts_.putToRest(state_);
    candidates_.asleep(state_);
    boundary_.find(state_, candidates_.walls());
}


// * * * * * * * * * * * * * * * * Begin and end  * * * * * * * * * * * * * * * * * * * //

void Island::begin(const Span& span)
{
    state_.phase = {};
    ended_ = rimWoke_ = false;
    marked_ = atStart_ = false;
    ahead_ = span.ahead;
    behind_ = 0;
    wokeAtRim_.assign(state_.particles.size(), 0);
    setBodies(state_);
    boundary_.begin(state_);
    rest_.begin(state_);
    propagator_.begin(state_);
    candidates_.find(state_, span.dt, contacts_.resumeAll(state_));
    control_.begin(state_, candidates_, span);
    candidates_.refresh(state_, {});
}


void Island::firstContacts(StepReport& report)
{
    std::vector<int> disturbed = rest_.disturbed(state_);
    if (disturbed.empty()) boundary_.find(state_, candidates_.walls());
    else wake(std::move(disturbed), report);
    if (rimWoke_) return;
    boundary_.load(state_);
    ended_ = forces_.evaluate(state_, {}, report);
    update(report);
}


void Island::mark(const StepReport& report)
{
    if (ahead_ == 0 || !control_.exactEvents()) return;
    marked_ = true;
    mark_ = state_;
    markReport_ = report;
}


bool Island::nearMark() const
{
    return std::all_of
    (
        state_.awake.begin(), state_.awake.end(), [&](int i)
        {
            const Body& b = state_.bodies[std::size_t(i)];
            return (vec(b.x) - vec(mark_.bodies[std::size_t(i)].x)).norm() < b.r;
        }
    );
}


void Island::goBack(StepReport& report)
{
    if (!marked_ || !state_.contacts.anyListed() || !nearMark()) return;
    behind_ = state_.phase.elapsed - mark_.phase.elapsed;
    atStart_ = mark_.phase.elapsed == 0;
    std::swap(state_, mark_);
    report = markReport_;
}


void Island::finish(const Span& span, StepReport& report)
{
    propagator_.complete(state_);
    candidates_.noteOutran(state_);
    goBack(report);
    if (atStart_) return;
    control_.finish(state_, candidates_, report);
    rest_.addImpulse(state_, span.dt - behind_);
    prepareSprings(0);
    if (ahead_ == 0) rest_.freezeFlying(state_, account_, report);
    contacts_.storeAll(state_);
    takeBack();
    checkFinite(state_, span.now + span.dt);
}


void Island::takeBack()
{
    for (RestState& r : state_.rest) r.inContact = false;
    for (std::size_t i = 0; i < state_.particles.size(); ++i)
    {
        for (const StoredContact& s : state_.contacts.stored[i])
        {
            state_.rest[i].inContact = true;
            if (s.j >= 0) state_.rest[std::size_t(s.j)].inContact = true;
        }
        Particle& p = state_.particles[i];
        const Body& b = state_.bodies[i];
        p.x = vec(b.x);
        p.v = vec(b.v);
        p.omega = vec(b.w);
    }
}


void Island::clear()
{
    state_.particles.clear();
    state_.gas.clear();
    state_.reach.clear();
    state_.rest.clear();
    state_.impulse.clear();
    rim_.clear();
    ContactStore& store = state_.contacts;
    for (ContactStore::Lists& l : store.lists)
    {
        l.pairs.clear();
        l.walls.clear();
    }
    store.entries.clear();
    store.freeTags.clear();
    store.stored.clear();
    candidates_.clear();
}


void Island::addParticle
(
    const Particle& p, const GasLoad& g, const RestState& rest, const Corridor& corridor,
    bool rim
)
{
    rim_.push_back(rim);
    state_.particles.push_back(p);
    state_.gas.push_back(g);
    state_.reach.push_back(env_.materials.reach(p.material, p.radius, env_.walls.walls()));
    state_.rest.push_back(rest);
    state_.impulse.push_back(Vec3::Zero());
    state_.contacts.stored.emplace_back();
    candidates_.addParticle(corridor);
}


void Island::addSurfaces(const std::vector<int>& surfaces)
{
    candidates_.addSurfaces(surfaces);
}


void Island::addContact(int i, int j, const ContactRecord& record)
{
    state_.contacts.stored[std::size_t(i)].push_back({j, record});
}


std::vector<ContactRecord> Island::contacts(int i) const
{
    std::vector<ContactRecord> result;
    for (const StoredContact& s : state_.contacts.stored[std::size_t(i)])
    {
        result.push_back(s.record);
    }
    return result;
}


std::vector<GasExchange> Island::gasExchange(double dt) const
{
    return shareOfGas(state_, dt);
}

}
