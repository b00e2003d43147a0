// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/catalogue.h>

#include <array>
#include <iterator>
#include <map>

namespace chaindrive::drive
{
namespace
{
constexpr double mm = 1e-3, kN = 1e3;

/// ANSI/ASME B29.1: plate heights are at most 0.95 and 0.82 of the pitch.
CatalogueChain ansi(const std::string &designation,
                    const double       p,
                    const double       d1,
                    const double       b1,
                    const double       d2,
                    const double       t,
                    const double       strength,
                    const double       mass,
                    const bool         has_rollers = true)
{
  return {designation,
          p * mm,
          d1 * mm,
          b1 * mm,
          d2 * mm,
          0.95 * p * mm,
          0.82 * p * mm,
          t * mm,
          t * mm,
          strength * kN,
          mass,
          has_rollers};
}

/// kg/m of the ANSI chain of this pitch and roller, which is the same chain.
double mass_of_ansi(const double pitch, const double roller_diameter)
{
  for (const CatalogueChain &row : ansi_chains())
    if (row.pitch == pitch && row.roller_diameter == roller_diameter)
      return row.mass_per_metre;
  return 0.;
}

CatalogueChain iso_a(const std::string &designation,
                     const double       p,
                     const double       d1,
                     const double       b1,
                     const double       d2,
                     const double       h2,
                     const double       ansi_t,
                     const double       strength,
                     const bool         has_rollers = true)
{
  return {designation,
          p * mm,
          d1 * mm,
          b1 * mm,
          d2 * mm,
          h2 * mm,
          0.82 * p * mm,
          ansi_t * mm,
          ansi_t * mm,
          strength * kN,
          mass_of_ansi(p * mm, d1 * mm),
          has_rollers};
}

CatalogueChain iso_b(const std::string &designation,
                     const double       p,
                     const double       b1,
                     const double       d1,
                     const double       d2,
                     const double       h2,
                     const double       h3,
                     const double       t_inner,
                     const double       t_outer,
                     const double       strength,
                     const double       mass,
                     const double       duplex,
                     const double       triplex)
{
  return {designation,
          p * mm,
          d1 * mm,
          b1 * mm,
          d2 * mm,
          h2 * mm,
          h3 * mm,
          t_inner * mm,
          t_outer * mm,
          strength * kN,
          mass,
          true,
          duplex * kN,
          triplex * kN};
}

/// The heavy chain of an ANSI size: plates of the thickness @p t.
CatalogueChain heavy(const CatalogueChain &standard, const double t, const double mass = 0.)
{
  CatalogueChain chain        = standard;
  chain.designation           = standard.designation + "H";
  chain.inner_plate_thickness = chain.outer_plate_thickness = t * mm;
  chain.mass_per_metre                                      = mass;
  return chain;
}

CatalogueChain motorcycle(const std::string &designation,
                          const double       p,
                          const double       d1,
                          const double       b1,
                          const double       strength)
{
  return {designation, p * mm, d1 * mm, b1 * mm, 0., 0., 0., 0., 0., strength * kN, 0.};
}
} // namespace

double CatalogueChain::strength_of(const unsigned int strands) const
{
  const double of_three = triplex_strength > 0. ? triplex_strength : 3. * tensile_strength;
  return strands == 1                         ? tensile_strength :
         strands == 2 && duplex_strength > 0. ? duplex_strength :
         strands == 2                         ? 2. * tensile_strength :
                                                strands / 3. * of_three;
}

namespace
{
std::vector<CatalogueChain> ansi_and_heavy()
{
  std::vector<CatalogueChain> rows = {ansi("25", 6.350, 3.30, 3.18, 2.30, 0.76, 3.47, 0.125, false),
                                      ansi("35", 9.525, 5.08, 4.78, 3.58, 1.27, 7.83, 0.313, false),
                                      ansi("41", 12.70, 7.77, 6.35, 3.58, 1.27, 6.67, 0.417),
                                      ansi("40", 12.70, 7.92, 7.92, 3.96, 1.52, 13.9, 0.610),
                                      ansi("50", 15.875, 10.16, 9.53, 5.08, 2.03, 21.7, 1.012),
                                      ansi("60", 19.05, 11.91, 12.70, 5.94, 2.39, 31.3, 1.488),
                                      ansi("80", 25.40, 15.88, 15.88, 7.92, 3.18, 55.6, 2.515),
                                      ansi("100", 31.75, 19.05, 19.05, 9.53, 3.96, 86.9, 3.706),
                                      ansi("120", 38.10, 22.23, 25.40, 11.10, 4.75, 125.1, 5.462),
                                      ansi("140", 44.45, 25.40, 25.40, 12.70, 5.56, 170.3, 7.337),
                                      ansi("160", 50.80, 28.58, 31.75, 14.27, 6.35, 222.4, 9.569),
                                      ansi("180", 57.15, 35.71, 35.71, 17.45, 7.14, 281.5, 12.95),
                                      ansi("200", 63.50, 39.67, 38.10, 19.84, 7.92, 347.5, 15.64),
                                      ansi("240", 76.20, 47.63, 47.63, 23.80, 9.53, 500.4, 25.15)};
  const std::size_t           first       = 5; // 60
  const double                thickness[] = {3.18, 3.96, 4.75, 5.56, 6.35, 7.14, 7.92, 9.53, 12.70};
  for (std::size_t i = 0; i < std::size(thickness); ++i)
    rows.push_back(
        heavy(rows[first + i], thickness[i], rows[first + i].designation == "80" ? 3.10 : 0.));
  return rows;
}
} // namespace

const std::vector<CatalogueChain> &ansi_chains()
{
  static const std::vector<CatalogueChain> rows = ansi_and_heavy();
  return rows;
}

const std::vector<CatalogueChain> &iso_a_chains()
{
  static const std::vector<CatalogueChain> rows = {
      iso_a("04C", 6.350, 3.30, 3.10, 2.31, 6.02, 0.76, 3.5, false),
      iso_a("06C", 9.525, 5.08, 4.68, 3.60, 9.05, 1.27, 7.9, false),
      iso_a("085", 12.70, 7.77, 6.25, 3.60, 9.91, 1.27, 6.7),
      iso_a("08A", 12.70, 7.92, 7.85, 3.98, 12.07, 1.52, 13.9),
      iso_a("10A", 15.875, 10.16, 9.40, 5.09, 15.09, 2.03, 21.8),
      iso_a("12A", 19.05, 11.91, 12.57, 5.96, 18.10, 2.39, 31.3),
      iso_a("16A", 25.40, 15.88, 15.75, 7.94, 24.13, 3.18, 55.6),
      iso_a("20A", 31.75, 19.05, 18.90, 9.54, 30.17, 3.96, 87.0),
      iso_a("24A", 38.10, 22.23, 25.22, 11.11, 36.20, 4.75, 125.0),
      iso_a("28A", 44.45, 25.40, 25.22, 12.71, 42.23, 5.56, 170.0),
      iso_a("32A", 50.80, 28.58, 31.55, 14.29, 48.26, 6.35, 223.0),
      iso_a("36A", 57.15, 35.71, 35.48, 17.46, 54.30, 7.14, 281.0),
      iso_a("40A", 63.50, 39.67, 37.85, 19.85, 60.33, 7.92, 347.0),
      iso_a("48A", 76.20, 47.63, 47.35, 23.81, 72.39, 9.53, 500.0)};
  return rows;
}

const std::vector<CatalogueChain> &iso_b_chains()
{
  static const std::vector<CatalogueChain> rows = {
      iso_b("05B", 8.00, 3.00, 5.00, 2.31, 7.11, 7.11, 0.75, 0.75, 4.4, 0.18, 7.8, 11.1),
      iso_b("06B", 9.525, 5.72, 6.35, 3.28, 8.26, 8.26, 1.30, 1.00, 8.9, 0.41, 16.9, 24.9),
      iso_b("08B", 12.70, 7.75, 8.51, 4.45, 11.81, 10.92, 1.60, 1.60, 17.8, 0.70, 31.1, 44.5),
      iso_b("10B", 15.875, 9.65, 10.16, 5.08, 14.73, 13.72, 1.70, 1.70, 22.2, 0.95, 44.5, 66.7),
      iso_b("12B", 19.05, 11.68, 12.07, 5.72, 16.13, 16.13, 1.85, 1.85, 28.9, 1.25, 57.8, 86.7),
      iso_b("16B", 25.40, 17.02, 15.88, 8.28, 21.08, 21.08, 4.15, 3.10, 60.0, 2.70, 106., 160.),
      iso_b("20B", 31.75, 19.56, 19.05, 10.19, 26.42, 26.42, 4.50, 3.50, 95.0, 3.60, 170., 250.),
      iso_b("24B", 38.10, 25.40, 25.40, 14.63, 33.40, 33.40, 6.00, 4.80, 160., 6.70, 280., 425.),
      iso_b("28B", 44.45, 30.99, 27.94, 15.90, 37.08, 37.08, 7.50, 6.00, 200., 8.30, 360., 530.),
      iso_b("32B", 50.80, 30.99, 29.21, 17.81, 42.29, 42.29, 7.00, 6.00, 250., 10.5, 450., 670.),
      iso_b("40B", 63.50, 38.10, 39.37, 22.89, 52.96, 52.96, 8.50, 8.00, 355., 16.0, 630., 950.),
      iso_b("48B", 76.20, 45.72, 48.26, 29.24, 63.88, 63.88, 12.0, 10.0, 560., 25.0, 1000., 1500.),
      iso_b("56B", 88.90, 53.34, 53.98, 34.32, 77.85, 77.85, 13.6, 12.3, 850., 35.78, 1600., 2240.),
      iso_b(
          "64B", 101.60, 60.96, 63.50, 39.40, 90.17, 90.17, 15.2, 13.6, 1120., 46.0, 2000., 3000.),
      iso_b("72B",
            114.30,
            68.58,
            72.39,
            44.48,
            103.63,
            103.63,
            17.4,
            15.7,
            1400.,
            60.8,
            2500.,
            3750.)};
  return rows;
}

const std::vector<CatalogueChain> &bicycle_chains()
{
  static const std::vector<CatalogueChain> rows = {
      iso_b("081C", 12.70, 3.30, 7.75, 3.66, 9.91, 9.91, 1.0, 1.0, 8.0, 0.28, 0., 0.),
      iso_b("082C", 12.70, 2.38, 7.75, 3.66, 9.91, 9.91, 1.0, 1.0, 8.0, 0.26, 0., 0.)};
  return rows;
}

const std::vector<CatalogueChain> &motorcycle_chains()
{
  static const std::vector<CatalogueChain> rows = [] {
    std::vector<CatalogueChain> chains = {motorcycle("219", 7.774, 4.59, 4.68, 0.),
                                          motorcycle("415", 12.70, 7.77, 4.76, 7.1),
                                          motorcycle("420", 12.70, 7.77, 6.35, 15.6),
                                          motorcycle("428", 12.70, 8.51, 7.94, 16.7),
                                          motorcycle("520", 15.875, 10.16, 6.35, 26.5),
                                          motorcycle("525", 15.875, 10.16, 7.94, 26.5),
                                          motorcycle("530", 15.875, 10.16, 9.53, 26.5),
                                          motorcycle("532", 15.875, 11.10, 9.53, 0.),
                                          motorcycle("630", 19.05, 11.91, 9.53, 35.3)};
    // Table 2 of Zheng et al.; plates of the heights of a 10A, which has the same pitch and roller
    CatalogueChain &chain_525       = chains[5];
    chain_525.pin_diameter          = 5.24 * mm;
    chain_525.inner_plate_height    = 15.09 * mm;
    chain_525.outer_plate_height    = 13.02 * mm;
    chain_525.inner_plate_thickness = 2.0 * mm;
    chain_525.outer_plate_thickness = 2.0 * mm;
    return chains;
  }();
  return rows;
}

namespace
{
std::array<const std::vector<CatalogueChain> *, 5> tables()
{
  return {
      {&ansi_chains(), &iso_a_chains(), &iso_b_chains(), &bicycle_chains(), &motorcycle_chains()}};
}
} // namespace

const CatalogueChain *find_chain(const std::string &designation)
{
  for (const auto *table : tables())
    for (const CatalogueChain &chain : *table)
      if (chain.designation == designation)
        return &chain;
  return nullptr;
}

double transverse_pitch_of(const std::string &designation)
{
  static const std::map<std::string, double> in_mm = {
      {"05B", 5.64},   {"06B", 10.24},  {"08B", 13.92},  {"10B", 16.59},  {"12B", 19.46},
      {"16B", 31.88},  {"20B", 36.45},  {"24B", 48.36},  {"28B", 59.56},  {"32B", 58.55},
      {"40B", 72.29},  {"48B", 91.21},  {"56B", 106.60}, {"64B", 119.89}, {"72B", 136.27},
      {"04C", 6.40},   {"06C", 10.13},  {"08A", 14.38},  {"10A", 18.11},  {"12A", 22.78},
      {"16A", 29.29},  {"20A", 35.76},  {"24A", 45.44},  {"28A", 48.87},  {"32A", 58.55},
      {"36A", 65.84},  {"40A", 71.55},  {"48A", 87.83},  {"25", 6.40},    {"35", 10.13},
      {"40", 14.38},   {"50", 18.11},   {"60", 22.78},   {"80", 29.29},   {"100", 35.76},
      {"120", 45.44},  {"140", 48.87},  {"160", 58.55},  {"180", 65.84},  {"200", 71.55},
      {"240", 87.83},  {"60H", 26.11},  {"80H", 32.59},  {"100H", 39.09}, {"120H", 48.87},
      {"140H", 52.20}, {"160H", 61.90}, {"180H", 69.16}, {"200H", 78.31}, {"240H", 101.22}};
  const auto found = in_mm.find(designation);
  return found == in_mm.end() ? 0. : found->second * mm;
}

std::vector<std::string> chain_designations()
{
  std::vector<std::string> names;
  for (const auto *table : tables())
    for (const CatalogueChain &chain : *table)
      names.push_back(chain.designation);
  return names;
}
} // namespace chaindrive::drive
