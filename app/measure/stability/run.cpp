#include "app/measure/stability/run.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <mutex>
#include <thread>

#include <sched.h>

#include "app/measure/stability/block_world.h"

namespace unghost {
namespace {

/// At least one, which is none where the system does not say.
constexpr int any_core = -1;
std::vector<int> cores_of_this_process() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) != 0) return {any_core};
  std::vector<int> cores;
  for (int core = 0; core < CPU_SETSIZE; ++core)
    if (CPU_ISSET(core, &set)) cores.push_back(core);
  return cores;
}

/// A software device asks once how many cores there are, and draws with a thread for each; pictures as small
/// as these take longer to hand over than to draw. With one it draws them where it is asked to.
void keep_to(int core) {
  if (core == any_core) return;
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(core, &set);
  sched_setaffinity(0, sizeof set, &set);
}

struct Work {
  const StabilityRequest& request;
  size_t worker, workers;
  std::mutex& one_at_a_time;
  std::atomic<bool>& stopped; // some other worker could not go on
};

/// Of one worker: by case; empty where it has no part in it.
struct Done {
  DeviceFacts device;
  std::vector<std::vector<Survival>> survived;
  std::vector<std::string> validation_messages;
};

std::vector<ModeRun> modes_of(const Work& work) {
  std::vector<ModeRun> own;
  for (size_t i = work.worker; i < work.request.modes.size(); i += work.workers)
    own.push_back(work.request.modes[i]);
  return own;
}

std::vector<Survival> run_case(const StabilityCase& row, StabilityBench& bench,
                               const std::vector<ModeRun>& own, const Work& work) {
  switch (row.takers) {
  case Takers::by_mode:
    return own.empty() ? std::vector<Survival>{} : row.run(bench, own);
  case Takers::by_trial:
    return row.run(bench, work.request.modes);
  case Takers::alone:
    return work.worker == 0 ? row.run(bench, own) : std::vector<Survival>{};
  }
  return {};
}

Done run_all(const Work& work) {
  const StabilityRequest& request = work.request;
  Device device(request.device);
  StabilityBench bench{.device = device,
                       .shaders = request.shaders,
                       .resolve = ResolveAlone(device, request.shaders),
                       .blocks = block_renderer(device, request.shaders),
                       .asphalt = [&]() -> const Film& { return request.asphalt(work.worker); },
                       .endurance = request.endurance,
                       .seed = request.seed,
                       .trial = request.trial,
                       .share = work.worker,
                       .shares = work.workers};
  const std::vector<ModeRun> own = modes_of(work);
  Done done{.device = device.facts(), .survived = {}, .validation_messages = {}};
  for (const StabilityCase* row : request.cases) {
    if (work.stopped) break;
    if (request.begins) {
      const std::lock_guard lock(work.one_at_a_time);
      request.begins(row->name);
    }
    done.survived.push_back(run_case(*row, bench, own, work));
    if (request.ends) {
      const std::lock_guard lock(work.one_at_a_time);
      request.ends();
    }
  }
  done.validation_messages = device.validation_messages();
  return done;
}

/// Whoever cannot go on stops the others.
Done run_or_stop(const Work& work, int core) {
  keep_to(core);
  try {
    return run_all(work);
  } catch (...) {
    work.stopped = true;
    throw;
  }
}

/// A mode's figure lies with the worker whose turn it was.
std::vector<StabilityCell> cells_of(const StabilityRequest& request, const std::vector<Done>& done) {
  std::vector<StabilityCell> cells;
  for (size_t row = 0; row < request.cases.size(); ++row) {
    const StabilityCase* of = request.cases[row];
    if (of->takers == Takers::alone) {
      cells.push_back(judged(*of, every_mode, done[0].survived[row].at(0)));
      continue;
    }
    for (size_t mode = 0; mode < request.modes.size(); ++mode) {
      Survival survived;
      if (of->takers == Takers::by_mode)
        survived = done[mode % done.size()].survived[row].at(mode / done.size());
      else
        for (const Done& one : done)
          worsen(survived, one.survived[row].at(mode).figure, one.survived[row][mode].where);
      cells.push_back(judged(*of, request.modes[mode].name, survived));
    }
  }
  return cells;
}

StabilityTable table_of(const StabilityRequest& request, const std::vector<Done>& done) {
  constexpr const char* endurances[] = {"brief", "usual", "long"};
  StabilityTable table{.version = UNGHOST_VERSION,
                       .device = done[0].device.name,
                       .driver = done[0].device.driver,
                       .endurance = endurances[size_t(request.endurance)],
                       .seed = request.seed,
                       .columns = {},
                       .cells = cells_of(request, done)};
  for (const StabilityCase* row : request.cases)
    table.columns.push_back({.name = std::string(row->name),
                             .summary = std::string(row->summary),
                             .unit = std::string(row->unit),
                             .bound = row->bound});
  return table;
}

} // namespace

StabilityCell judged(const StabilityCase& row, std::string mode, const Survival& survived) {
  StabilityCell cell{.mode = std::move(mode),
                     .column = std::string(row.name),
                     .value = {},
                     .worst = survived.where,
                     .excuse = {},
                     .pass = survived.figure <= row.bound};
  if (std::isfinite(survived.figure)) cell.value = survived.figure;
  const Excuse* excuse = cell.pass ? nullptr : excuse_for(cell.mode, row.name);
  if (excuse == nullptr || survived.figure > excuse->at_most) return cell;
  cell.excuse = excuse->why;
  cell.pass = true;
  return cell;
}

size_t stability_workers(const StabilityRequest& request) {
  const bool by_trial = !request.trial && std::ranges::find(request.cases, Takers::by_trial,
                                                            &StabilityCase::takers) != request.cases.end();
  const size_t cores = cores_of_this_process().size();
  return by_trial ? cores : std::clamp<size_t>(request.modes.size(), 1, cores);
}

StabilityResult run_stability(const StabilityRequest& request) {
  const std::vector<int> cores = cores_of_this_process();
  const size_t workers = stability_workers(request);
  std::mutex one_at_a_time;
  std::atomic<bool> stopped = false;
  std::vector<std::future<Done>> running; // each waits for its thread when it goes
  for (size_t worker = 0; worker < workers; ++worker)
    running.push_back(std::async(std::launch::async, run_or_stop,
                                 Work{request, worker, workers, one_at_a_time, stopped}, cores[worker]));
  std::vector<Done> done;
  for (std::future<Done>& one : running) done.push_back(one.get());
  StabilityResult result{.table = table_of(request, done), .validation_messages = {}};
  for (const Done& one : done)
    result.validation_messages.insert(result.validation_messages.end(), one.validation_messages.begin(),
                                      one.validation_messages.end());
  return result;
}

} // namespace unghost
