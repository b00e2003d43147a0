// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/directory.h>
#include <chaindrive/observe/quantity.h>

#include <deal.II/base/exceptions.h>

#include <map>
#include <utility>

namespace chaindrive::observe
{
namespace
{
struct Known
{
  std::string                              name;
  std::optional<parameters::QuantityGroup> group;
  Registration::Make                       make;
  Contents                                 contents;
};

/// By their order. A function, so that it exists before the registrations of other sources.
std::map<int, Known> &all_known()
{
  static std::map<int, Known> known;
  return known;
}

files::Channel channel_of(const files::Described &history)
{
  const std::size_t slash = history.path.find('/');
  return {
      history.path.substr(0, slash), history.path.substr(slash + 1), history.unit, history.meaning};
}

/// The history @p path as its quantity describes it.
files::Described described(const std::string &path)
{
  for (const auto &[order, known] : all_known())
    for (const files::Described &history : known.contents.histories)
      if (history.path == path)
        return history;
  AssertThrow(false, dealii::ExcMessage("No quantity describes the history " + path));
  return {};
}
} // namespace

Registration::Registration(const std::string                             &name,
                           const int                                      order,
                           const std::optional<parameters::QuantityGroup> group,
                           Make                                           make,
                           const Contents                                &contents)
{
  for (const auto &[other_order, other] : all_known())
    AssertThrow(other_order != order && other.name != name,
                dealii::ExcMessage("The quantities " + name + " and " + other.name +
                                   " have the same name or order"));
  all_known()[order] = {name, group, std::move(make), contents};
}

std::vector<NamedQuantity> make_quantities(const Observation &start)
{
  std::vector<NamedQuantity> quantities;
  for (const auto &[order, known] : all_known())
    if (known.group && !start.model.output.asks_for(*known.group))
      continue;
    else if (auto quantity = known.make(start))
      quantities.push_back({known.name, std::move(quantity)});
  return quantities;
}

std::vector<std::pair<std::optional<parameters::QuantityGroup>, Contents>> all_contents()
{
  std::vector<std::pair<std::optional<parameters::QuantityGroup>, Contents>> all;
  all.reserve(all_known().size());
  for (const auto &[order, known] : all_known())
    all.emplace_back(known.group, known.contents);
  return all;
}

void Channels::add(const std::string &path, Fill fill) { add(described(path), std::move(fill)); }

void Channels::add(const files::Described &history, Fill fill)
{
  add(channel_of(history), std::move(fill));
}

void Channels::add(const std::string &path, const std::vector<std::string> &labels, Fill fill)
{
  add(described(path), labels, std::move(fill));
}

void Channels::add(const files::Described         &history,
                   const std::vector<std::string> &labels,
                   Fill                            fill)
{
  files::Channel channel = channel_of(history);
  channel.columns        = static_cast<unsigned int>(labels.size());
  channel.labels         = labels;
  add(std::move(channel), std::move(fill));
}

void Channels::add(files::Channel channel, Fill fill)
{
  AssertThrow(files::is_history_group(channel.group),
              dealii::ExcMessage("Histories of '" + channel.group + "' would never be removed"));
  channel.single = single_ && channel.columns > 1;
  sources_.push_back({histories_.add(channel), std::move(fill)});
}

void Channels::sample(const double time)
{
  histories_.begin_sample(time);
  for (const Source &source : sources_)
    source.fill(histories_.values(source.handle));
  histories_.end_sample();
}
} // namespace chaindrive::observe
