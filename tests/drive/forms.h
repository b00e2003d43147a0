// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/parameters/drive.h>

#include <vector>

/// The tooth forms of the sprockets of @p drive, in the order that drive::make_layout() takes.
inline std::vector<chaindrive::drive::ToothForm>
forms_of(const chaindrive::parameters::Drive      &drive,
         const chaindrive::drive::ChainDimensions &chain)
{
  std::vector<chaindrive::drive::ToothForm> forms;
  for (unsigned int i = 0; i < drive.sprockets.list.size(); ++i)
    forms.push_back(chaindrive::drive::make_tooth_form(
        drive.sprockets.list[i].teeth, chain, drive.sprockets, i));
  return forms;
}
