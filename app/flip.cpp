// `unghost flip`: how different two pictures look.
#include <algorithm>
#include <chrono>
#include <cmath>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/exr_file.h"
#include "app/failure.h"
#include "app/measure/flip.h"
#include "app/measure/magma.h"
#include "app/measure/quantile.h"
#include "app/picture_input.h"
#include "app/picture_output.h"
#include "app/png_file.h"
#include "app/table.h"

namespace unghost {
namespace {

ToneMapper tone_mapper_of(const std::string& name) {
  return std::ranges::find(tone_mappers, name, [](const auto& row) { return std::string_view(row.first); })
      ->second;
}

struct Compared {
  FloatImage error;
  nlohmann::json facts; // beyond those of every comparison
};

Compared compare_hdr(const CommandLine& line, const FloatImage& reference, const FloatImage& test,
                     const FlipOptions& options) {
  const std::string name = line.flip.tone_mapper;
  Exposures exposures = exposures_of(reference, tone_mapper_of(name));
  if (line.flip.first_exposure) exposures.first = *line.flip.first_exposure;
  if (line.flip.last_exposure) exposures.last = *line.flip.last_exposure;
  if (exposures.last < exposures.first) throw WrongWords("--last-exposure lies before --first-exposure");
  exposures.count = line.flip.exposures.value_or(
      std::min(exposures_between(exposures.first, exposures.last), most_exposures));
  return {hdr_flip(reference, test, exposures, tone_mapper_of(name), options).error,
          {{"tone_mapper", name},
           {"exposures", exposures.count},
           {"first_exposure", exposures.first},
           {"last_exposure", exposures.last}}};
}

Compared compare_pictures(const CommandLine& line, const LinearPicture& reference,
                          const LinearPicture& test) {
  const FlipOptions options{.pixels_per_degree = line.flip.ppd.value_or(FlipOptions{}.pixels_per_degree),
                            .threads = line.flip.threads};
  if (reference.hdr) return compare_hdr(line, reference.image, test.image, options);
  if (line.flip.first_exposure || line.flip.last_exposure || line.flip.exposures)
    throw WrongWords("exposures are for OpenEXR and Radiance HDR pictures");
  return {flip(reference.image, test.image, options), nlohmann::json::object()};
}

struct TimedComparison {
  Compared compared;
  std::vector<double> ms; // of each round
};

TimedComparison compare_in_rounds(const CommandLine& line, const LinearPicture& reference,
                                  const LinearPicture& test) {
  TimedComparison timed;
  for (uint32_t round = 0; round < line.flip.rounds.value_or(1); ++round) {
    const auto start = std::chrono::steady_clock::now();
    timed.compared = compare_pictures(line, reference, test);
    timed.ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  return timed;
}

void say_times(const CommandLine& line, const std::vector<double>& ms, nlohmann::json& object,
               Console& console) {
  const double best = quantile(ms, 0), median = quantile(ms, 0.5);
  const unsigned threads = threads_of(line.flip.threads);
  object.update({{"best_ms", best}, {"median_ms", median}, {"threads", threads}, {"rounds", ms.size()}});
  if (!line.json && !console.quiet)
    console.err << "the error took " << fixed(best, 1) << " ms at best and " << fixed(median, 1)
                << " in the median of " << ms.size() << (ms.size() > 1 ? " rounds, on " : " round, on ")
                << threads << (threads > 1 ? " threads" : " thread")
                << "; reading the files is not counted\n";
}

void check_alike(const CommandLine& line, const LinearPicture& a, const LinearPicture& b) {
  const auto size = [](const FloatImage& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
  };
  if (a.image.width != b.image.width || a.image.height != b.image.height)
    throw Failure(Exit::input_refused, *line.flip.reference + " is " + size(a.image) + " and " +
                                           *line.flip.test + " is " + size(b.image) +
                                           ": pictures of one size can be compared");
  if (a.hdr != b.hdr)
    throw Failure(Exit::input_refused,
                  (a.hdr ? *line.flip.test : *line.flip.reference) +
                      " is what a screen shows, and the other one is not: tone-map it first");
}

} // namespace

void flip_command(const CommandLine& line, Console& console) {
  if (!line.flip.reference || !line.flip.test)
    throw WrongWords("flip wants two pictures: unghost flip REFERENCE TEST");
  std::unique_ptr<PictureOutput> output;
  if (!line.output.empty()) output = std::make_unique<PictureOutput>(line, console);
  const LinearPicture reference = read_picture(*line.flip.reference), test = read_picture(*line.flip.test);
  check_alike(line, reference, test);
  const TimedComparison timed = compare_in_rounds(line, reference, test);
  const Compared& compared = timed.compared;
  const FlipSummary s = summary_of(compared.error.values);
  nlohmann::json object = compared.facts;
  object.update({{"mean", s.mean},
                 {"min", s.min},
                 {"max", s.max},
                 {"weighted_first_quartile", s.weighted_first_quartile},
                 {"weighted_median", s.weighted_median},
                 {"weighted_third_quartile", s.weighted_third_quartile},
                 {"ppd", line.flip.ppd.value_or(FlipOptions{}.pixels_per_degree)},
                 {"width", compared.error.width},
                 {"height", compared.error.height}});
  if (output != nullptr)
    output->write(output->is_exr() ? encode_exr({{"Y", &compared.error, 0}}, object.dump())
                                   : encode_png(magma(compared.error), object.dump()));
  if (line.flip.rounds) say_times(line, timed.ms, object, console); // no part of what the picture says
  if (output != nullptr && line.output == "-") return;
  Table table{
      {"mean", "min", "max", "weighted first quartile", "weighted median", "weighted third quartile"}};
  table.add({fixed(s.mean, 6), fixed(s.min, 6), fixed(s.max, 6), fixed(s.weighted_first_quartile, 6),
             fixed(s.weighted_median, 6), fixed(s.weighted_third_quartile, 6)});
  console.out << (line.json ? object.dump(2) + "\n" : table.text());
}

} // namespace unghost
