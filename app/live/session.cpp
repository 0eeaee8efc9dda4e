// SPDX-License-Identifier: MIT
#include "app/live/session.h"

#include "app/commands/variants.h"
#include "app/live/desk.h"
#include "app/live/screen.h"
#include "app/live/told.h"
#include "app/session/failure.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <chrono>
#include <map>

namespace flipbook::app::live {
namespace {

using Clock = std::chrono::steady_clock;
using serve::Action;
using serve::ClientId;

constexpr auto look_around = std::chrono::milliseconds(100);  // for signals, when nothing wakes us
constexpr auto least_between = std::chrono::milliseconds(12); // pictures
constexpr auto state_every = std::chrono::milliseconds(100), parameters_every = std::chrono::milliseconds(250);
constexpr auto time_to_rest = std::chrono::milliseconds(150); // before a picture is drawn with all its detail
constexpr auto longest_farewell = std::chrono::seconds(20);

/// Wakes the thread that waits for it; what comes in between is not lost.
class Bell {
public:
  void ring() {
    const std::scoped_lock lock(mutex_);
    rung_ = true;
    heard_.notify_one();
  }
  void wait(Clock::duration most) {
    std::unique_lock lock(mutex_);
    heard_.wait_for(lock, most, [&] { return rung_; });
    rung_ = false;
  }

private:
  std::mutex mutex_;
  std::condition_variable heard_;
  bool rung_ = false;
};

class LiveSession {
public:
  explicit LiveSession(const LiveOptions& options)
      : options_(options), budget_(options.threads), pool_(budget_), context_(make_context(options.gl)),
        workers_([this](int chunks, const auto& body) { pool_.each(chunks, body); }),
        server_(options.server, [this] { bell_.ring(); }), simulator_(budget_, [this] { bell_.ring(); }),
        screen_(*context_, workers_, simulator_), desk_(options.folder, *context_, workers_, budget_, simulator_,
                                                        [this](const std::string& text) { server_.send_all(text); }) {}

  void run() {
    catch_signals();
    simulator_.open([study = options_.study] { return study; }, options_.kind);
    options_.listening(server_);
    while (signal_received() == 0) {
      bell_.wait(pause());
      for (serve::ClientEvent& e : server_.take_events()) handle(e);
      desk_.write_recorded();
      for (const Report& r : simulator_.take_reports()) handle(r);
      draw();
      tell();
    }
    farewell();
  }

private:
  static std::unique_ptr<render::Context> make_context(render::Backend gl) {
    render::set_draw_threads(1); // llvmpipe would start threads of its own, outside the budget
    return render::Context::create(gl);
  }

  // === Clients

  void handle(const serve::ClientEvent& e) {
    switch (e.what) {
    case serve::ClientEvent::What::joined: return joined(e.client);
    case serve::ClientEvent::What::left: return left(e.client);
    case serve::ClientEvent::What::said: break;
    }
    if (const auto* act = std::get_if<serve::DoMessage>(&e.message)) return handle(e.client, *act);
    if (e.client != driver_) return;
    std::visit([&](const auto& m) { drive(m); }, e.message);
  }

  void drive(const serve::AckMessage&) {} // the server's
  void drive(const serve::DoMessage&) {}  // handled before
  void drive(const serve::ViewMessage& m) {
    screen_.resize(m.width, m.height);
    screen_.show_panel(m.panel);
  }
  template <class Message> void drive(const Message& m) { screen_.take(m); }

  void joined(ClientId client) {
    clients_[client] = {};
    if (driver_ == 0) driver_ = client;
    server_.send(client, tell_hello(client, client == driver_, options_.folder));
    if (!last_state_.empty()) server_.send(client, last_state_);
    tell_roles();
    fresh_ = true;
  }

  void left(ClientId client) {
    clients_.erase(client);
    if (client == driver_) pass_on(clients_.empty() ? 0 : clients_.begin()->first);
    tell_roles();
  }

  void pass_on(ClientId to) {
    screen_.let_go();
    driver_ = to;
  }

  void tell_roles() {
    for (const auto& [id, client] : clients_) server_.send(id, tell_role(id == driver_, clients_.size()));
  }

  void handle(ClientId client, const serve::DoMessage& m) {
    if (m.action == Action::parameters) {
      clients_[client].parameters = m.on;
      clients_[client].told.clear();
      return;
    }
    if (m.action == Action::drive) {
      if (m.on) pass_on(client);
      if (!m.on && client == driver_ && clients_.size() > 1)
        pass_on(clients_.begin()->first == client ? std::next(clients_.begin())->first : clients_.begin()->first);
      return tell_roles();
    }
    if (client == driver_) act(m);
  }

  void act(const serve::DoMessage& m) {
    switch (m.action) {
    case Action::play: return simulator_.play(true);
    case Action::pause: return simulator_.play(false);
    case Action::step: return simulator_.step();
    case Action::reset: return simulator_.reset();
    case Action::record: return desk_.begin(m.kind);
    case Action::stop_record: return simulator_.record(false);
    case Action::snapshot: return simulator_.picture();
    case Action::save_study: return simulator_.save();
    case Action::open: return open(m.kind, m.name);
    case Action::link: return screen_.link(m.on);
    case Action::set: return set(m);
    case Action::drive:
    case Action::parameters: return;
    }
  }

  void set(const serve::DoMessage& m) {
    SetParameter change{m.path, *m.value};
    complete(change);
    screen_.edit(m.pane - 1, std::move(change));
  }

  /// Only what is in the lists: a name is never a path.
  void open(const std::string& kind, const std::string& name) {
    const std::vector<std::string> known = kind == "study" ? list_studies() : list_scenes();
    if (std::find(known.begin(), known.end(), name) == known.end())
      return say("error", "there is no " + kind + " \"" + name + "\"");
    if (kind == "study")
      simulator_.open([name] { return read_study(name); }, kind);
    else
      simulator_.open([name] { return study_of_scene(name); }, kind);
  }

  // === What is written

  void handle(const Report& r) {
    if (r.what == Report::What::message) return say(r.level, r.text);
    desk_.take(r);
  }

  void say(const std::string& level, const std::string& text) {
    if (level == "error") std::fprintf(stderr, "flipbook: %s\n", text.c_str());
    server_.send_all(tell_message(level, text));
  }

  /// All files become whole.
  void farewell() {
    simulator_.record(false);
    const auto end = Clock::now() + longest_farewell;
    while (desk_.recording() && Clock::now() < end) {
      bell_.wait(look_around);
      desk_.write_recorded();
      for (const Report& r : simulator_.take_reports()) handle(r);
    }
  }

  // === What is seen

  [[nodiscard]] Clock::duration pause() const {
    if (!wants_picture() || !server_.wanted()) return look_around;
    return std::clamp<Clock::duration>(drawn_ + least_between - Clock::now(), Clock::duration(0), look_around);
  }
  [[nodiscard]] bool wants_picture() const {
    return fresh_ || screen_.touched() || simulator_.newest() != shown_ || (screen_.could_be_finer() && still());
  }
  /// Nothing has moved for a while.
  [[nodiscard]] bool still() const { return Clock::now() > moved_ + time_to_rest; }

  void draw() {
    const auto frame = simulator_.newest();
    if (!frame || !wants_picture() || !server_.wanted() || Clock::now() < drawn_ + least_between) return;
    const double seconds = std::chrono::duration<double>(Clock::now() - drawn_).count();
    drawn_ = Clock::now();
    auto picture = std::make_shared<serve::ServedPicture>();
    picture->driver = driver_;
    picture->last_seq = screen_.last_seq();
    const LiveStatus status = simulator_.status();
    if (screen_.touched() || frame != shown_) moved_ = drawn_;
    {
      const Budget::Permit permit(budget_, true);
      picture->image = screen_.draw(*frame, status, seconds, !still());
    }
    picture->number = ++pictures_;
    picture->frame = frame->bundle.stop.frame;
    shown_ = frame;
    fresh_ = false;
    server_.publish(std::move(picture));
    draws_.push_back(Clock::now());
    if (draws_.size() > 30) draws_.pop_front();
  }

  [[nodiscard]] double drawing_rate() const {
    if (draws_.size() < 2 || Clock::now() - draws_.back() > std::chrono::seconds(1)) return 0;
    return static_cast<double>(draws_.size() - 1) /
           std::chrono::duration<double>(draws_.back() - draws_.front()).count();
  }

  void tell() {
    const auto now = Clock::now();
    if (clients_.empty() || now < told_ + state_every) return;
    ToldState state;
    state.status = simulator_.status();
    state.titles = screen_.titles();
    state.linked = screen_.linked();
    state.keyboard = screen_.wants_text();
    state.cursor = screen_.cursor();
    state.fps_drawn = drawing_rate();
    state.width = screen_.width();
    state.height = screen_.height();
    if (const Recording* r = desk_.recording()) {
      state.recording_kind = r->kind();
      state.recording_name = r->name();
      state.recording_frames = r->frames();
    }
    std::string text = tell_state(state);
    told_ = now;
    if (text != last_state_) server_.send_all(last_state_ = std::move(text));
    tell_all_parameters(state.status);
  }

  void tell_all_parameters(const LiveStatus& status) {
    const auto asks = [](const auto& c) { return c.second.parameters; };
    if (!status.parameters || std::none_of(clients_.begin(), clients_.end(), asks)) return;
    if (Clock::now() < parameters_told_ + parameters_every) return;
    parameters_told_ = Clock::now();
    render::ViewSettings view = screen_.view();
    const std::string text = tell_parameters(screen_.titles(), *status.parameters, parameters_of(view));
    for (auto& [id, client] : clients_)
      if (client.parameters && client.told != text) server_.send(id, client.told = text);
  }

  /// Cells are cubic: who changes those along x means the others, too.
  void complete(SetParameter& change) const {
    const LiveStatus status = simulator_.status();
    if (!status.take || change.path != "grid.cells" || !std::holds_alternative<double>(change.value)) return;
    Assignment a{change.path, change.value, {}};
    try {
      complete_cells(a, status.take->study);
      change.value = a.value;
    } catch (const UserError&) { // the restart says what is wrong
    }
  }

  struct Client {
    bool parameters = false; ///< wants them
    std::string told;
  };

  const LiveOptions& options_;
  Bell bell_;
  Budget budget_;
  Pool pool_;
  std::unique_ptr<render::Context> context_;
  render::Workers workers_;
  serve::Server server_;
  Simulator simulator_;
  LiveScreen screen_;
  Desk desk_;

  std::map<ClientId, Client> clients_; ///< the longest connected first
  ClientId driver_ = 0;
  std::shared_ptr<const LiveFrame> shown_;
  bool fresh_ = true; ///< somebody new wants a picture
  std::uint32_t pictures_ = 0;
  Clock::time_point drawn_{}, moved_{}, told_{}, parameters_told_{};
  std::deque<Clock::time_point> draws_;
  std::string last_state_;
};

} // namespace

void run_live_session(const LiveOptions& options) {
  LiveSession(options).run();
}

} // namespace flipbook::app::live
