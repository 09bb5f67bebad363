#include "memory_run.hpp"

#include "talus/archive/summary_json.hpp"
#include "talus/core/memory_reserve.hpp"
#include "talus/lines/reopened_run.hpp"
#include "talus/lines/stored_paths.hpp"
#include "talus/maps/map_files.hpp"
#include "talus/run/save_results.hpp"
#include "temporary_folder.hpp"

namespace talus::python {

namespace {

/// Heights above the ground have no common reference if every rock has a section of its own.
bool has_heights(const Site& site) { return !site.model.varying; }

}  // namespace

MemoryRun::MemoryRun(std::shared_ptr<const Site> site)
    : site_(std::move(site)),
      description_(project::plan_of(site_->project, site_->model)),
      sums_(description_, site_->project, site_->model),
      keepers_(Keepers::make(site_->model, project::table_rocks(site_->project, site_->model.rocks()))) {
  sums_.limit_maps_memory(0);
}

void MemoryRun::simulate(int threads, const std::atomic<bool>& stop, std::atomic<std::uint64_t>& done) {
  std::vector<Observer*> observers;
  std::apply([&](auto&... keeper) { ((keeper.is_wanted() ? observers.push_back(&keeper) : void()), ...); }, keepers_);
  for (SummingObserver* observer : sums_.observers()) observers.push_back(observer);
  CampaignOptions options{.threads = threads, .stop = &stop};
  options.progress = [&](std::uint64_t count) {
    done.store(count, std::memory_order_relaxed);
    if (const auto lacking = sums_.lacking_memory()) throw OutOfMemory(*lacking);
    if (memory_is_short()) throw OutOfMemory("not enough memory for this run; save it to a folder with the program");
  };
  const CampaignOutcome outcome = run_campaign(site_->model, observers, options);
  course_ = {.range = {0, site_->model.rocks()},
             .interrupted = outcome.interrupted,
             .seconds = outcome.seconds,
             .threads = outcome.threads};
  done_ = outcome.done;
}

void MemoryRun::identify() {
  if (is_identified_) return;
  project::identify(description_, site_->project, site_->model, site_->warnings);
  description_.inputs = site_->inputs;
  is_identified_ = true;
}

EnvelopeTable MemoryRun::envelopes() {
  const std::lock_guard lock(mutex_);
  if (sums_.maps() == nullptr || !description_.wants_envelopes) return {};
  return envelopes_of({sums_.maps()->maps(), sums_.maps()->by_ensemble()}, description_.maps->selection,
                      has_heights(*site_));
}

std::vector<MapKind> MemoryRun::map_kinds() const {
  if (!description_.wants_maps || !description_.maps || done_ == 0) return {};
  return talus::map_kinds(description_.maps->selection);
}

std::optional<MapArray> MemoryRun::map(std::string_view name) {
  const std::lock_guard lock(mutex_);
  if (sums_.maps() == nullptr || !description_.wants_maps) return std::nullopt;
  return map_array({sums_.maps()->maps(), sums_.maps()->by_ensemble()}, description_.maps->selection, name);
}

std::string MemoryRun::summary_text() {
  struct Sink : TextSink {
    std::string text;
    void write(std::string_view piece) override { text += piece; }
  } sink;
  const std::lock_guard lock(mutex_);
  identify();
  const project::Findings findings = project::findings_of(description_, sums_, course_);
  project::write_summary(sink, description_, findings.warnings, findings.design, sums_, course_);
  return std::move(sink.text);
}

const AskedRun& MemoryRun::asked() {
  const std::lock_guard lock(mutex_);
  if (asked_) return *asked_;
  if (sums_.store() == nullptr) {
    Problem problem = no_trajectories({});
    problem.hint = "Run it again with output={\"trajectories\": \"all\"}";
    throw BadInput(std::move(problem));
  }
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / trajectories_name;
  sums_.store()->write(file, done_);
  // The store keeps its file open; its name is not needed any more.
  asked_ = std::make_unique<AskedRun>(site_->model, std::make_unique<StoredPaths>(file), ways_of(sums_.summary()));
  return *asked_;
}

void MemoryRun::save(const std::filesystem::path& folder) {
  const std::lock_guard lock(mutex_);
  identify();
  project::save_results(folder, site_->project, site_->model, description_, sums_, course_, [&](TableFiles& tables) {
    std::size_t place = 0;
    const std::size_t count = tables.observers().size();
    const auto append = [&](const auto& keeper) {
      if (!keeper.is_wanted()) return;
      keeper.for_texts(course_.threads, [&](const std::string& text) {
        std::vector<std::string> texts(count);
        texts[place] = text;
        tables.append(texts);
      });
      ++place;
    };
    std::apply([&](const auto&... keeper) { (append(keeper), ...); }, keepers_);
  });
}

}  // namespace talus::python
