// SPDX-License-Identifier: MIT
#include <viz/model/workbench.h>

#include <exception>
#include <utility>

#include <fmt/format.h>

#include <lightcuts/core/jobs/seconds_since.h>

namespace lightcuts::viz {
namespace {

/// Points on the curve of a refinement: one per millisecond or so.
constexpr std::size_t curve_points = 64;

/// The reference has no cut: that of lightcuts is looked at, by the chosen settings.
Method inspected_method(const DisplayMethod& display) {
  return display.method() == methods::reference ? methods::lightcuts : display.method();
}

} // namespace

Workbench::Workbench() = default;
Workbench::~Workbench() = default;

void Workbench::open(const std::string& spec) {
  if (!scene_) asked_to_open_.reset(); // the same again may succeed
  state.open = {.spec = spec, .builder = state.open.builder};
  if (scene_ && scene_->counterexample()) {
    state.shading.threshold.reset();
    state.shading.max_cut = default_max_cut;
  }
  state.camera.reset();
  state.pixel.reset();
  state.node.reset();
  state.step.reset();
  state.image.fits = true;
}

void Workbench::update() {
  take_opened();
  take_inspection();
  take_report();
  ask_to_open();
  if (!scene_) return;
  keep_selection_valid();
  ask_for_pictures();
  ask_for_inspection();
}

bool Workbench::busy() const {
  const bool inspecting =
      asked_inspection_ &&
      (!inspection_ || !(inspection_->key == *asked_inspection_) || !inspection_->complete);
  return opener_.busy() || queue_.busy() || inspector_.busy() || inspecting || reporter_.busy() ||
         handover_->waits();
}

bool Workbench::Handover::waits() {
  const std::lock_guard lock(mutex);
  return scene || inspection || report || !open_failure.empty() || !report_failure.empty();
}

// ---- opening

void Workbench::ask_to_open() {
  if (state.open.spec.empty() || asked_to_open_ == state.open) return;
  if (scene_ && scene_->request() == state.open) {
    asked_to_open_ = state.open;
    opener_.cancel();
    return;
  }
  asked_to_open_ = state.open;
  opener_.start([request = state.open, handover = handover_](const Progress& progress) {
    std::shared_ptr<const OpenedScene> opened;
    std::string failure;
    try {
      opened = std::make_shared<const OpenedScene>(request, progress);
    } catch (const Cancelled&) {
      return;
    } catch (const std::exception& error) {
      failure = error.what();
    }
    const std::lock_guard lock(handover->mutex);
    if (progress.cancelled()) return;
    handover->scene = std::move(opened);
    handover->open_failure = std::move(failure);
  });
}

void Workbench::cancel_opening() {
  opener_.cancel();
  {
    const std::lock_guard lock(handover_->mutex);
    handover_->scene = nullptr; // it may have come meanwhile
  }
  state.open = scene_ ? scene_->request() : SceneRequest{.builder = state.open.builder};
  asked_to_open_ = state.open;
}

void Workbench::take_opened() {
  std::shared_ptr<const OpenedScene> opened;
  std::string failure;
  {
    const std::lock_guard lock(handover_->mutex);
    opened = std::exchange(handover_->scene, nullptr);
    failure = std::exchange(handover_->open_failure, {});
  }
  if (!failure.empty()) {
    say(failure, true);
    // Unless another one has been asked for since.
    if (scene_ && asked_to_open_ == state.open) asked_to_open_ = state.open = scene_->request();
  }
  if (opened) adopt(opened);
}

void Workbench::adopt(const std::shared_ptr<const OpenedScene>& scene) {
  const bool another = !scene_ || scene_->request().spec != scene->request().spec;
  queue_.clear();
  scene_ = scene;
  if (!another) return;
  for (const std::string& note : scene->scene().notes) say(scene->scene().name + ": " + note);
  if (const auto& c = scene->counterexample()) {
    if (!state.shading.threshold) state.shading.threshold = c->cut.threshold;
    if (state.shading.max_cut == default_max_cut) state.shading.max_cut = c->cut.max_size;
    if (!state.pixel) state.pixel = scene->scene().image_size / 2U;
    if (!state.node) state.node = c->node;
  }
}

void Workbench::keep_selection_valid() {
  const glm::uvec2 size = scene_->scene().image_size;
  if (state.pixel && (state.pixel->x >= size.x || state.pixel->y >= size.y)) {
    say(fmt::format("pixel {},{} is not in the image of {} x {}", state.pixel->x, state.pixel->y,
                    size.x, size.y));
    state.pixel.reset();
  }
  if (state.node && *state.node >= scene_->topology().size()) {
    say(fmt::format("there is no node {}: the tree has {}", *state.node,
                    scene_->topology().size()));
    state.node.reset();
  }
}

// ---- pictures

const Camera& Workbench::camera() const {
  return state.camera ? *state.camera : scene_->scene().camera;
}

FrameKey Workbench::key_of(Method method) const {
  FrameKey key{scene_, method, state.shading, camera()};
  // What does not matter to a method does not make another picture of it.
  if (method != methods::lightcuts) {
    key.settings.rules = {};
    key.settings.tree_use = TreeUse::automatic;
  }
  if (!method->draws) key.settings.seed = 1;
  if (method == methods::reference) key.settings = {};
  return key;
}

LayerSources Workbench::sources(const DisplayMethod& display, Layer layer) {
  LayerSources sources;
  sources.frame = queue_.frame(key_of(display.method()));
  if (layer.needs_reference()) sources.reference = queue_.frame(key_of(methods::reference));
  if (layer.needs_truth()) sources.truth = queue_.truth(key_of(display.method()));
  if (layer.needs_blocks()) sources.blocks = queue_.blocks(key_of(display.method()));
  return sources;
}

std::vector<std::shared_ptr<Picture>> Workbench::wanted_pictures() {
  std::vector<std::shared_ptr<Picture>> wanted;
  const auto want = [&](const DisplayMethod& display) {
    if (display.is_raster() && state.layer.is_image()) return;
    if (!state.layer.needs_truth() && !state.layer.needs_blocks())
      wanted.push_back(queue_.frame(key_of(display.method())));
    if (state.layer.needs_reference()) wanted.push_back(queue_.frame(key_of(methods::reference)));
    if (state.layer.needs_truth()) wanted.push_back(queue_.truth(key_of(display.method())));
    if (state.layer.needs_blocks()) wanted.push_back(queue_.blocks(key_of(display.method())));
  };
  if (wants_reference) want(methods::reference);
  want(state.display);
  if (state.split) want(state.compared);
  return wanted;
}

void Workbench::ask_for_pictures() {
  const auto wanted = holds_pictures ? std::vector<std::shared_ptr<Picture>>{} : wanted_pictures();
  tell_of_failures(wanted);
  queue_.want(wanted);
}

void Workbench::tell_of_failures(const std::vector<std::shared_ptr<Picture>>& pictures) {
  for (const auto& picture : pictures) {
    const std::string failure = picture->failure();
    if (failure.empty() || failure == told_failure_) continue;
    told_failure_ = failure;
    say(failure, true);
  }
}

// ---- the selected pixel

void Workbench::ask_for_inspection() {
  std::optional<InspectionKey> key;
  if (state.pixel && !holds_pictures)
    key = InspectionKey{key_of(inspected_method(state.display)), *state.pixel, state.step};
  if (key == asked_inspection_) return;
  asked_inspection_ = key;
  if (!key) {
    inspector_.cancel();
    if (!state.pixel) inspection_.reset();
    return;
  }
  const auto asked = Clock::now();
  inspector_.start([key = *key, asked, handover = handover_](const Progress& progress) {
    InspectionResult result{key, {}};
    const auto hand_over = [&] {
      const std::lock_guard lock(handover->mutex);
      if (!progress.cancelled())
        handover->inspection = std::make_shared<const InspectionResult>(result);
    };
    try {
      result.inspection = inspect(key);
      result.seconds = seconds_since(asked);
      hand_over();
      result.curve = refinement_curve(key, curve_points, progress);
      hand_over();
      if (!add_truth(key, result.inspection, progress)) return;
    } catch (const std::exception& error) {
      result.failure = error.what();
    }
    result.complete = true;
    hand_over();
  });
}

void Workbench::take_inspection() {
  const std::lock_guard lock(handover_->mutex);
  auto taken = std::exchange(handover_->inspection, nullptr);
  if (!taken || !asked_inspection_ || !(taken->key == *asked_inspection_)) return;
  if (!taken->failure.empty()) say(taken->failure, true);
  inspection_ = taken;
}

std::optional<ClusterRow> Workbench::row(std::uint32_t node) {
  if (!inspection_ || !inspection_->inspection.sees_surface) return std::nullopt;
  for (const ClusterRow& row : inspection_->inspection.clusters)
    if (row.node == node) return row;
  if (other_rows_of_ != inspection_.get()) {
    other_rows_.clear();
    other_rows_of_ = inspection_.get();
  }
  const auto known = other_rows_.find(node);
  if (known != other_rows_.end()) return known->second;
  std::optional<ClusterRow> row;
  try {
    row = row_of(inspection_->key, node);
  } catch (const std::exception& error) { // a foreign tree that does not answer
    say(error.what(), true);
  }
  other_rows_.emplace(node, row);
  return row;
}

// ---- the report

void Workbench::start_report(const oracle::MeasureConfig& config) {
  if (!scene_ || reporter_.busy()) return;
  reporter_.start([config = oracle::MeasureConfig(config), scene = scene_,
                   handover = handover_](const Progress& progress) mutable {
    config.progress = progress;
    std::optional<ReportResult> result;
    std::string failure;
    try {
      result = ReportResult{scene, oracle::measure(scene->view(), config).report};
    } catch (const Cancelled&) {
      return;
    } catch (const std::exception& error) {
      failure = error.what();
    }
    const std::lock_guard lock(handover->mutex);
    handover->report = std::move(result);
    handover->report_failure = std::move(failure);
  });
}

void Workbench::cancel_report() { reporter_.cancel(); }

void Workbench::take_report() {
  const std::lock_guard lock(handover_->mutex);
  if (handover_->report) report_ = std::exchange(handover_->report, std::nullopt);
  if (!handover_->report_failure.empty())
    say("report: " + std::exchange(handover_->report_failure, {}), true);
}

} // namespace lightcuts::viz
