// SPDX-License-Identifier: BSD-3-Clause
#include "SmallPolyhedron.h"

#include "Predicates.h"

#include <algorithm>
#include <limits>

namespace lamina
{

namespace
{

using Face = std::array<int, 3>;
using Tet = std::array<int, 4>;
using Score = std::function<double(const Tet&)>;

/// The search is over when the next solution could not be better by more than this.
constexpr double LeastGain = 1e-3;

class Search
{
public:
  Search(const SmallPolyhedron& polyhedron, const Score& score, double floor, int steps)
    : Given(polyhedron)
    , ScoreOf(score)
    , Count(polyhedron.points.size())
    , Floor(floor)
    , Steps(steps)
    , Scores(this->Count * this->Count * this->Count * this->Count, std::numeric_limits<double>::quiet_NaN())
    , Front(this->Count * this->Count * this->Count, 0)
    , Uses(this->Count, 0)
    , Edges(this->Count * this->Count, 0)
  {
    for (const Face& face : polyhedron.faces)
    {
      this->Open.push_back(face);
      ++this->Front[this->KeyOf(face)];
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->Edges[this->EdgeOf(face[k], face[(k + 1) % 3])] = 1;
        this->Edges[this->EdgeOf(face[(k + 1) % 3], face[k])] = 1;
      }
    }
  }

  void Run() { this->Fill(std::numeric_limits<double>::infinity()); }

  std::vector<Tet> Best;
  double BestScore() const { return this->Floor; }

private:
  struct Choice
  {
    int point;
    double score;
  };

  std::size_t EdgeOf(int a, int b) const
  {
    return static_cast<std::size_t>(a) * this->Count + static_cast<std::size_t>(b);
  }

  /// The same for all turns of a face, another one for its other side.
  std::size_t KeyOf(Face f) const
  {
    std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
    return this->EdgeOf(f[0], f[1]) * this->Count + static_cast<std::size_t>(f[2]);
  }

  /// The score of a tet; below 0 if it is not positive.
  double ScoreAt(const Tet& tet)
  {
    Tet sorted = tet;
    bool isOdd = false;
    for (std::size_t i = 0; i < 4; ++i)
    {
      for (std::size_t j = 0; j + 1 < 4 - i; ++j)
      {
        if (sorted[j] > sorted[j + 1])
        {
          std::swap(sorted[j], sorted[j + 1]);
          isOdd = !isOdd;
        }
      }
    }
    const std::size_t key =
      (this->EdgeOf(sorted[0], sorted[1]) * this->Count + static_cast<std::size_t>(sorted[2])) * this->Count +
      static_cast<std::size_t>(sorted[3]);
    double& known = this->Scores[key];
    if (known != known)
    {
      known = this->Measure(sorted);
    }
    return isOdd ? -known : known;
  }

  /// The score if the tet is positive; that of its mirror image, negative, if it is not.
  double Measure(const Tet& t) const
  {
    const auto at = [&](int k) -> const Vec3&
    { return this->Given.points[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])]; };
    const double side = Orientation(at(0), at(1), at(2), at(3));
    const double score =
      side > 0 ? this->ScoreOf(t) : (side < 0 ? this->ScoreOf({ { t[1], t[0], t[2], t[3] } }) : 0.0);
    return side < 0 ? -score : score;
  }

  bool MayJoin(int a, int b) const
  {
    return this->Edges[this->EdgeOf(a, b)] != 0 || !this->Given.allows || this->Given.allows(a, b);
  }

  /// The faces that a tet on `face` would open, towards what is left; none of them may be there already, as
  /// what lies behind it would be filled twice.
  std::array<Face, 3> Sides(const Face& f, int point) const
  {
    return { { { { f[0], f[1], point } }, { { f[1], f[2], point } }, { { f[2], f[0], point } } } };
  }

  bool Fits(const Face& f, int point)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (f[k] == point || !this->MayJoin(f[k], point))
      {
        return false;
      }
    }
    for (const Face& side : this->Sides(f, point))
    {
      if (this->Front[this->KeyOf(side)] != 0)
      {
        return false;
      }
    }
    return true;
  }

  std::vector<Choice> ChoicesOf(const Face& f)
  {
    std::vector<Choice> choices;
    for (int point = 0; point < static_cast<int>(this->Count); ++point)
    {
      if (point != f[0] && point != f[1] && point != f[2])
      {
        const double score = this->ScoreAt({ { f[0], f[2], f[1], point } });
        if (score > this->Floor + LeastGain && this->Fits(f, point))
        {
          choices.push_back({ point, score });
        }
      }
    }
    return choices;
  }

  void OpenFace(const Face& face)
  {
    this->Open.push_back(face);
    ++this->Front[this->KeyOf(face)];
  }

  /// Takes a face off the front if it is there.
  bool CloseFace(const Face& face)
  {
    const std::size_t key = this->KeyOf(face);
    if (this->Front[key] == 0)
    {
      return false;
    }
    --this->Front[key];
    const auto same = [&](const Face& other) { return this->KeyOf(other) == key; };
    this->Open.erase(std::find_if(this->Open.begin(), this->Open.end(), same));
    return true;
  }

  bool UsesAll() const
  {
    for (std::size_t p = 0; p < this->Count; ++p)
    {
      if (this->Uses[p] == 0 && this->Given.mayGo[p] == 0)
      {
        return false;
      }
    }
    return true;
  }

  void Fill(double least)
  {
    if (this->Open.empty())
    {
      if (least > this->Floor + LeastGain && this->UsesAll())
      {
        this->Floor = least;
        this->Best = this->Made;
      }
      return;
    }
    if (this->Steps-- <= 0)
    {
      return;
    }
    std::vector<Choice> choices;
    Face chosen{};
    for (std::size_t i = 0; i < this->Open.size(); ++i)
    {
      std::vector<Choice> own = this->ChoicesOf(this->Open[i]);
      if (i == 0 || own.size() < choices.size())
      {
        choices = std::move(own);
        chosen = this->Open[i];
      }
      if (choices.empty())
      {
        return;
      }
    }
    std::stable_sort(choices.begin(), choices.end(),
                     [](const Choice& a, const Choice& b) { return a.score > b.score; });
    for (const Choice& choice : choices)
    {
      if (this->Steps > 0 && choice.score > this->Floor + LeastGain)
      {
        this->Try(chosen, choice, least);
      }
    }
  }

  void Try(const Face& face, const Choice& choice, double least)
  {
    const std::vector<Face> open = this->Open;
    const std::vector<signed char> front = this->Front;
    this->CloseFace(face);
    for (const Face& side : this->Sides(face, choice.point))
    {
      // The neighbour's face if it is there: the same corners the other way round.
      if (!this->CloseFace({ { side[1], side[0], side[2] } }))
      {
        this->OpenFace(side);
      }
    }
    const Tet tet{ { face[0], face[2], face[1], choice.point } };
    this->Made.push_back(tet);
    for (const int p : tet)
    {
      ++this->Uses[static_cast<std::size_t>(p)];
    }
    this->Fill(std::min(least, choice.score));
    for (const int p : tet)
    {
      --this->Uses[static_cast<std::size_t>(p)];
    }
    this->Made.pop_back();
    this->Open = open;
    this->Front = front;
  }

  const SmallPolyhedron& Given;
  const Score& ScoreOf;
  std::size_t Count;
  double Floor;
  int Steps;
  std::vector<double> Scores;     ///< by the sorted points of a tet
  std::vector<signed char> Front; ///< by the corners of a face: how often it is open
  std::vector<Face> Open;
  std::vector<int> Uses; ///< tets of each point
  std::vector<char> Edges;
  std::vector<Tet> Made;
};

} // namespace

std::vector<std::array<int, 4>> FillPolyhedron(const SmallPolyhedron& polyhedron, const Score& score,
                                               double& floor, int steps)
{
  if (polyhedron.points.size() > SmallPolyhedron::MostPoints)
  {
    return {};
  }
  Search search(polyhedron, score, floor, steps);
  search.Run();
  floor = search.BestScore();
  return std::move(search.Best);
}

} // namespace lamina
