// SPDX-License-Identifier: BSD-3-Clause
#include "LaminaSummaryWidget.h"

#include "pqApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QLabel>
#include <QVBoxLayout>

LaminaSummaryWidget::LaminaSummaryWidget(vtkSMProxy* smproxy, vtkSMProperty* smproperty,
                                         QWidget* parentWidget)
  : pqPropertyWidget(smproxy, parentWidget)
  , Line(new QLabel(this))
{
  this->setProperty(smproperty);
  this->setShowLabel(false);
  this->Line->setObjectName("Summary");
  this->Line->setWordWrap(true);
  this->Line->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->addWidget(this->Line);
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  if (auto* source = model->findItem<pqPipelineSource*>(smproxy))
  {
    this->connect(source, SIGNAL(dataUpdated(pqPipelineSource*)), SLOT(Refresh()));
  }
  this->Refresh();
}

void LaminaSummaryWidget::Refresh()
{
  this->proxy()->UpdatePropertyInformation(this->property());
  const vtkSMPropertyHelper helper(this->property(), true);
  const char* text = helper.GetNumberOfElements() > 0 ? helper.GetAsString(0) : "";
  this->Line->setText(QString::fromUtf8(text ? text : ""));
  this->Line->setVisible(!this->Line->text().isEmpty());
}
