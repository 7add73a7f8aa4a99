// cylon view
#include "harness/cli/asked.h"
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/workers.h"

#include "harness/core/input_error.h"
#include "harness/process/interruption.h"
#include "harness/view/command.h"
#include "harness/view/frames.h"
#include "harness/view/host.h"
#include "harness/view/redirect.h"
#include "harness/view/server.h"

#include <fmt/format.h>
#include <spawn.h>

#include <cctype>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <system_error>

namespace cylon::cli {
namespace {

struct Options {
  std::string file, dt, integrator, record;
  std::vector<std::string> engines;
  Brought brought;
  int port = 0;
  bool no_open = false, paused = false;
  double speed = 1, seconds = 0;
};

// By the desktop's own choice, without waiting for it.  Command lines are for all to read, so that the browser is given a
// file that leads to the address.
void open_browser(const view::Redirect& redirect) {
  std::string program = "xdg-open", file = redirect.file().string();
  char* const argv[] = {program.data(), file.data(), nullptr};
  pid_t pid = 0;
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  posix_spawn_file_actions_addopen(&quiet, 1, "/dev/null", 1, 0);
  posix_spawn_file_actions_addopen(&quiet, 2, "/dev/null", 1, 0);
  if (posix_spawnp(&pid, program.c_str(), &quiet, nullptr, argv, environ) != 0)
    std::cerr << "no browser was opened: xdg-open is not installed\n";
  posix_spawn_file_actions_destroy(&quiet);
}

// Opens a browser where there is a desktop; the file must stay as long as the server.
std::unique_ptr<view::Redirect> shown_in_browser(const std::string& address) try {
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")) return nullptr;
  auto redirect = std::make_unique<view::Redirect>(address);
  open_browser(*redirect);
  return redirect;
} catch (const std::system_error& error) {  // no place for the file
  std::cerr << plain_line(fmt::format("no browser was opened: {}", error.what())) << '\n';
  return nullptr;
}

std::unique_ptr<view::Session> make_session(const Context& context, const Options& options) {
  scenario::Scenario scenario = scenario::read(find_scenario(context, options.file));
  view::SessionOptions settings;
  settings.rows = with_brought(context, options.brought);
  settings.playing = !options.paused;
  settings.speed = options.speed;
  settings.recording = options.record;
  std::vector<view::LaneSpec> lanes;
  const std::string dt = options.dt.empty() ? scenario.step_text : options.dt;
  for (const std::string& engine : options.engines) lanes.push_back({engine, options.integrator, dt});
  if (lanes.size() > view::most_lanes)
    throw core::InputError(fmt::format("--engine: at most {} run side by side", view::most_lanes));
  settings.lane = lanes.front();
  try {
    auto session = std::make_unique<view::Session>(std::move(scenario), std::move(settings));
    if (lanes.size() > 1) session->apply(view::Lanes{lanes});
    return session;
  } catch (const view::BadCommand& error) {
    throw core::InputError(error.what());
  }
}

// What makes a film of the frames; the page sends 30 for a simulated second.
std::string film(const std::filesystem::path& frames) {
  const std::string folder = (frames / "").parent_path().string();  // without a slash at its end
  return fmt::format("ffmpeg -framerate 30 -i {} -pix_fmt yuv420p {}", shell_word(folder + "/frame-%06d.png"),
                     shell_word(folder + ".mp4"));
}

void say(const std::string& line) { std::cout << plain_line(line) << std::endl; }

int view_scenario(const Context& context, const Options& options) {
  using Clock = std::chrono::steady_clock;
  std::string name = options.record;
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const bool file = name.ends_with(".toml");
  if (file) require_writable(options.record);
  auto session = make_session(context, options);
  const process::Interruptible until_told;
  std::unique_ptr<view::Frames> frames;
  if (!options.record.empty() && !file) frames = std::make_unique<view::Frames>(options.record);
  view::Host host(std::move(session), file ? options.record : "", say);
  view::Server server(host, frames.get(), options.port);
  host.ask_engines();
  say(server.address());
  for (const std::string& line : host.failures()) std::cerr << plain_line(line) << '\n';
  std::unique_ptr<view::Redirect> redirect;
  if (!options.no_open) redirect = shown_in_browser(server.address());
  const Clock::time_point start = Clock::now();
  const auto over = [&] {
    return options.seconds > 0 &&
           std::chrono::duration<double>(Clock::now() - start).count() >= options.seconds;
  };
  while (!process::interrupted() && !over()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  process::interrupted() = true;  // what the engines are at is not waited for
  host.stop();
  server.stop();
  if (frames && frames->count() > 0) say(film(frames->folder()));
  return ok;
}

}  // namespace

Command add_view(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option("file", options->file, "A scenario file, or the name of a shipped scenario")
      ->type_name("FILE")
      ->required();
  app.add_option("--engine", options->engines, "Engines to run side by side. Default: in-house")
      ->type_name("ID")
      ->allow_extra_args(false);
  app.add_option("--integrator", options->integrator,
                 "One of the engine's integrators (`cylon engines` lists them)")
      ->type_name("NAME");
  add_step_option(app, options->dt);
  app.add_option("--port", options->port, "Port on 127.0.0.1; 0: any free port")
      ->type_name("N")
      ->check(in_range(0, 65535));
  app.add_flag("--no-open", options->no_open, "Do not open the browser");
  app.add_flag("--paused", options->paused, "Start paused");
  app.add_option("--speed", options->speed, "Simulated seconds per second")
      ->type_name("X")
      ->capture_default_str()
      ->check(in_range(0.01, 100.0));
  app.add_option("--record", options->record,
                 "FILE.toml: save the session as a scenario with its recorded motion, on reset and at the "
                 "end. FOLDER: save the frames that the page sends")
      ->type_name("FILE.toml|FOLDER");
  app.add_option("--for", options->seconds, "Stop after S seconds")->type_name("S")->check(positive(1e9));
  add_brought_options(app, options->brought);
  app.footer(
      "Ctrl-C stops the viewer (exit code 0).  It is served on 127.0.0.1 only, and only for a page that was "
      "opened by "
      "the printed address: that holds a secret which is new at each start.");
  return [=, &context] {
    if (options->engines.empty()) options->engines = {"in-house"};
    return view_scenario(context, *options);
  };
}

}  // namespace cylon::cli
