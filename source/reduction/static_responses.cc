// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/static_responses.h>
#include <chaindrive/utilities/checksum.h>
#include <chaindrive/utilities/first_rank.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/version.h>

#include <algorithm>

namespace chaindrive::reduction
{
namespace
{
/// Of what is kept: to be raised with every change that changes results.
constexpr unsigned int responses_version = 1;

/// All that the responses follow from.
std::string key_of(const mesh::Part           &part,
                   const Material             &material,
                   const parameters::Elements &elements,
                   const std::vector<Vector>  &quantities)
{
  Checksum   sum;
  const auto add = [&sum](const double *numbers, const std::size_t n) {
    sum.add(reinterpret_cast<const char *>(numbers), n * sizeof(double));
  };
  for (const auto &vertex : part.mesh->get_vertices())
    add(vertex.begin_raw(), 3);
  for (const auto &cell : part.mesh->active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      {
        const double index = cell->vertex_index(v);
        add(&index, 1);
      }
  for (const Vector &quantity : quantities)
    add(quantity.begin(), quantity.size());
  const auto number = [](const double value) { return " " + to_text(value, 12); };
  return "static responses of the " + part.name + "; mesh and quantities " +
         std::to_string(sum.value()) + "; material" + number(material.youngs_modulus) +
         number(material.poissons_ratio) + number(material.density) + "; elements " +
         parameters::text_of(elements.formulation) + number(elements.hourglass_coefficient) + " " +
         parameters::text_of(elements.plates) + " " + parameters::text_of(elements.bushes) +
         "; half " + std::to_string(part.half) + "; version " + std::to_string(responses_version) +
         " of " + chaindrive::version;
}
} // namespace

std::vector<Vector> kept_static_responses(const mesh::Part           &part,
                                          const Material             &material,
                                          const parameters::Elements &elements,
                                          const std::vector<Vector>  &quantities,
                                          statics::Cache             &cache,
                                          const MPI_Comm              comm)
{
  const std::size_t   n = quantities.empty() ? 0 : quantities.front().size();
  std::vector<double> numbers; // one response after the other
  on_first_rank(comm, [&] {
    const std::string key  = key_of(part, material, elements, quantities);
    const auto        fits = [&](const nlohmann::json &json) {
      return json.is_array() && json.size() == quantities.size() * n &&
             std::all_of(json.begin(), json.end(), [](const nlohmann::json &number) {
               return number.is_number();
             });
    };
    if (const auto found = cache.find(key, fits))
      {
        numbers = found->get<std::vector<double>>();
        return;
      }
    const mesh::Nodes nodes(part);
    const FreePart    free(part, nodes, element::ElasticPart(part, nodes, material, elements));
    for (const Vector &quantity : quantities)
      {
        const Vector response = free.displacement(quantity);
        numbers.insert(numbers.end(), response.begin(), response.end());
      }
    cache.keep(key, numbers);
  });
  if (n_ranks_in(comm) > 1)
    numbers = dealii::Utilities::MPI::broadcast(comm, numbers);
  std::vector<Vector> responses;
  for (std::size_t i = 0; i < quantities.size(); ++i)
    {
      const auto first = numbers.begin() + std::ptrdiff_t(i * n);
      responses.emplace_back(first, first + std::ptrdiff_t(n));
    }
  return responses;
}
} // namespace chaindrive::reduction
