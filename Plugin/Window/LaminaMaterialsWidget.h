// SPDX-License-Identifier: BSD-3-Clause
// Material ids as a list with check boxes.
#pragma once

#include "pqPropertyWidget.h"

#include <QList>
#include <QMap>
#include <QVariant>

class QListWidget;

/// Lists the materials of the filter's input, by id and name, and checks those that an integer property
/// holds. Ids that the property holds and the input lacks are listed too, and told to be missing.
class LaminaMaterialsWidget : public pqPropertyWidget
{
  Q_OBJECT
  Q_PROPERTY(QList<QVariant> materials READ Materials WRITE SetMaterials NOTIFY MaterialsChanged)

public:
  LaminaMaterialsWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);

  QList<QVariant> Materials() const;
  void SetMaterials(const QList<QVariant>& ids);

Q_SIGNALS:
  void MaterialsChanged();

private:
  /// The input's materials and their names, as far as they are known.
  QMap<int, QString> InputMaterials() const;

  QListWidget* List;
};
