// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <hdf5.h>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive::files
{
/// Owner of an HDF5 object of any type.
class Hdf5Object
{
public:
  explicit Hdf5Object(const hid_t id = H5I_INVALID_HID) : id_(id) {}
  Hdf5Object(Hdf5Object &&other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Hdf5Object &operator=(Hdf5Object &&other) noexcept
  {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Hdf5Object()
  {
    if (id_ >= 0)
      H5Idec_ref(id_);
  }
        operator hid_t() const { return id_; }
  hid_t release() { return std::exchange(id_, H5I_INVALID_HID); }

private:
  hid_t id_;
};

/// Adds @p texts in UTF-8 to the object @p to as the attribute @p name, a single one as a scalar.
/// Negative when HDF5 cannot.
herr_t write_attribute(hid_t to, const std::string &name, const std::vector<std::string> &texts);
} // namespace chaindrive::files
