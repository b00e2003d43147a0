// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/declarations.h>
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/old_names.h>
#include <chaindrive/parameters/parameter_file.h>
#include <chaindrive/parameters/reader.h>
#include <chaindrive/parameters/sections.h>
#include <chaindrive/parameters/suggestions.h>
#include <chaindrive/parameters/tree_file.h>
#include <chaindrive/parameters/writer.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <utility>

namespace chaindrive::parameters
{
namespace
{
using dealii::Utilities::trim;

std::string folder_of(const std::string &file)
{
  const std::string folder = std::filesystem::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// Reads statements in the grammar of deal.II's ParameterHandler and collects a sentence for every
/// mistake, where ParameterHandler stops at the first one, in words for programmers.
class Reader
{
public:
  /// A study file has a section more, loops over values, and may include other files.
  explicit Reader(Input &input, Study *study = nullptr)
      : input_(input), study_(study), is_study_(study != nullptr)
  {
    declare();
  }

  void read_file(const std::string &file)
  {
    const std::string includes_it = std::exchange(file_, file);
    files_.push_back(file);
    if (const std::string folder = folder_of(file); files_.size() == 1 && folder != ".")
      input_.parameters.folders.insert(input_.parameters.folders.begin(), folder);
    if (files_.size() > most_files)
      throw InputError("'" + file + "': more than " + std::to_string(most_files) +
                       " files include each other; one may include itself.");
    input_.text     = read_text(file);
    const Form form = form_of_file(file);
    if (form != Form::prm)
      input_.text = as_prm(read_tree(input_.text, file, form));
    const std::vector<Line> lines = statements(input_.text);
    if (lines.empty() && form == Form::prm)
      throw InputError("The parameter file '" + file +
                       "' contains no entries. To start from a template, use: chaindrive template");
    set_in_.clear(); // what an included file says may be said otherwise
    for (const Line &line : lines)
      {
        line_ = line.number;
        read_statement(
            line, file + (form == Form::prm ? ", line " + std::to_string(line.number) : "") + ": ");
      }
    if (!open_.empty())
      {
        const auto &[path, line] = open_.back();
        errors_.push_back(file + ": section " + path.substr(path.rfind('/') + 1) +
                          ", opened in line " + std::to_string(line) +
                          ", is not closed: an 'end' is missing.");
      }
    open_.clear();
    file_ = includes_it;
  }

  /// Takes the value of an entry that exists; the one that says which wheels there are before those
  /// of wheels.
  void read_entry(const std::string &path, const std::string &value)
  {
    if (const Entry *entry = find(path, ""))
      set_value(*entry, value, "");
  }

  /// The present path of an entry, which may be called as in earlier versions; any other text as it
  /// is. Takes note of old names.
  std::string present_path(const std::string &path, const std::string &where)
  {
    const Entry *entry = find(path, where);
    return entry == nullptr ? path : entry->path();
  }

  /// Values of all entries that were set, by path; loops are among them.
  const std::map<std::string, std::string> &values() const { return values_; }

  const Declarations &declarations() const { return *declarations_; }

  /// Entries that are loops, in the order of all entries.
  std::vector<Loop> loops() const
  {
    std::vector<Loop> loops;
    for (const Entry &entry : declarations_->entries())
      if (const auto given = values_.find(entry.path());
          given != values_.end() && is_loop(given->second) && may_be_loop(entry))
        loops.push_back({entry.path(), given->second});
    return loops;
  }

  /// Of all files that were read, the last first.
  std::vector<std::string> folders() const
  {
    std::vector<std::string> folders;
    for (auto file = files_.rbegin(); file != files_.rend(); ++file)
      folders.push_back(folder_of(*file));
    return folders;
  }

  void read_override(const std::string &text)
  {
    const std::string where  = "--set \"" + text + "\": ";
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
      {
        errors_.push_back(where + "an override is written \"Section/Entry=value\".");
        return;
      }
    // the unit in an entry's name may itself contain a slash: compare whole paths
    const std::string path = trim(text.substr(0, equals));
    if (const Entry *entry = find(path, where))
      {
        set_value(*entry, trim(text.substr(equals + 1)), where);
        return;
      }
    errors_.push_back(where + "there is no entry '" + path + "'." +
                      advice_on_path(*declarations_, path, trim(text.substr(equals + 1))));
  }

  /// Throws the mistakes found so far.
  void throw_errors() const
  {
    std::string message;
    for (const std::string &error : errors_)
      message += (message.empty() ? "" : "\n") + error;
    if (!errors_.empty())
      throw InputError(message);
  }

  /// All entries with their values.
  std::string resolved() const
  {
    std::ostringstream out;
    write_prm(out, *declarations_, values_, false);
    return out.str();
  }

  /// Paths of the entries that were given another value than their default.
  std::vector<std::string> changed() const
  {
    std::vector<std::string> paths;
    for (const Entry &entry : declarations_->entries())
      {
        const auto given = values_.find(entry.path());
        if (given == values_.end() || given->second == entry.default_value)
          continue;
        const auto number = from_entry_text(given->second, unit::si);
        if (!number || number != from_entry_text(entry.default_value, unit::si))
          paths.push_back(entry.path());
      }
    return paths;
  }

  /// Converts what was given in units of designers to the entries that the program goes by.
  void convert_other_forms()
  {
    const Parameters &p = input_.parameters;
    convert("Driver speed in rpm", "Driver speed in rad/s", [](const double rpm) {
      return rpm * dealii::numbers::PI / 30.;
    });
    convert("Power in kW", "Resisting torque in N m", [&](const double kilowatt) {
      const Sprockets &sprockets = p.drive.sprockets;
      if (p.loads.driver_speed == 0.)
        errors_.emplace_back(
            "Loads/Power in kW needs a speed, but that of the driver is zero; give "
            "Loads/Resisting torque in N m in its place.");
      return p.loads.driver_speed == 0. ? 0. :
                                          1e3 * kilowatt / p.loads.driver_speed *
                                              sprockets.driven().teeth / sprockets.driver().teeth;
    });
  }

  /// Whether Drive/Number of links = auto.
  bool wants_links() const { return input_.parameters.drive.n_links == 0; }

  /// Gives the drive the number of links that @p n_links finds.
  void find_links(const std::function<unsigned int(const Drive &)> &n_links)
  {
    const Drive &drive = input_.parameters.drive;
    if (!n_links)
      throw InputError("Drive/Number of links = auto cannot be found here; give a number.");
    const std::string links = std::to_string(n_links(drive));
    set_value(*declarations_->find("Drive", "Number of links"), links, "");
    input_.notes.push_back("Drive/Number of links = auto: " + links + " for " + drive.places() +
                           ".");
  }

  /// Gives Output/Field interval in ms = auto the value that is used.
  void find_field_interval(const std::function<double(const Parameters &)> &interval)
  {
    const Parameters &p = input_.parameters;
    if (interval && !p.output.field_interval)
      set_value(*declarations_->find("Output", "Field interval in ms"),
                to_entry_text(interval(p), unit::milli),
                "");
  }

  std::string fixed() const
  {
    const bool has_region =
        input_.parameters.model.elastic_links == ElasticLinks::region_of_interest;
    std::string text;
    for (const Entry &entry : declarations_->entries())
      {
        if (entry.on_resume == OnResume::may_change ||
            (entry.on_resume == OnResume::must_stay_with_region_of_interest && !has_region))
          continue;
        const auto given = values_.find(entry.path());
        text += entry.path() + " = " +
                (given == values_.end() ? entry.default_value : given->second) + "\n";
      }
    return text;
  }

private:
  /// Declares all entries of the wheels that there are.
  void declare()
  {
    declarations_ = std::make_unique<Declarations>();
    input_.parameters.declare(*declarations_);
    if (study_ != nullptr)
      study_->declare(*declarations_);
  }

  /// The same for other wheels: what has been read so far is set again.
  void declare_wheels(const std::string &order)
  {
    Parameters anew;
    anew.drive.sprockets.set_order(dealii::Utilities::split_string_list(order, ','));
    anew.folders      = input_.parameters.folders;
    input_.parameters = anew;
    if (study_ != nullptr)
      *study_ = Study();
    declare();
    for (const auto &[path, value] : values_)
      if (const Entry *entry = find(path, ""); entry == nullptr)
        errors_.push_back(path + " = " + value + " is of a wheel that " + order_entry + " = " +
                          order + " does not name.");
      else if (!(is_study_ && is_loop(value) && may_be_loop(*entry)))
        declarations_->set(*entry, value, "");
  }

  /// What @p settings of a tree say beyond the defaults, of which a tree has all, as a .prm file.
  std::string as_prm(const std::vector<Setting> &settings)
  {
    for (const Setting &one : settings)
      if (one.path() == order_entry)
        read_entry(order_entry, one.value); // there are entries of other wheels then
    throw_errors();
    return beyond_defaults(settings, *declarations_, file_);
  }

  void read_statement(const Line &line, const std::string &where)
  {
    const std::size_t blank   = line.text.find(' ');
    const std::string keyword = line.text.substr(0, blank);
    const std::string rest    = blank == std::string::npos ? "" : trim(line.text.substr(blank + 1));
    if (keyword == "subsection" || keyword == "SUBSECTION")
      open_section(rest, line.number, where);
    else if (keyword == "end" || keyword == "END")
      close_section(rest, where);
    else if (keyword == "set" || keyword == "SET")
      read_set(rest, where);
    else if ((keyword == "include" || keyword == "INCLUDE") && is_study_)
      include(rest, where);
    else if (keyword == "include" || keyword == "INCLUDE")
      errors_.push_back(where + "files are not included in one another, so that one file tells "
                                "all about a run; copy the entries, or override them with --set. "
                                "Only studies have them: chaindrive study FILE.prm.");
    else
      errors_.push_back(
          where + "'" + line.text +
          "' is not understood: a line begins with 'subsection', 'set', 'end' or '#'." +
          (line.text.find('=') != std::string::npos ? " Is 'set' missing?" : ""));
  }

  void include(const std::string &name, const std::string &where)
  {
    if (!open_.empty())
      {
        errors_.push_back(where + "a file is included outside of all sections.");
        return;
      }
    const std::filesystem::path path(name);
    read_file(path.is_absolute() ?
                  name :
                  (std::filesystem::path(folder_of(file_)) / path).lexically_normal().string());
  }

  void open_section(const std::string &name, const unsigned int line, const std::string &where)
  {
    const std::string outer = open_.empty() ? "" : open_.back().first;
    const std::string path  = outer.empty() ? name : outer + "/" + name;
    // what stands in an unknown section is passed over: one sentence for it is enough
    if (declarations_->has_section(outer) && !declarations_->has_section(path))
      errors_.push_back(where + unknown_section(*declarations_, name, outer));
    open_.emplace_back(path, line);
  }

  void close_section(const std::string &rest, const std::string &where)
  {
    if (!rest.empty())
      errors_.push_back(where + "nothing may follow 'end' but a comment.");
    if (open_.empty())
      errors_.push_back(where + "this 'end' closes no section.");
    else
      open_.pop_back();
  }

  /// The entry with this path, also by the name that it had in earlier versions, which @p where is
  /// taken note of; null if there is none.
  const Entry *find(const std::string &path, const std::string &where)
  {
    const std::string present = current_path(path);
    for (const Entry &entry : declarations_->entries())
      if (entry.path() == path || entry.path() == present)
        {
          if (entry.path() != path)
            note_old_name(where, path + " is now called " + entry.path() + ".");
          return &entry;
        }
    return nullptr;
  }

  /// Once for each name.
  void note_old_name(const std::string &where, const std::string &sentence)
  {
    if (old_names_.insert(sentence).second)
      input_.notes.push_back(where + sentence);
  }

  void read_set(const std::string &rest, const std::string &where)
  {
    const std::string section = open_.empty() ? "" : open_.back().first;
    const std::size_t equals  = rest.find('=');
    if (equals == std::string::npos)
      {
        errors_.push_back(where + "an entry is written 'set Name = value'; the '=' is missing.");
        return;
      }
    if (!declarations_->has_section(section))
      return;
    const std::string name = trim(rest.substr(0, equals));
    const std::string path = section.empty() ? name : section + "/" + name;
    if (const Entry *entry = find(path, where))
      {
        const auto [before, is_first] = set_in_.emplace(entry->path(), Place{line_, path});
        if (!is_first && before->second.name != path)
          errors_.push_back(where + path + " and " + before->second.name + " of line " +
                            std::to_string(before->second.line) +
                            " are the old and the new name of one entry: give only " +
                            entry->path() + ".");
        else if (!is_first)
          input_.warnings.push_back(where + entry->path() + " was set before, in line " +
                                    std::to_string(before->second.line) + "; the value of line " +
                                    std::to_string(line_) + " holds.");
        before->second = {line_, path};
        set_value(*entry, trim(rest.substr(equals + 1)), where);
      }
    else
      errors_.push_back(
          where + unknown_entry(*declarations_, section, name, trim(rest.substr(equals + 1))));
  }

  /// What the section Study says is of the whole study, but for the ranks; and there are sections
  /// for one order of wheels.
  static bool may_be_loop(const Entry &entry)
  {
    return (entry.section != "Study" || entry.name == "Ranks") && entry.path() != order_entry;
  }

  /// @p where begins a message.
  void set_value(const Entry &entry, const std::string &given, const std::string &where)
  {
    const std::string value = current_value(entry.path(), given);
    if (value != given)
      note_old_name(where, entry.path() + " = " + given + " is now called " + value + ".");
    if (is_study_ && is_loop(value) && may_be_loop(entry))
      {
        values_[entry.path()] = value; // its values are checked with the variants
        return;
      }
    try
      {
        refuse_unwritable(entry.path(), value, where);
        const std::string path = entry.path();
        declarations_->set(entry, value, where);
        values_[path] = value;
        if (path == order_entry)
          declare_wheels(value); // after which there are other entries
      }
    catch (const InputError &error)
      {
        errors_.emplace_back(error.what());
        if (is_loop(value) && !is_study_)
          errors_.back() +=
              " Loops belong to studies, which are run by: chaindrive study FILE.prm.";
      }
  }

  /// Replaces the entry @p other of section Loads by @p entry, which has the value @p converted.
  template <typename Convert>
  void convert(const std::string &other, const std::string &entry, const Convert &converted)
  {
    const auto given = values_.find("Loads/" + other);
    if (given == values_.end() || given->second == "auto")
      return;
    if (const auto twice = values_.find("Loads/" + entry); twice != values_.end())
      {
        errors_.push_back("Loads/" + other + " = " + given->second + " and Loads/" + entry + " = " +
                          twice->second + " are two forms of one quantity: give one of them.");
        return;
      }
    const double value = converted(*from_entry_text(given->second, unit::si));
    values_.erase(given);
    set_value(*declarations_->find("Loads", entry), to_entry_text(value, unit::si), "");
  }

  static constexpr std::size_t most_files = 20;

  /// Where a file sets an entry, and by which name.
  struct Place
  {
    unsigned int line;
    std::string  name;
  };

  Input                                            &input_;
  Study *const                                      study_; ///< null: none
  const bool                                        is_study_;
  std::unique_ptr<Declarations>                     declarations_;
  std::string                                       file_;     ///< that is read
  std::vector<std::string>                          files_;    ///< read so far
  std::vector<std::pair<std::string, unsigned int>> open_;     ///< path, line of each open section
  std::map<std::string, std::string>                values_;   ///< of all entries set, by path
  std::map<std::string, Place>                      set_in_;   ///< this file's, by path
  unsigned int                                      line_ = 0; ///< that is read
  std::vector<std::string>                          errors_;
  std::set<std::string>                             old_names_; ///< sentences noted
};
} // namespace

namespace
{
/// What holds across entries, once all are read.
void finish(Input &input, Reader &reader, const Completion &completion)
{
  reader.throw_errors();
  reader.convert_other_forms();
  reader.throw_errors();
  input.parameters.material.resolve(input.parameters.drive.chain.designation);
  std::vector<std::string> changed = reader.changed();
  if (reader.wants_links())
    {
      reader.find_links(completion.n_links);
      reader.throw_errors();
      // it has had its effect
      changed.erase(
          std::remove(changed.begin(), changed.end(), "Drive/Layout/Centre distance in mm"),
          changed.end());
    }
  reader.find_field_interval(completion.field_interval);
  if (completion.check)
    for (const std::string &note : completion.check(input.parameters, changed))
      input.notes.push_back(note);
  input.resolved = reader.resolved();
  input.fixed    = reader.fixed();
}
} // namespace

Input read_parameters(const std::string              &file,
                      const std::vector<std::string> &overrides,
                      const Completion               &completion)
{
  Input  input;
  Reader reader(input);
  reader.read_file(file);
  for (const std::string &override_text : overrides)
    reader.read_override(override_text);
  finish(input, reader, completion);
  return input;
}

std::string in_form(const std::string &file, const Form form)
{
  Input  input;
  Reader reader(input);
  reader.read_file(file);
  reader.throw_errors();
  return in_form(reader.declarations(), reader.values(), form);
}

std::string in_form(const std::map<std::string, std::string> &values, const Form form)
{
  Input  input;
  Reader reader(input);
  for (const auto &[path, value] : values)
    reader.read_entry(path, value);
  reader.throw_errors();
  return in_form(reader.declarations(), reader.values(), form);
}

Input read_entries(const std::map<std::string, std::string> &values, const Completion &completion)
{
  Input  input;
  Reader reader(input);
  if (const auto order = values.find(order_entry); order != values.end())
    reader.read_entry(order->first, order->second);
  for (const auto &[path, value] : values)
    if (path != order_entry)
      reader.read_entry(path, value);
  finish(input, reader, completion);
  return input;
}

StudyInput
read_study(const std::string &file, const std::vector<std::string> &overrides, const bool quick)
{
  StudyInput result;
  Study     &study = result.study;
  Input      input;
  Reader     reader(input, &study);
  reader.read_file(file);
  reader.throw_errors();
  if (quick && study.quick.empty())
    throw InputError("'" + file + "' has no quick form: Study/Quick says nothing.");
  if (quick)
    for (const std::string &override_text : std::vector<std::string>(study.quick))
      reader.read_override(override_text);
  for (const std::string &override_text : overrides)
    reader.read_override(override_text);
  reader.throw_errors();

  const std::vector<Loop>        loops = reader.loops();
  const std::vector<Choices>     all   = combinations(loops);
  const std::vector<std::string> names = names_of(loops, all);
  for (std::size_t i = 0; i < all.size(); ++i)
    {
      Variant variant;
      variant.name    = names[i];
      variant.choices = all[i];
      variant.values  = reader.values();
      for (const auto &[path, value] : all[i])
        variant.values[path] = value;
      if (const auto ranks = variant.values.find("Study/Ranks"); ranks != variant.values.end())
        {
          reader.read_entry(ranks->first, ranks->second);
          variant.ranks = study.ranks;
        }
      for (auto entry = variant.values.begin(); entry != variant.values.end();)
        entry = entry->first.compare(0, 6, "Study/") == 0 ? variant.values.erase(entry) :
                                                            std::next(entry);
      result.variants.push_back(variant);
    }
  reader.throw_errors();
  if (!study.against.empty())
    study.against = reader.present_path(study.against, "Study/Against: ");
  result.notes = input.notes;
  study.check_outputs();
  study.check_against(result.variants);
  study.name(result.variants);
  result.folders = reader.folders();
  return result;
}
} // namespace chaindrive::parameters
