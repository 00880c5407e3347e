// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one table of contact laws. To add a normal law: write normal/<law>.hpp, instantiate
// it in normal/<law>.cpp, add a row to normalTable() below and a test. Other parts: see
// newComposite.hpp.
#include "contactModels/contactModel/contactModelTable.hpp"

#include "contactModels/contactModel/ContactLaw.hpp"
#include "contactModels/contactModel/none.hpp"
#include "contactModels/normal/DMT.hpp"
#include "contactModels/normal/Hertz.hpp"
#include "contactModels/normal/JKR.hpp"
#include "contactModels/normal/cohesivePlastic.hpp"
#include "contactModels/normal/simplifiedJKR.hpp"
#include "contactModels/normal/vanDerWaals.hpp"
#include "contactModels/rolling/bending.hpp"
#include "contactModels/rolling/springSlider.hpp"
#include "contactModels/tangential/springDashpotSlider.hpp"
#include "contactModels/twisting/cappedSpring.hpp"
#include "contactModels/twisting/springDashpotSlider.hpp"
#include "particles/errors.hpp"

#include <algorithm>
#include <iterator>

namespace dem
{

template<class Normal>
std::unique_ptr<ContactLaw> newComposite(const ContactSettings&);

namespace
{

struct NormalRow
{
    const char* model;
    std::unique_ptr<ContactLaw> (*make)(const ContactSettings&);
    std::vector<PartKeyword> (*keywords)();
};

template<class Normal>
NormalRow row()
{
    return {Normal::model, &newComposite<Normal>, &Normal::keywords};
}

const std::vector<NormalRow>& normalTable()
{
    static const std::vector<NormalRow> table
    {
        row<normal::Hertz>(),
        row<normal::simplifiedJKR>(),
        row<normal::JKR>(),
        row<normal::DMT>(),
        row<normal::vanDerWaals>(),
        row<normal::cohesivePlastic>()
    };
    return table;
}

template<class Part>
PartEntry entry(const char* kind)
{
    return {kind, Part::model, Part::keywords()};
}

//- Model and keywords of one part; what its keywords may say, the part itself checks
void checkPart(const char* kind, const PartSettings& part)
{
    std::string list;
    for (const PartEntry& e : contactModelTable())
    {
        if (e.kind == kind)
        {
            if (e.model == part.model)
            {
                PartInput(kind, part, e.keywords);
                return;
            }
            list += (list.empty() ? "" : " ") + e.model;
        }
    }
    throw inputError
    (
        std::string(kind) + "/model", "unknown model " + part.model, list
    );
}

}


const std::vector<PartEntry>& contactModelTable()
{
    static const std::vector<PartEntry> table = []
    {
        std::vector<PartEntry> t;
        for (const NormalRow& r : normalTable())
        {
            t.push_back({"normal", r.model, r.keywords()});
        }
        t.push_back(entry<none>("tangential"));
        t.push_back(entry<tangential::springDashpotSlider>("tangential"));
        t.push_back(entry<none>("rolling"));
        t.push_back(entry<rolling::springSlider>("rolling"));
        t.push_back(entry<rolling::bending>("rolling"));
        t.push_back(entry<none>("twisting"));
        t.push_back(entry<twisting::springDashpotSlider>("twisting"));
        t.push_back(entry<twisting::cappedSpring>("twisting"));
        return t;
    }();
    return table;
}


ContactSettings withoutAdhesion(ContactSettings s)
{
    s.normal.model = normal::Hertz::model;
    const std::vector<PartKeyword> known = normal::Hertz::keywords();
    for (auto v = s.normal.values.begin(); v != s.normal.values.end();)
    {
        const bool kept = std::any_of(known.begin(), known.end(), [&](const PartKeyword& k)
        {
            return k.name == v->first;
        });
        v = kept ? std::next(v) : s.normal.values.erase(v);
    }
    s.rolling = PartSettings();
    if (s.twisting.model == twisting::cappedSpring::model) s.twisting = PartSettings();
    return s;
}


ContactSettings mirrorSettings()
{
    ContactSettings s;
    s.normal = {normal::Hertz::model, {{"restitution", 1}}};
    s.surfaceEnergy = 0;
    return s;
}


std::unique_ptr<ContactLaw> newContactLaw(const ContactSettings& s)
{
    checkPart("normal", s.normal);
    checkPart("tangential", s.tangential);
    checkPart("rolling", s.rolling);
    checkPart("twisting", s.twisting);

    for (const NormalRow& r : normalTable())
    {
        if (s.normal.model == r.model) return r.make(s);
    }
    return nullptr;     // not reached: checkModel has thrown
}

}
