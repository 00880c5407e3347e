// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one table of contact laws. To add a normal law: write normal/<law>.hpp, instantiate
// it in normal/<law>.cpp, add a row to normalTable() below and a test.
#include "contactModels/contactModel/contactModelTable.hpp"

#include "contactModels/contactModel/ContactLaw.hpp"
#include "contactModels/contactModel/none.hpp"
#include "contactModels/normal/DMT.hpp"
#include "contactModels/normal/Hertz.hpp"
#include "contactModels/normal/JKR.hpp"
#include "contactModels/normal/simplifiedJKR.hpp"
#include "contactModels/rolling/springSlider.hpp"
#include "contactModels/tangential/springDashpotSlider.hpp"
#include "contactModels/twisting/springDashpotSlider.hpp"
#include "particles/errors.hpp"

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
    std::vector<std::string> (*keywords)();
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
        row<normal::DMT>()
    };
    return table;
}

template<class Part>
PartEntry entry(const char* kind)
{
    return {kind, Part::model, Part::keywords()};
}

void checkModel(const char* kind, const std::string& model)
{
    std::string list;
    for (const PartEntry& e : contactModelTable())
    {
        if (e.kind == kind)
        {
            if (e.model == model) return;
            list += (list.empty() ? "" : " ") + e.model;
        }
    }
    throw inputError
    (
        std::string(kind) + "/model", "unknown model " + model, list
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
        t.push_back(entry<none>("twisting"));
        t.push_back(entry<twisting::springDashpotSlider>("twisting"));
        return t;
    }();
    return table;
}


std::unique_ptr<ContactLaw> newContactLaw(const ContactSettings& s)
{
    checkModel("normal", s.normal.model);
    checkModel("tangential", s.tangential.model);
    checkModel("rolling", s.rolling.model);
    checkModel("twisting", s.twisting.model);

    if (s.twisting.model != none::model && s.tangential.model == none::model)
    {
        throw inputError
        (
            "twisting/model",
            s.twisting.model + " without a tangential model, whose limit it needs",
            "none, or tangential { model springDashpotSlider; ... }"
        );
    }

    for (const NormalRow& r : normalTable())
    {
        if (s.normal.model == r.model) return r.make(s);
    }
    return nullptr;     // not reached: checkModel has thrown
}

}
