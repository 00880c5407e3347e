// SPDX-License-Identifier: GPL-3.0-or-later
#include "contactModels/normal/JKR.hpp"

#include "contactModels/contactModel/newComposite.hpp"

namespace dem
{
template std::unique_ptr<ContactLaw> newComposite<normal::JKR>(const ContactSettings&);
}
