// SPDX-License-Identifier: BSD-3-Clause
// Edits that do not hinder each other: looked at in threads, carried out one after the other.
#pragma once

#include "EditableSurface.h"
#include "RegionList.h"

#include <utility>

namespace lamina
{

/// Takes edits whose regions are apart, in the order in which they are offered. What is taken depends on the
/// surface alone, and no edit reads what another writes: the result is the same for any number of threads.
template<typename Item>
class EditBatch
{
public:
  static constexpr std::size_t Most = 128;

  EditBatch(EditableSurface& surface, Monitor& monitor)
    : Surface(surface)
    , Watch(monitor)
    , Plans(Most)
  {
  }
  bool IsFull() const { return this->Items.size() == Most; }
  /// Takes an item unless its region is not apart from those taken before.
  bool Offer(const Item& item, const EditRegion& region)
  {
    if (!this->Regions.Admit(region))
    {
      return false;
    }
    this->Items.push_back(item);
    return true;
  }
  /// Calls plan(item, editPlan) in threads, then carries out the sound ones and calls done(item, editPlan)
  /// for each of those. The batch is empty then.
  template<typename Plan, typename Done>
  void Run(const Plan& plan, const Done& done)
  {
    constexpr Id grain = 4;
    for (EditPlan& p : this->Plans)
    {
      p.isSound = false; // a stopped loop leaves some out
    }
    this->Watch.For(static_cast<Id>(this->Items.size()), grain,
                    [&](Id begin, Id end)
                    {
                      for (Id i = begin; i < end; ++i)
                      {
                        const auto at = static_cast<std::size_t>(i);
                        plan(this->Items[at], this->Plans[at]);
                      }
                    });
    for (std::size_t i = 0; i < this->Items.size(); ++i)
    {
      if (this->Surface.CarryOut(this->Plans[i]))
      {
        done(this->Items[i], this->Plans[i]);
      }
    }
    this->Items.clear();
    this->Regions.Clear();
  }

private:
  EditableSurface& Surface;
  Monitor& Watch;
  std::vector<Item> Items;
  RegionList Regions;
  std::vector<EditPlan> Plans; ///< kept for their memory
};

} // namespace lamina
