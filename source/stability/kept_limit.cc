// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/joint_flexibility.h>
#include <chaindrive/stability/kept_limit.h>
#include <chaindrive/utilities/checksum.h>
#include <chaindrive/version.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <type_traits>

namespace chaindrive::stability
{
namespace
{
/// Of what is kept: to be raised with every change that changes limits.
constexpr unsigned int version_of_limits = 1;

/// A checksum of numbers, of lists with their lengths.
class Numbers
{
public:
  template <typename... Values>
  void add(const Values &...values)
  {
    (add_one(values), ...);
  }

  std::uint64_t value() const { return sum_.value(); }

private:
  template <typename T>
  void add_all(const T *first, const std::size_t n)
  {
    static_assert(std::is_arithmetic_v<T>);
    sum_.add(reinterpret_cast<const char *>(first), n * sizeof(T));
  }
  template <typename T>
  void add_one(const T &number)
  {
    add_all(&number, 1);
  }
  template <typename T>
  void add_one(const std::vector<T> &numbers)
  {
    add_one(numbers.size());
    add_all(numbers.data(), numbers.size());
  }
  template <typename T, std::size_t n>
  void add_one(const std::array<T, n> &numbers)
  {
    add_all(numbers.data(), n);
  }

  Checksum sum_;
};

void add_joint(Numbers &numbers, const contact::JointFlexibility *joint)
{
  numbers.add(joint != nullptr);
  if (joint == nullptr)
    return;
  numbers.add(joint->rings(), joint->n_columns());
  for (const contact::JointFlexibility::Place &place : joint->places())
    numbers.add(place.first, place.part);
  for (unsigned int r = 0; r < joint->n_rings(); ++r)
    for (unsigned int s = 0; s < joint->n_rings(); ++s)
      for (unsigned int columns = 0; columns < joint->n_columns(); ++columns)
        numbers.add(joint->at(r, s, columns));
}

void add_window(Numbers &numbers, const ClosedWindow &window)
{
  numbers.add(window.family,
              window.group,
              window.surface,
              window.n_columns,
              window.n_rings,
              window.node,
              window.flexibility,
              window.across,
              window.half_angle,
              window.in_bore,
              window.first_ring,
              window.n_rings_of_through,
              window.across_middle,
              window.mobility,
              window.strips.size());
  if (window.rim != nullptr)
    {
      numbers.add(window.rim->teeth, window.rim->omega, window.rim->waves);
      for (const contact::ClosedStrips &strips : window.strips)
        numbers.add(strips.rim_cosine, strips.rim_sine);
    }
  add_joint(numbers, window.joint);
  for (const contact::ClosedStrips &strips : window.strips)
    {
      numbers.add(strips.places.size(), strips.flexibility, strips.through);
      for (const contact::ClosedStrips::Place &place : strips.places)
        numbers.add(place.angle, place.node, place.weight);
    }
}

/// Frequencies of @p bodies, and what their motions displace these @p nodes by.
void add_bodies(Numbers &numbers, const ModalGroup &bodies, const std::set<unsigned int> &nodes)
{
  const Matrix free = bodies.modal_matrix({});
  numbers.add(free.m());
  for (unsigned int i = 0; i < free.m(); ++i)
    for (unsigned int j = 0; j < free.n(); ++j)
      numbers.add(free(i, j));
  for (const unsigned int node : nodes)
    for (const dealii::Tensor<1, 3> &motion : bodies.motions_of(node))
      numbers.add(motion[0], motion[1], motion[2]);
}

std::string
key_of(const World &world, const std::vector<ClosedWindow> &windows, const unsigned int n_families)
{
  Numbers                                        numbers;
  std::map<unsigned int, std::set<unsigned int>> nodes; // of groups
  numbers.add(n_families, windows.size());
  for (const ClosedWindow &window : windows)
    {
      add_window(numbers, window);
      nodes[window.group].insert(window.node.begin(), window.node.end());
      for (const contact::ClosedStrips &strips : window.strips)
        for (const contact::ClosedStrips::Place &place : strips.places)
          nodes[window.group].insert(place.node.begin(), place.node.end());
    }
  for (const ModalGroup *group : world.groups.modal())
    {
      numbers.add(group->copies());
      add_bodies(numbers, *group, nodes[group->copies()]);
    }
  return "critical time step of bodies in contact without penalty; " +
         std::to_string(windows.size()) + " sides; their numbers " +
         std::to_string(numbers.value()) + "; version " + std::to_string(version_of_limits) +
         " of " + chaindrive::version;
}
} // namespace

double kept_limit(const World                     &world,
                  const std::vector<ClosedWindow> &windows,
                  const unsigned int               n_families,
                  statics::Cache                  *kept,
                  const std::function<double()>   &find)
{
  if (kept == nullptr)
    return find();
  const std::string key      = key_of(world, windows, n_families);
  const auto        is_limit = [](const nlohmann::json &limit) {
    return limit.is_number() && limit.get<double>() > 0.;
  };
  if (const auto found = kept->find(key, is_limit))
    return found->get<double>();
  const double limit = find();
  if (std::isfinite(limit))
    kept->keep(key, limit);
  return limit;
}
} // namespace chaindrive::stability
