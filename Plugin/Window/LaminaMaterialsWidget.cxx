// SPDX-License-Identifier: BSD-3-Clause
#include "LaminaMaterialsWidget.h"

#include "MeshArrayNames.h"

#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMInputProperty.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"

#include <QListWidget>
#include <QVBoxLayout>

namespace
{

/// Images of labels come without a list; up to this many all ids to the greatest are offered.
constexpr int MostGuessed = 64;

void AddListed(vtkPVDataInformation* data, QMap<int, QString>& found)
{
  vtkPVArrayInformation* list =
    data->GetFieldDataInformation()->GetArrayInformation(lamina::names::MaterialList);
  if (!list || list->GetNumberOfStringValues() == 0)
  {
    return;
  }
  for (const QString& line : QString::fromUtf8(list->GetStringValue(0)).split('\n', Qt::SkipEmptyParts))
  {
    found.insert(line.section(' ', 0, 0).toInt(), line.section(' ', 1));
  }
}

void AddGuessed(vtkPVDataInformation* data, QMap<int, QString>& found)
{
  vtkPVDataSetAttributesInformation* points = data->GetPointDataInformation();
  vtkPVArrayInformation* labels = points->GetArrayInformation(lamina::names::MaterialIds);
  labels = labels || points->GetNumberOfArrays() == 0 ? labels : points->GetArrayInformation(0);
  const double greatest = labels ? labels->GetComponentRange(0)[1] : 0;
  for (int id = 1; greatest <= MostGuessed && id <= static_cast<int>(greatest); ++id)
  {
    found.insert(id, QString());
  }
}

} // namespace

LaminaMaterialsWidget::LaminaMaterialsWidget(vtkSMProxy* smproxy, vtkSMProperty* smproperty,
                                             QWidget* parentWidget)
  : pqPropertyWidget(smproxy, parentWidget)
  , List(new QListWidget(this))
{
  this->List->setObjectName("Materials");
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->addWidget(this->List);
  this->SetMaterials({});
  const int rows = qBound(1, this->List->count(), 6);
  this->List->setFixedHeight(rows * qMax(18, this->List->sizeHintForRow(0)) + 2 * this->List->frameWidth() +
                             2);
  this->connect(this->List, SIGNAL(itemChanged(QListWidgetItem*)), SIGNAL(MaterialsChanged()));
  this->addPropertyLink(this, "materials", SIGNAL(MaterialsChanged()), smproperty);
}

QMap<int, QString> LaminaMaterialsWidget::InputMaterials() const
{
  QMap<int, QString> found;
  auto* inputs = vtkSMInputProperty::SafeDownCast(this->proxy()->GetProperty("Input"));
  for (unsigned int i = 0; inputs && i < inputs->GetNumberOfProxies(); ++i)
  {
    auto* source = vtkSMSourceProxy::SafeDownCast(inputs->GetProxy(i));
    vtkPVDataInformation* data =
      source ? source->GetDataInformation(inputs->GetOutputPortForConnection(i)) : nullptr;
    if (data)
    {
      AddListed(data, found);
      if (found.isEmpty())
      {
        AddGuessed(data, found);
      }
    }
  }
  return found;
}

QList<QVariant> LaminaMaterialsWidget::Materials() const
{
  QList<QVariant> ids;
  for (int row = 0; row < this->List->count(); ++row)
  {
    const QListWidgetItem* item = this->List->item(row);
    if (item->checkState() == Qt::Checked)
    {
      ids.append(item->data(Qt::UserRole));
    }
  }
  return ids;
}

void LaminaMaterialsWidget::SetMaterials(const QList<QVariant>& ids)
{
  QMap<int, QString> all = this->InputMaterials();
  for (const QVariant& id : ids)
  {
    if (!all.contains(id.toInt()))
    {
      all.insert(id.toInt(), tr("(not in the input)"));
    }
  }
  const bool blocked = this->List->blockSignals(true);
  this->List->clear();
  for (auto material = all.cbegin(); material != all.cend(); ++material)
  {
    auto* item =
      new QListWidgetItem(QString("%1 %2").arg(material.key()).arg(material.value()).trimmed(), this->List);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
    item->setData(Qt::UserRole, material.key());
    item->setCheckState(ids.contains(QVariant(material.key())) ? Qt::Checked : Qt::Unchecked);
  }
  this->List->blockSignals(blocked);
}
