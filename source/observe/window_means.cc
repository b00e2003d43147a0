// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/window_means.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/exceptions.h>

namespace chaindrive::observe
{
WindowMeans::WindowMeans(const Observation &now, const std::initializer_list<std::string> names)
    : now_(now)
{
  // a last step may end a little later than the run: a run that goes on counts all of it
  const WindowMean empty(now.window().start(), now.window().end());
  for (const std::string &name : names)
    means_.emplace_back(name, empty);
}

void WindowMeans::add(const std::initializer_list<double> values)
{
  Assert(values.size() == means_.size(), dealii::ExcMessage("One value for each name"));
  auto mean = means_.begin();
  for (const double value : values)
    {
      if (now_.window().settled()) // since when is not known from the start
        mean->second.move_to(now_.window().start(), now_.window().end());
      (mean++)->second.add(now_.time() - now_.dt(), now_.dt(), value);
    }
}

void WindowMeans::summarize(files::Json &summary) const
{
  for (const auto &[name, mean] : means_)
    summary[name + "_mean"] = mean.mean();
}

void WindowMeans::serialize(const Archive &archive)
{
  const double time = now_.time();
  for (auto &[name, mean] : means_)
    {
      mean.move_to(now_.window().start(), now_.window().end());
      WindowMean earlier = mean;
      archive(name, earlier);
      if (archive.reads() && !mean.go_on_from(earlier, time))
        throw InputError("its means up to " + to_text(time * 1e3) +
                         " ms belong to another window; leave Output/Window start in ms and "
                         "Window end in ms as they were");
    }
}
} // namespace chaindrive::observe
