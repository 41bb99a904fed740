// SPDX-License-Identifier: BSD-3-Clause
// What the stages that fill volumes share: their needs and their ports.
#include "Inputs.h"

#include "vtkCoreTetrahedra.h"
#include "vtkLayeredTetrahedra.h"
#include "vtkPrismLayer.h"

TEST(LayeredTetrahedra, PortsDefaultsAndNeeds)
{
  vtkNew<vtkLayeredTetrahedra> filter;
  EXPECT_EQ(filter->GetNumberOfOutputPorts(), 2);
  EXPECT_EQ(filter->GetNumberOfSolidMaterials(), 0);
  EXPECT_EQ(filter->GetFluidMaterial(0), 2);
  filter->SetInputData(PlainTetrahedron());
  ExpectError(filter, "no MaterialFeatureSize on the points: run Feature Size first");
  filter->AddSolidMaterial(3);
  ExpectError(filter, "SolidMaterials names material 3, which the input lacks: its materials are 1");
  filter->ClearSolidMaterials();
  filter->AddSolidMaterial(0);
  ExpectError(filter, "the background");
}

TEST(LayeredTetrahedra, NothingSolidIsAnEmptyPartWithAWarning)
{
  vtkNew<vtkLayeredTetrahedra> filter;
  filter->SetInputData(PlainTetrahedron());
  filter->AddFluidMaterial(1);
  Watch watch(filter);
  filter->Update();
  EXPECT_FALSE(watch.GetError());
  EXPECT_NE(watch.Warning().find("no solid"), std::string::npos);
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), 0);
}

TEST(PrismLayer, PortsDefaultsAndNeeds)
{
  vtkNew<vtkPrismLayer> filter;
  EXPECT_EQ(filter->GetNumberOfOutputPorts(), 3);
  filter->SetInputData(PlainTetrahedron());
  {
    Watch watch(filter);
    filter->Update();
    EXPECT_NE(watch.Warning().find("no fluid"), std::string::npos);
    EXPECT_FALSE(watch.GetError());
  }
  filter->AddFluidMaterial(3);
  ExpectError(filter, "FluidMaterials names material");
  filter->ClearFluidMaterials();
  filter->AddFluidMaterial(1);
  ExpectError(filter, "no MaterialFeatureSize on the points: run Feature Size first");
}
