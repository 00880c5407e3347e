// SPDX-License-Identifier: GPL-3.0-or-later
#include "contactModels/normal/vanDerWaals.hpp"

#include "contactModels/contactModel/newComposite.hpp"

namespace dem
{
template std::unique_ptr<ContactLaw> newComposite<normal::vanDerWaals>(const ContactSettings&);
}
