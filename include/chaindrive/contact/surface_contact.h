// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/family.h>
#include <chaindrive/contact/surface.h>

#include <memory>
#include <string>
#include <vector>

namespace chaindrive::contact
{
/// Slaves on surfaces: each pair is a slave, by the point of its body's axis that carries its
/// radius, and a surface. The search keeps a list of the pairs that are near; of a surface that is
/// never far away, such as a bore, these are all of them.
class SurfaceContact : public Family
{
public:
  /// A slave and the surface that it may meet.
  struct Pair
  {
    std::shared_ptr<const Surface> surface; ///< many slaves may share one
    scene::SlavePoint              slave;
  };

  void search(const World &world, double reach) override;
  void serialize(const Archive &archive, unsigned int rank) override;
  bool needs_search() const override;

  /// Pairs chosen by the last search, ascending.
  const std::vector<unsigned int> &near() const { return near_; }

  /// Those of them that this rank evaluates.
  virtual std::vector<unsigned int> own(const World &world) const
  {
    return world.is_first_rank() ? near_ : std::vector<unsigned int>();
  }

  /// Points of a slave that do the same to the surface.
  struct Press
  {
    unsigned int         slave, joint; ///< its body, and the joint of that
    unsigned int         feature;      ///< as in Record
    unsigned int         n_points;
    double               normal;    ///< force along the normal on one of them, N
    double               gap;       ///< m
    dealii::Tensor<1, 3> force;     ///< on one of them, N
    dealii::Tensor<1, 3> direction; ///< the normal, unit
  };

  /// At least all that press, in the order of near(); valid until forces are evaluated anew.
  /// Cheaper than records() where these are made on demand.
  virtual const std::vector<Press> &presses() const;

  const scene::SlavePoint &slave(const unsigned int i) const { return pairs_[i].slave; }

  /// The body that slaves touch, of the first pair.
  unsigned int master() const { return pairs_.front().surface->body(); }

protected:
  SurfaceContact(std::string               name,
                 const scene::InterfaceOf &interface,
                 const scene::ContactLaw  &law,
                 std::vector<Pair>         pairs);

  /// Each of @p slaves with @p surface.
  static std::vector<Pair> pairs_on(const std::shared_ptr<const Surface> &surface,
                                    const std::vector<scene::SlavePoint> &slaves);

  std::vector<Pair>          pairs_;
  std::vector<unsigned int>  near_;
  mutable std::vector<Press> presses_; ///< what presses() returns
};
} // namespace chaindrive::contact
