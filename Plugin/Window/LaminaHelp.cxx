// SPDX-License-Identifier: BSD-3-Clause
#include "LaminaHelp.h"

#include "pqApplicationCore.h"

#include <QFile>

void LaminaHelp::Start()
{
  const QString pages = ":/Lamina/lamina.qch";
  pqApplicationCore* core = pqApplicationCore::instance();
  // Built without qhelpgenerator there are none.
  if (core && QFile::exists(pages))
  {
    core->registerDocumentation(pages);
  }
}
