// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/hdf5_object.h>

namespace chaindrive::files
{
herr_t
write_attribute(const hid_t to, const std::string &name, const std::vector<std::string> &texts)
{
  const Hdf5Object type(H5Tcopy(H5T_C_S1));
  if (type < 0 || H5Tset_size(type, H5T_VARIABLE) < 0 || H5Tset_cset(type, H5T_CSET_UTF8) < 0)
    return -1;
  const hsize_t    n = texts.size();
  const Hdf5Object space(n == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &n, nullptr));
  if (space < 0)
    return -1;
  const Hdf5Object attribute(H5Acreate2(to, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT));
  if (attribute < 0)
    return -1;
  std::vector<const char *> pointers;
  pointers.reserve(n);
  for (const std::string &text : texts)
    pointers.push_back(text.c_str());
  return H5Awrite(attribute, type, pointers.data());
}
} // namespace chaindrive::files
