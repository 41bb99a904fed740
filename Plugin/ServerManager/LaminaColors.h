// SPDX-License-Identifier: BSD-3-Clause
// Colours of the pipeline's arrays.
#ifndef LaminaColors_h
#define LaminaColors_h

#include "LaminaServerManagerModule.h" // For the export macro

/// Run when the plugin is loaded: adds the presets "Lamina materials" and "Lamina quality", and makes them,
/// and a map that fits, the ones that arrays of the pipeline are first shown in. What the user has set comes
/// first.
LAMINASERVERMANAGER_EXPORT void LaminaUseColors();

#endif
