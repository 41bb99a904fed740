// SPDX-License-Identifier: BSD-3-Clause
// Lamina's pages in ParaView's Help.
#pragma once

#include <QObject>

/// Hands the pages, which travel inside this plugin, to ParaView's Help when the plugin is loaded. The Help
/// button of a stage's panel finds its page by name.
class LaminaHelp : public QObject
{
  Q_OBJECT

public:
  explicit LaminaHelp(QObject* parent = nullptr)
    : QObject(parent)
  {
  }
  void Start();
  void Stop() {}
};
