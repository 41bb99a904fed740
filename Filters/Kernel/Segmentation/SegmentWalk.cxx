// SPDX-License-Identifier: BSD-3-Clause
// Disputed voxels by a random walker with priors: L. Grady, Multilabel random walker image segmentation using
// prior models, CVPR 2005.
#include "SegmentRules.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>

namespace lamina
{
namespace segment
{

namespace
{

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// What the walk is made of: how easily it passes between two voxels, and where grey values draw it.
class WalkModel
{
public:
  explicit WalkModel(const Work& work)
    : Tissue(work.classes[Material::Tissue])
    , Blood(work.classes[Material::Blood])
  {
    // An image without noise still has partial volume: no class is narrower than a twentieth of the step.
    const double least = 0.05 * std::max(this->Blood.mean - this->Tissue.mean, 1e-300);
    this->Tissue.deviation = std::max(this->Tissue.deviation, least);
    this->Blood.deviation = std::max(this->Blood.deviation, least);
    const double noise = std::max(this->Tissue.deviation, this->Blood.deviation);
    this->Slope = 1 / (4 * noise * noise);
    const Vec3& h = work.image.grid.spacing;
    const double shortest = std::min({ h.x, h.y, h.z });
    for (int a = 0; a < 3; ++a)
    {
      this->Nearness[a] = shortest * shortest / (h[a] * h[a]);
    }
  }
  /// The weight of the step between two neighbours along an axis. Two voxels of one class differ by noise
  /// twice; long edges of a voxel count less, as in any Laplacian.
  double Weight(double a, double b, int axis) const
  {
    // Never nothing: where all neighbours differ much, they still have a say in a draw.
    constexpr double least = 1e-3;
    const double likeness = std::exp(-(a - b) * (a - b) * this->Slope);
    return this->Nearness[axis] * (std::isfinite(likeness) ? std::max(likeness, least) : least);
  }
  /// The probability of blood by the grey value alone.
  double Prior(double value) const
  {
    const double fromTissue = (value - this->Tissue.mean) / this->Tissue.deviation;
    const double fromBlood = (value - this->Blood.mean) / this->Blood.deviation;
    const double odds = 0.5 * (fromTissue * fromTissue - fromBlood * fromBlood) +
                        std::log(this->Tissue.deviation / this->Blood.deviation);
    return 1 / (1 + std::exp(-std::min(500.0, std::max(-500.0, odds))));
  }

private:
  ClassValues Tissue;
  ClassValues Blood;
  double Slope;
  double Nearness[3];
};

/// The system of the walk: symmetric, diagonally dominant, so positive definite. Only the lower half is kept.
struct System
{
  Matrix lower;
  Eigen::VectorXd right;
};

/// The position of a voxel among ascending ones, asked for in ascending order.
class Follower
{
public:
  explicit Follower(const std::vector<Id>& voxels)
    : Voxels(voxels)
  {
  }
  /// The index of `voxel`, or -1.
  int Find(Id voxel)
  {
    while (this->At < this->Voxels.size() && this->Voxels[this->At] < voxel)
    {
      ++this->At;
    }
    return this->At < this->Voxels.size() && this->Voxels[this->At] == voxel ? static_cast<int>(this->At)
                                                                             : -1;
  }

private:
  const std::vector<Id>& Voxels;
  std::size_t At = 0;
};

System MakeSystem(const Work& work, const std::vector<Id>& voxels)
{
  // How much the grey value counts beside one neighbour of the same grey value.
  constexpr double strength = 1;
  const WalkModel model(work);
  const auto& size = work.Size();
  const Id step[3] = { 1, size[0], size[0] * size[1] };
  const int count = static_cast<int>(voxels.size());
  System system{ Matrix(count, count), Eigen::VectorXd(count) };
  system.lower.reserve(4 * static_cast<Id>(count));
  Follower before[3] = { Follower(voxels), Follower(voxels), Follower(voxels) };
  for (int n = 0; n < count; ++n)
  {
    const Id v = voxels[n];
    const Id place[3] = { v % size[0], v / size[0] % size[1], v / step[2] };
    const double value = work.grey.At(v);
    double diagonal = strength;
    system.right[n] = strength * model.Prior(value);
    system.lower.startVec(n);
    for (int axis = 2; axis >= 0; --axis)
    {
      for (const bool up : { false, true })
      {
        if (up ? place[axis] + 1 >= size[axis] : place[axis] == 0)
        {
          continue;
        }
        const Id w = up ? v + step[axis] : v - step[axis];
        if (work.labels[w] == Outside)
        {
          continue;
        }
        const double weight = model.Weight(value, work.grey.At(w), axis);
        diagonal += weight;
        if (work.labels[w] != Undecided)
        {
          system.right[n] += work.labels[w] == Blood ? weight : 0;
          continue;
        }
        if (!up)
        {
          system.lower.insertBack(n, before[axis].Find(w)) = -weight;
        }
      }
    }
    system.lower.insertBack(n, n) = diagonal;
  }
  system.lower.finalize();
  return system;
}

} // namespace

std::vector<double> WalkToBlood(const Work& work, const std::vector<Id>& voxels, Monitor& monitor)
{
  if (voxels.empty())
  {
    return {};
  }
  const System system = MakeSystem(work, voxels);
  Eigen::VectorXd shares = system.right.cwiseQuotient(system.lower.diagonal());
  Eigen::ConjugateGradient<Matrix, Eigen::Lower> solver;
  solver.setTolerance(1e-5);
  solver.compute(system.lower);
  // In short runs, so that a request to stop is heard.
  solver.setMaxIterations(20);
  for (int run = 0; run < 50 && !monitor.Cancelled(); ++run)
  {
    shares = solver.solveWithGuess(system.right, shares).eval();
    if (solver.info() == Eigen::Success)
    {
      break;
    }
  }
  return { shares.data(), shares.data() + shares.size() };
}

} // namespace segment
} // namespace lamina
