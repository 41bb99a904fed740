// SPDX-License-Identifier: BSD-3-Clause
#include "AuditFaces.h"

#include "Adjacency.h"
#include "AuditStructure.h"
#include "CellFaces.h"
#include "Findings.h"
#include "Openings.h"
#include "PointTable.h"

#include <algorithm>
#include <map>
#include <set>

namespace lamina
{
namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

Vec3 CentreOf(const VolumeMesh& mesh, const CellFace& face)
{
  Vec3 sum;
  const std::size_t n = face.IsQuad() ? 4 : 3;
  for (std::size_t k = 0; k < n; ++k)
  {
    sum += mesh.points[Index(face.corners[k])];
  }
  return sum * (1.0 / static_cast<double>(n));
}

/// What the walk over all faces needs and finds.
class FaceAudit
{
public:
  FaceAudit(const VolumeMesh& mesh, const TriangleComplex* surface, const AuditOptions& options,
            AuditReport& report, AuditMarks& marks, Monitor& monitor)
    : Mesh(mesh)
    , Surface(surface)
    , Scale(options.surfaceScale)
    , Report(report)
    , Marks(marks)
    , Faces(FindCellFaces(mesh, monitor))
    , OnSurface(this->Faces.GroupCount(), OffSurface)
  {
    for (int material : mesh.materials)
    {
      this->Meshed.insert(material);
    }
  }

  void Run()
  {
    if (this->Surface != nullptr)
    {
      this->MatchSurface();
    }
    this->WalkGroups();
    this->FindMismatches();
    CountComponents(this->Mesh, this->Faces, this->Report);
    CountStacks(this->Mesh, this->Faces, this->Report);
    this->Tell();
    this->Marks.faces = std::move(this->Faces);
  }

private:
  int MaterialOf(const CellFace& face) const { return this->Mesh.materials[Index(face.cell)]; }
  const CellFace* Group(std::size_t g) const { return this->Faces.faces.data() + this->Faces.start[g]; }
  std::size_t GroupSize(std::size_t g) const { return this->Faces.start[g + 1] - this->Faces.start[g]; }

  void Flag(std::size_t g)
  {
    for (std::size_t i = 0; i < this->GroupSize(g); ++i)
    {
      this->Marks.flags[Index(this->Group(g)[i].cell)] |= FlagNonConforming;
    }
  }

  /// Marks the faces that are triangles of the surface and checks that each has its cells where its materials
  /// say.
  void MatchSurface()
  {
    PointTable table(this->Mesh.points.size());
    std::vector<Id> idOf; // mesh point by table id: the first of equal ones
    for (std::size_t p = 0; p < this->Mesh.points.size(); ++p)
    {
      if (Index(table.Insert(this->Mesh.points[p])) == idOf.size())
      {
        idOf.push_back(static_cast<Id>(p));
      }
    }
    std::vector<Id> inMesh(this->Surface->points.size());
    for (std::size_t p = 0; p < inMesh.size(); ++p)
    {
      const Id found = table.Find(this->Surface->points[p] * this->Scale);
      inMesh[p] = found < 0 ? -1 : idOf[Index(found)];
    }
    for (std::size_t t = 0; t < this->Surface->triangles.size(); ++t)
    {
      Triangle corners = this->Surface->triangles[t];
      for (Id& corner : corners)
      {
        corner = inMesh[Index(corner)];
      }
      this->MatchTriangle(static_cast<Id>(t), corners);
    }
  }

  void MatchTriangle(Id t, const Triangle& corners)
  {
    const MaterialPair pair = this->Surface->materials[Index(t)];
    const bool hasFirst = this->Meshed.count(pair.first) != 0;
    const bool hasSecond = this->Meshed.count(pair.second) != 0;
    const bool isThere = *std::min_element(corners.begin(), corners.end()) >= 0;
    const Id g = isThere ? this->Faces.Find(corners) : -1;
    const bool isOpening = IsOpening(*this->Surface, this->Surface->Patch(t));
    if (g >= 0)
    {
      this->OnSurface[Index(g)] = isOpening ? this->Surface->Patch(t) : OnWall;
    }
    if (isOpening || (!hasFirst && !hasSecond))
    {
      return; // openings may be triangulated anew
    }
    int behind =
      0; // cells of the first material behind the triangle, of the second before it, others anywhere
    int before = 0;
    int strange = 0;
    for (std::size_t i = 0; g >= 0 && i < this->GroupSize(Index(g)); ++i)
    {
      const CellFace& face = this->Group(Index(g))[i];
      CellFace own;
      std::copy(corners.begin(), corners.end(), own.corners.begin());
      const bool isBehind = !AreOpposite(own, face);
      ++(this->MaterialOf(face) != (isBehind ? pair.first : pair.second) ? strange
                                                                         : (isBehind ? behind : before));
    }
    this->Report.interfaceTriangles += hasFirst && hasSecond;
    if (behind != (hasFirst ? 1 : 0) || before != (hasSecond ? 1 : 0) || strange != 0)
    {
      ++(hasFirst && hasSecond ? this->Report.interfaceMismatches : this->Report.wallMismatches);
      const Vec3 place = this->Surface->points[Index(this->Surface->triangles[Index(t)][0])] * this->Scale;
      (hasFirst && hasSecond ? this->InterfacePlaces : this->WallPlaces).Add(place);
      if (g >= 0)
      {
        this->Flag(Index(g));
      }
    }
  }

  void WalkGroups()
  {
    Openings openings(this->Surface, this->Scale);
    for (std::size_t g = 0; g < this->Faces.GroupCount(); ++g)
    {
      const CellFace* face = this->Group(g);
      const Vec3 place = CentreOf(this->Mesh, face[0]);
      if (this->GroupSize(g) == 1)
      {
        this->WalkBoundary(g, openings);
      }
      else if (this->GroupSize(g) > 2)
      {
        ++this->Report.facesOfManyCells;
        this->FindDoubles(g);
        this->CrowdPlaces.Add(place);
        this->Flag(g);
      }
      else if (!AreOpposite(face[0], face[1]))
      {
        // The same corners, but both cells on one side, or a quad by another order.
        ++this->Report.mismatchedFaces;
        this->FindDoubles(g);
        this->MismatchPlaces.Add(place);
        this->Flag(g);
      }
      else if (this->Surface != nullptr && this->OnSurface[g] == OffSurface &&
               this->MaterialOf(face[0]) != this->MaterialOf(face[1]))
      {
        ++this->Report.strayInterfaces;
        this->StrayPlaces.Add(place);
        this->Flag(g);
      }
    }
    openings.Tell(this->Report.findings);
  }

  void WalkBoundary(std::size_t g, Openings& openings)
  {
    const CellFace& face = *this->Group(g);
    this->Marks.boundary.push_back(face);
    if (this->Surface == nullptr || this->OnSurface[g] == OnWall)
    {
      return; // also a wall that happens to lie in the plane of an opening
    }
    // Whether the opening kept its triangles or got new ones: all that lies there counts towards its area.
    const bool isOpening = openings.Add(this->Mesh, face, this->OnSurface[g]);
    if (!isOpening && this->OnSurface[g] == OffSurface)
    {
      ++this->Report.openFaces;
      this->OpenPlaces.Add(CentreOf(this->Mesh, face));
      this->Flag(g);
    }
  }

  /// Cells at a face that have the same nodes.
  void FindDoubles(std::size_t g)
  {
    std::map<std::vector<Id>, Id> seen;
    for (std::size_t i = 0; i < this->GroupSize(g); ++i)
    {
      const Id cell = this->Group(g)[i].cell;
      const Id* first = this->Mesh.Cell(cell);
      std::vector<Id> nodes(first, first + NodeCount(this->Mesh.types[Index(cell)]));
      std::sort(nodes.begin(), nodes.end());
      const auto [at, isNew] = seen.emplace(std::move(nodes), cell);
      if (!isNew && this->Doubles.insert(std::max(cell, at->second)).second)
      {
        this->DoublePlaces.Add(CentreOf(this->Mesh, this->Group(g)[i]));
      }
    }
  }

  /// Quads of the boundary of which a half is a triangle of the boundary: they ought to be one face.
  void FindMismatches()
  {
    for (std::size_t g = 0; g < this->Faces.GroupCount(); ++g)
    {
      const CellFace& quad = *this->Group(g);
      if (this->GroupSize(g) != 1 || !quad.IsQuad())
      {
        continue;
      }
      bool meetsTriangle = false;
      for (std::size_t k = 0; k < 4; ++k)
      {
        const auto& c = quad.corners;
        const Id half = this->Faces.Find({ { c[k], c[(k + 1) % 4], c[(k + 2) % 4] } });
        if (half >= 0 && this->GroupSize(Index(half)) == 1)
        {
          meetsTriangle = true;
          this->Flag(Index(half));
        }
      }
      if (meetsTriangle)
      {
        ++this->Report.mismatchedFaces;
        this->MismatchPlaces.Add(CentreOf(this->Mesh, quad));
        this->Flag(g);
      }
    }
  }

  void Tell()
  {
    auto& findings = this->Report.findings;
    this->Report.duplicateCells = this->DoublePlaces.GetCount();
    this->DoublePlaces.Tell("cells are there twice: they have the nodes of another", findings);
    this->CrowdPlaces.Tell("faces belong to more than two cells", findings);
    this->MismatchPlaces.Tell("faces do not match: a quad meets triangles, or two cells lie on one side",
                              findings);
    this->OpenPlaces.Tell("faces of the boundary are not triangles of the surface: cells are missing",
                          findings);
    this->StrayPlaces.Tell("faces between two materials are not triangles of the surface", findings);
    this->InterfacePlaces.Tell("interface triangles lack exactly one cell of the right material on each side",
                               findings);
    this->WallPlaces.Tell("wall triangles lack exactly one cell of the right material", findings);
  }

  const VolumeMesh& Mesh;
  const TriangleComplex* Surface;
  double Scale;
  AuditReport& Report;
  AuditMarks& Marks;
  CellFaces Faces;
  static constexpr int OffSurface = 0;
  static constexpr int OnWall = -1;
  std::vector<int>
    OnSurface; ///< one a group of faces: off the surface, on a wall, or the patch of an opening
  std::set<int> Meshed;
  std::set<Id> Doubles;
  Places DoublePlaces;
  Places CrowdPlaces;
  Places MismatchPlaces;
  Places OpenPlaces;
  Places StrayPlaces;
  Places InterfacePlaces;
  Places WallPlaces;
};

} // namespace

void AuditFaces(const VolumeMesh& mesh, const TriangleComplex* surface, const AuditOptions& options,
                AuditReport& report, AuditMarks& marks, Monitor& monitor)
{
  FaceAudit(mesh, surface, options, report, marks, monitor).Run();
}

} // namespace lamina
