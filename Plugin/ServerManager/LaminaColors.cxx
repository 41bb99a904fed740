// SPDX-License-Identifier: BSD-3-Clause
#include "LaminaColors.h"

#include "vtkSMSettings.h"
#include "vtkSMTransferFunctionPresets.h"

#include <array>
#include <string>

namespace
{

constexpr const char* Materials = "Lamina materials";
constexpr const char* Quality = "Lamina quality";
/// Below the settings of user and site.
constexpr double Priority = 0.5;
constexpr int MaterialCount = 32;

/// Background, tissue and blood by the pipeline's defaults; then colours that are told apart well, again and
/// again.
std::string MaterialsPreset()
{
  constexpr std::array<const char*, 12> colors = {
    "0.27, 0.29, 0.33", "0.88, 0.66, 0.55", "0.70, 0.10, 0.13", "0.26, 0.47, 0.71",
    "0.95, 0.80, 0.30", "0.35, 0.62, 0.40", "0.55, 0.40, 0.68", "0.55, 0.80, 0.85",
    "0.90, 0.50, 0.15", "0.60, 0.45, 0.30", "0.85, 0.55, 0.75", "0.75, 0.75, 0.75"
  };
  std::string values;
  std::string annotations;
  for (int m = 0; m < MaterialCount; ++m)
  {
    const std::string comma = m == 0 ? "" : ", ";
    const std::string id = "\"" + std::to_string(m) + "\"";
    values += comma + colors[static_cast<std::size_t>(m) % colors.size()];
    annotations += comma + id + ", " + id;
  }
  return "{\"Name\": \"" + std::string(Materials) + "\", \"IndexedColors\": [" + values +
         "], \"Annotations\": [" + annotations + "]}";
}

/// Red up to the gate of 0.1, then to green: bad cells are seen at once.
std::string QualityPreset()
{
  return "{\"Name\": \"" + std::string(Quality) +
         "\", \"ColorSpace\": \"RGB\", \"NanColor\": [0.5, 0.5, 0.5], \"RGBPoints\": [0, 0.65, 0, 0.15, 0.1, "
         "0.85, 0.2, 0.15, 0.3, 0.99, 0.75, 0.4, 0.6, 0.85, 0.93, 0.55, 1, 0.1, 0.6, 0.32]}";
}

void AddPreset(const char* name, const std::string& preset)
{
  vtkSMTransferFunctionPresets* presets = vtkSMTransferFunctionPresets::GetInstance();
  if (!presets->HasPreset(name))
  {
    presets->AddPreset(name, preset);
  }
}

} // namespace

void LaminaUseColors()
{
  AddPreset(Materials, MaterialsPreset());
  AddPreset(Quality, QualityPreset());
  const std::string viridis = "\"Viridis (matplotlib)\"";
  vtkSMSettings::GetInstance()->AddCollectionFromString(
    "{\"standard_presets\": {\"MaterialIds\": \"" + std::string(Materials) + "\", \"MeshQuality\": \"" +
      Quality + "\", \"FeatureSize\": " + viridis + ", \"TargetEdgeLength\": " + viridis +
      ", \"LayerIds\": " + viridis + "}}",
    Priority);
}
