// SPDX-License-Identifier: BSD-3-Clause
// The line that tells what a stage made, in its panel.
#pragma once

#include "pqPropertyWidget.h"

class QLabel;

/// Shows a string property of a filter, anew whenever the filter ran. Hidden while it is empty.
class LaminaSummaryWidget : public pqPropertyWidget
{
  Q_OBJECT

public:
  LaminaSummaryWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);

private Q_SLOTS:
  void Refresh();

private:
  QLabel* Line;
};
