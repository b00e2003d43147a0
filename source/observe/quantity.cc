// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/directory.h>
#include <chaindrive/observe/quantity.h>

#include <deal.II/base/exceptions.h>

#include <utility>

namespace chaindrive::observe
{
namespace
{
struct KindOfQuantity
{
  std::optional<parameters::QuantityGroup> group;
  Registration::Make                       make;
  Contents                                 contents;
};

Registry<KindOfQuantity> &all_known()
{
  static Registry<KindOfQuantity> known("quantity");
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
  for (const KindOfQuantity &known : all_known().items())
    for (const files::Described &history : known.contents.histories)
      if (history.path == path)
        return history;
  AssertThrow(false, dealii::ExcMessage("No quantity describes the history " + path));
  return {};
}
} // namespace

Registration::Registration(const About                                   &about,
                           const std::optional<parameters::QuantityGroup> group,
                           Make                                           make,
                           const Contents                                &contents)
{
  all_known().add(about, {group, std::move(make), contents});
}

std::vector<NamedQuantity> make_quantities(const Observation &start)
{
  std::vector<NamedQuantity> quantities;
  for (const auto &[entry, known] : all_known().in_order())
    if (known.group && !start.model.output.asks_for(*known.group))
      continue;
    else if (auto quantity = known.make(start))
      quantities.push_back({entry.about.name, std::move(quantity)});
  return quantities;
}

std::vector<std::pair<std::optional<parameters::QuantityGroup>, Contents>> all_contents()
{
  std::vector<std::pair<std::optional<parameters::QuantityGroup>, Contents>> all;
  for (const auto &[entry, known] : all_known().in_order())
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
