// SPDX-License-Identifier: BSD-3-Clause
// Islands and holes of a few pixels on a slice.
#pragma once

#include "../Base/Types.h"

#include <vector>

namespace lamina
{

/// For the background and each of `ids`, in this order, the pixels of its smallest connected part (over
/// edges) on a slice; of one that is absent, the greatest number there is.
std::vector<Id> SmallestParts(const std::vector<int>& labels, Id width, const std::vector<int>& ids);

/// Give each connected part of fewer pixels than `least` says for its label (as above) to the label that it
/// has most edges in common with; at a tie to the lesser one.
void RemoveSpecks(std::vector<int>& labels, Id width, const std::vector<int>& ids,
                  const std::vector<Id>& least);

} // namespace lamina
