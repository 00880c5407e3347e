// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dem
{

//- From `now` over dt [s], after which the particle step goes on for `ahead`; now is only for
//  messages
struct Span
{
    double dt, now = 0, ahead = 0;
    bool uncut = true;      // it does not begin where another has been cut off
};

}
