// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/drive.h>
#include <chaindrive/statics/cache.h>
#include <chaindrive/statics/flexibility.h>
#include <chaindrive/statics/peak_stress.h>
#include <chaindrive/utilities/announce.h>

#include <deal.II/base/mpi.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace chaindrive::statics
{
/// The place on a seat that is farthest from its bottom and carries a patch of contact, as an angle
/// from the bottom, rad.
double seat_end(const drive::ToothForm &form);

/// Elastic parts of one material whose flexibilities are computed once: they are kept in memory and
/// in a cache.
class Library
{
public:
  /// @p cache_folder: see Cache; the first rank of @p comm reads and writes it.
  /// @p announce is told of each part before it is solved, on all ranks.
  Library(const Material    &material,
          const std::string &cache_folder,
          MPI_Comm           comm,
          const Announce    &announce = {});

  /// Two links of a chain that are pulled, the pin of one in the bush of the other: one interface,
  /// whose approach is the extension per pitch.
  ContactProblem pulled_links(const drive::ChainDimensions &chain, unsigned int n_angles);

  /// A roller pressed on the seat of a @p sprocket's tooth gap by the bush in it. Interface 0:
  /// tooth and roller, 1: roller and bush. Approaches are those of the sprocket's hub, the roller's
  /// centre of mass and the link's centre of mass. The line of pressure is turned by @p position
  /// [rad] from the bottom of the seat; pressure is symmetric about it, tooth and rim answer with
  /// their mean of both sides. Of a chain without rollers the bush itself is pressed on the seat,
  /// interface 0.
  ContactProblem pressed_roller(const drive::ChainDimensions &chain,
                                const drive::Sprocket        &sprocket,
                                double                        sprocket_width,
                                unsigned int                  n_angles,
                                double                        position = 0.);

  /// The largest stress on the edge of the hole in a side plate that a pin pulls, per force on one
  /// of its eighths: the pressure on the far half of the hole is like the cosine of the angle.
  PeakStress pulled_plate(const drive::ChainDimensions &chain, bool inner);

  /// What a part cost, in the order of first use.
  struct Entry
  {
    std::string   name;
    unsigned long n_cells, n_unknowns;
    double        error;   ///< estimated, of the compliance or of the peak stress, relative
    double        seconds; ///< to compute it; 0: it was in the cache
  };
  const std::vector<Entry> &entries() const { return entries_; }

  /// Sentences on the cache.
  const std::vector<std::string> &notes() const { return cache_.notes(); }

private:
  /// What was kept for @p key and @p fits, else what @p compute gives. Collective; the same on all
  /// ranks.
  nlohmann::json result_of(const std::string                     &name,
                           const std::string                     &key,
                           const Cache::Fits                     &fits,
                           const std::function<nlohmann::json()> &compute);

  /// Of a piece with this @p name, which follows from @p geometry, material and sides alone.
  Flexibility flexibility_of(const std::string            &name,
                             const std::string            &geometry,
                             const std::function<Piece()> &make,
                             const std::vector<Side>      &sides);

  const Material     material_;
  const MPI_Comm     comm_;
  const Announce     announce_;
  Cache              cache_;
  std::vector<Entry> entries_;

  std::map<std::string, Flexibility> known_; ///< by what it follows from
};
} // namespace chaindrive::statics
