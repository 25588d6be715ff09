// Elements of a part's mesh that are not valid once they are curved, or poor.
#pragma once

#include "repair/curved_element.h"

namespace paver {

/// Those that are not valid and those that are not `fair`, rising. Elements that plainly are fair are not curved for
/// it: those of well-shaped corners along whose sides and across which the surface hardly turns.
std::vector<int> find_bad(const ElementJudge& judge);

}  // namespace paver
