// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace chaindrive
{
/// Pointers to objects of classes derived from T, in the order in which they were added. Who has a
/// constant list finds constant objects in it, which a vector of pointers does not see to.
template <typename T>
class PointerList
{
public:
  void push_back(T *item) { pointers_.push_back(item); }

  std::size_t size() const { return pointers_.size(); }
  bool        empty() const { return pointers_.empty(); }

  T       *operator[](const std::size_t i) { return pointers_[i]; }
  const T *operator[](const std::size_t i) const { return pointers_[i]; }

  T       *back() { return pointers_.back(); }
  const T *back() const { return pointers_.back(); }

  T *const       *begin() { return pointers_.data(); }
  T *const       *end() { return begin() + size(); }
  const T *const *begin() const { return pointers_.data(); }
  const T *const *end() const { return begin() + size(); }

private:
  std::vector<T *> pointers_;
};

/// The same of objects that belong to the list.
template <typename T>
class OwningList : public PointerList<T>
{
public:
  void push_back(std::unique_ptr<T> item)
  {
    PointerList<T>::push_back(item.get());
    items_.push_back(std::move(item));
  }

private:
  std::vector<std::unique_ptr<T>> items_;
};
} // namespace chaindrive
