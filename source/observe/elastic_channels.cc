// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/recorder.h>

#include <deal.II/base/mpi.h>

#include <limits>

// Histories of elastic bodies.

namespace chaindrive::observe
{
namespace
{
using Row = dealii::ArrayView<double>;

std::vector<std::string> labels_of(const std::vector<unsigned int> &numbers)
{
  std::vector<std::string> labels;
  labels.reserve(numbers.size());
  for (const unsigned int k : numbers)
    labels.push_back(std::to_string(k));
  return labels;
}
} // namespace

void Recorder::add_elastic_channels()
{
  if (elastic_->has_rollers())
    {
      const auto surface = [&](const std::string          &name,
                               const std::string          &direction,
                               const dealii::Tensor<1, 3> &axis) {
        add({"rollers",
             "surface_velocity_" + name,
             "m/s",
             "Of a node of the surface, along the tight span's " + direction,
             static_cast<unsigned int>(rollers_.size()),
             labels_of(rollers_)},
            [this, axis](const auto &, Row row) {
              for (unsigned int i = 0; i < rollers_.size(); ++i)
                row[i] = surface_velocity_[i] * axis;
            });
      };
      surface("tangential", "direction of travel", scene_.span_direction);
      surface("normal", "outward normal", scene_.span_normal);
    }
  if (!elastic_->has_links())
    return;

  std::vector<unsigned int> links(scene_.n_joints);
  for (unsigned int k = 0; k < scene_.n_joints; ++k)
    links[k] = k;
  const auto plate = [&](const std::string &name,
                         const std::string &description,
                         double WaistStress::*value,
                         const double         sign = 1.) {
    add({"plates", name, "Pa", description, scene_.n_joints, labels_of(links)},
        [this, value, sign](const auto &, Row row) {
          for (unsigned int k = 0; k < waists_.size(); ++k)
            row[k] = sign * (waists_[k].*value);
        });
  };
  plate("axial_stress",
        "Stress along the link at the waist of a side plate, mean over the section",
        &WaistStress::axial);
  plate("bending_in_plane",
        "Half of that at the outer edge less that at the edge towards the chain's inside",
        &WaistStress::in_plane,
        scene_.sense);
  plate("bending_out_of_plane",
        "Half of that in the outer face less that in the face towards the middle plane",
        &WaistStress::out_of_plane);
  plate("principal_1",
        "Larger in-plane principal stress in the middle of the plate",
        &WaistStress::principal_1);
  plate("principal_2", "The smaller one", &WaistStress::principal_2);
}

void Recorder::look_at_elastic_bodies(const dynamics::System &system)
{
  const World   &world      = system.world;
  constexpr auto nan        = std::numeric_limits<double>::quiet_NaN();
  const auto     is_elastic = [&](const unsigned int body) {
    return world.elastic_address[body].group != World::Address::none;
  };
  // every rank looks at its own bodies and leaves zeros where others do
  surface_velocity_.assign(rollers_.size(), dealii::Tensor<1, 3>());
  for (unsigned int i = 0; i < rollers_.size(); ++i) // rollers are the bodies 0 ... N-1
    if (world.owns(rollers_[i]))
      surface_velocity_[i] = is_elastic(rollers_[i]) ?
                                 elastic_->surface_velocity(system, rollers_[i]) :
                                 nan * scene_.span_normal;

  waists_.assign(scene_.n_joints, WaistStress{});
  for (unsigned int b = 0; b < scene_.bodies.size(); ++b)
    {
      const scene::Body &body = scene_.bodies[b];
      if (world.owns(b) &&
          (body.kind == scene::Kind::inner_link || body.kind == scene::Kind::outer_link))
        waists_[body.number] =
            is_elastic(b) ? elastic_->waist(system, b) : WaistStress{nan, nan, nan, nan, nan};
    }

  std::vector<double> numbers;
  visit_elastic_values([&numbers](const double value) { numbers.push_back(value); });
  dealii::Utilities::MPI::sum(numbers, world.communicator(), numbers);
  auto next = numbers.begin();
  visit_elastic_values([&next](double &value) { value = *next++; });
}

template <typename Item>
void Recorder::visit_elastic_values(const Item &item)
{
  for (dealii::Tensor<1, 3> &v : surface_velocity_)
    for (unsigned int d = 0; d < 3; ++d)
      item(v[d]);
  for (WaistStress &waist : waists_)
    for (double WaistStress::*value : {&WaistStress::axial,
                                       &WaistStress::in_plane,
                                       &WaistStress::out_of_plane,
                                       &WaistStress::principal_1,
                                       &WaistStress::principal_2})
      item(waist.*value);
}
} // namespace chaindrive::observe
