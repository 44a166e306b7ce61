// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <oracle/report/measure.h>

#include <viz/model/cut/inspection.h>
#include <viz/model/jobs/worker.h>
#include <viz/model/layers/layer_values.h>
#include <viz/model/picture/picture_queue.h>
#include <viz/model/state/view_state.h>

namespace lightcuts::viz {

/// A line for the person at the window.
struct Message {
  std::string text;
  bool error = false;
};

/// An inspection as far as it has come.
struct InspectionResult {
  InspectionKey key;
  Inspection inspection;
  RefinementCurve curve; ///< empty until it is there
  bool complete = false; ///< with what is true of each cluster, or failed
  std::string failure;   ///< why it ended, or nothing
  double seconds = 0;    ///< from asking until the cut was there
};

/// A report of the oracle on the scene that is open.
struct ReportResult {
  std::shared_ptr<const OpenedScene> scene;
  oracle::Report report;
};

/// All that the window shows, without the window: a person's choices, and the pictures and numbers
/// that threads make of them. All functions are for one thread; none waits for a job.
class Workbench {
public:
  Workbench();
  ~Workbench();
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;

  /// A person's choices, to be changed at will; update() acts on them.
  ViewState state;

  /// To be called once per frame of the window: takes what threads have made, and starts what the
  /// state asks for. Where the scene that is asked for cannot be opened there is a message, and the
  /// last good one stays.
  void update();
  /// Opens another scene, by the same builder, with the selection forgotten, and so the threshold
  /// and largest cut of a counterexample.
  void open(const std::string& spec);
  /// Whether any job runs or is about to.
  [[nodiscard]] bool busy() const;

  /// Null until the first one is open.
  [[nodiscard]] const std::shared_ptr<const OpenedScene>& scene() const { return scene_; }
  [[nodiscard]] bool opening() const { return opener_.busy(); }
  /// The open scene stays, if there is one.
  void cancel_opening();
  [[nodiscard]] const std::vector<Message>& messages() const { return messages_; }
  void say(std::string text, bool error = false) { messages_.push_back({std::move(text), error}); }
  void clear_messages() { messages_.clear(); }

  /// The pictures from which a layer of a display is made; of the raster preview those of
  /// lightcuts. Nothing of them is made unless the state shows it. Only with a scene.
  [[nodiscard]] LayerSources sources(const DisplayMethod& display, Layer layer);
  /// The camera of the picture; only with a scene.
  [[nodiscard]] const Camera& camera() const;
  /// The picture that is being made, or null.
  [[nodiscard]] std::shared_ptr<Picture> current_picture() const { return queue_.current(); }
  /// While set, as while a key is held: the reference is wanted, too.
  bool wants_reference = false;
  /// While set, as while the camera moves: nothing is rendered.
  bool holds_pictures = false;

  /// The inspection of the selected pixel; null where none is selected, and until it is there. It
  /// may be of an earlier key.
  [[nodiscard]] const std::shared_ptr<const InspectionResult>& inspection() const {
    return inspection_;
  }
  /// A cluster as seen from the selected pixel, in the cut or not; nothing without a pixel.
  [[nodiscard]] std::optional<ClusterRow> row(std::uint32_t node);
  /// The selected cluster as seen from the selected pixel; nothing where either is missing.
  [[nodiscard]] std::optional<ClusterRow> selected_row() {
    return state.node ? row(*state.node) : std::nullopt;
  }

  /// Runs the oracle's report on the open scene; at most one at a time.
  void start_report(const oracle::MeasureConfig& config);
  void cancel_report();
  [[nodiscard]] bool reporting() const { return reporter_.busy(); }
  [[nodiscard]] double report_share() const { return reporter_.share(); }
  [[nodiscard]] const std::optional<ReportResult>& report() const { return report_; }

private:
  void take_opened();
  void take_inspection();
  void take_report();
  void ask_to_open();
  void ask_for_pictures();
  void ask_for_inspection();
  void adopt(const std::shared_ptr<const OpenedScene>& scene);
  void keep_selection_valid();
  void tell_of_failures(const std::vector<std::shared_ptr<Picture>>& pictures);
  [[nodiscard]] FrameKey key_of(Method method) const;
  [[nodiscard]] std::vector<std::shared_ptr<Picture>> wanted_pictures();

  std::shared_ptr<const OpenedScene> scene_;
  std::optional<SceneRequest> asked_to_open_;
  std::vector<Message> messages_;
  std::string told_failure_; ///< of a picture, the last one

  /// Results on their way from threads to update().
  struct Handover {
    std::mutex mutex;
    std::shared_ptr<const OpenedScene> scene;
    std::string open_failure;
    std::shared_ptr<const InspectionResult> inspection;
    std::optional<ReportResult> report;
    std::string report_failure;

    /// Whether update() has not taken all of it yet.
    [[nodiscard]] bool waits();
  };
  std::shared_ptr<Handover> handover_ = std::make_shared<Handover>();

  std::shared_ptr<const InspectionResult> inspection_;
  std::optional<InspectionKey> asked_inspection_;
  /// Clusters beside the cut that were asked for, of the inspection's key.
  std::unordered_map<std::uint32_t, std::optional<ClusterRow>> other_rows_;
  const InspectionResult* other_rows_of_ = nullptr;
  std::optional<ReportResult> report_;

  PictureQueue queue_;
  Worker opener_{Niceness::background};
  Worker inspector_{Niceness::prompt};
  Worker reporter_{Niceness::background};
};

} // namespace lightcuts::viz
