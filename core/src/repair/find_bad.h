// Elements of a part's mesh that are not valid once they are curved.
#pragma once

#include "repair/curved_element.h"

namespace paver {

/// Rising. Elements that plainly are valid are not curved for it: those of well-shaped corners along whose sides and
/// across which the surface hardly turns.
std::vector<int> find_bad(const ElementJudge& judge);

}  // namespace paver
