// SPDX-License-Identifier: GPL-3.0-or-later
#include "contactModels/normal/cohesivePlastic.hpp"

#include "contactModels/contactModel/newComposite.hpp"

namespace dem
{
template std::unique_ptr<ContactLaw> newComposite<normal::cohesivePlastic>(const ContactSettings&);
}
