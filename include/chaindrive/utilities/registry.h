// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive
{
/// What something that registers itself says of itself.
struct About
{
  std::string              name;          ///< no other of its kind has it
  std::string              documentation; ///< what it is, in sentences
  std::vector<std::string> after = {};    ///< names of others of its kind that come before it
};

/// What is registered, whatever its kind: names, documentation, order. Static objects register
/// while a program or a plug-in is loaded, when nobody could catch an exception: what is wrong with
/// a registration is kept, and told by problems() and order().
class AnyRegistry
{
public:
  struct Entry
  {
    About       about;
    std::string plugin; ///< the name of the plug-in that it came with; empty: the program's own
    std::size_t batch;  ///< 0: the program's own, then the plug-ins in the order of their loading
  };

  /// @p kind: the word for one of them, such as "quantity".
  explicit AnyRegistry(std::string kind);
  ~AnyRegistry()                              = default;
  AnyRegistry(const AnyRegistry &)            = delete;
  AnyRegistry &operator=(const AnyRegistry &) = delete;

  const std::string       &kind() const { return kind_; }
  const std::deque<Entry> &entries() const { return entries_; }

  /// The entries so that each comes after those that it names; of several that could come next, the
  /// program's own first, then by plug-in, then by name. InputError when one names another that is
  /// not registered, or when they wait for each other in a circle.
  std::vector<std::size_t> order() const;

  /// All registries, in the order in which they were made.
  static const std::vector<const AnyRegistry *> &all();

  /// What registers itself from now on belongs to the plug-in @p name.
  static void begin_plugin(const std::string &name);

  /// A sentence for each registration that was refused, since its kind has one of that name.
  static const std::vector<std::string> &problems();

protected:
  /// Whether an entry was made.
  bool enter(const About &about);

private:
  std::string       kind_;
  std::deque<Entry> entries_;
};

/// The things of one kind that the program knows: those of its own files, and those of plug-ins. To
/// exist before the registrations of other sources, a registry is a static object of a function.
template <typename Item>
class Registry : public AnyRegistry
{
public:
  using AnyRegistry::AnyRegistry;

  void add(const About &about, Item item)
  {
    if (enter(about))
      items_.push_back(std::move(item));
  }

  /// One for each of entries().
  const std::deque<Item> &items() const { return items_; }

  struct Known
  {
    const Entry &entry;
    const Item  &item;
  };

  /// All in their order(); throws as that does.
  std::vector<Known> in_order() const
  {
    std::vector<Known> known;
    for (const std::size_t i : order())
      known.push_back({entries()[i], items_[i]});
    return known;
  }

private:
  std::deque<Item> items_;
};
} // namespace chaindrive
