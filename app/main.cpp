// SPDX-License-Identifier: MIT
// The program: a table of commands, and the one place where failures become exit codes.
#include "app/commands/command.h"
#include "app/commands/complete.h"
#include "app/encode/provenance.h"
#include "app/session/failure.h"
#include "sim/core/instruction_set.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <system_error>
#include <vector>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace flipbook::app {

namespace {

const std::array table = std::to_array<CommandEntry>({
    {"render", "Make a video (or frames) of a study or a scene",
     "Examples:\n  flipbook render dam_break\n  flipbook render my_study.toml -o film.mp4 -o frames/", make_render},
    {"compare", "The same scene with several schemes or parameter values, side by side",
     "Examples:\n  flipbook compare dam_break\n  flipbook compare taylor_green --schemes pic,flip:0.95,apic --set "
     "view.colour=vorticity\n  flipbook compare dam_break --vary transfer.flip_ratio=0,0.5,0.95,1\n"
     "  flipbook compare dam_break --rows transfer.flip_ratio=0,0.5,0.95,1 --cols transfer.kernel=linear,quadratic",
     make_compare},
    {"still", "Single pictures at given times, or a filmstrip for print",
     "Examples:\n  flipbook still drop --at 0.2,0.4,0.6\n"
     "  flipbook still dam_break --rows schemes=pic,flip:0.97,apic --cols t=0.4,0.8,1.6 --width 174mm -o dam.pdf",
     make_still},
    {"stages", "One step of a run, stage by stage: P2G, forces, pressure, G2P, ...",
     "Examples:\n  flipbook stages dam_break --at 0.4 -o stages.png\n"
     "  flipbook stages drop --at 0.3 --schemes pic,apic -o stages.mp4 -o pages/",
     make_stages},
    {"serve", "Run a study or a scene live, in a browser",
     "Examples:\n  flipbook serve dam_break\n  flipbook serve my_study.toml --port 8080 -o recordings\n"
     "  ssh -L 8080:localhost:8080 cluster flipbook serve dam_break --port 8080",
     make_serve},
    {"figure", "Draw teaching figures as PNG, SVG and PDF, with their data",
     "Examples:\n  flipbook figure --list\n  flipbook figure propositions --width 84mm\n"
     "  flipbook figure --all --contact-sheet figures.png",
     make_figure},
    {"gallery", "Make a page of videos, figures and sliders that opens from a disk",
     "Examples:\n  flipbook gallery out/gallery dam_break taylor_green --figures kernels\n"
     "  flipbook gallery out/gallery --scrub dam_break:transfer.flip_ratio=0,0.5,0.9,1\n"
     "  flipbook gallery out/gallery --from lecture.toml --inline",
     make_gallery},
    {"verify", "Check the conservation properties of the transfers, one row for each",
     "Examples:\n  flipbook verify\n  flipbook verify --only angular --json", make_verify},
    {"validate", "Run flows with a known solution, and write a table, CSV files and a figure of each",
     "Examples:\n  flipbook validate taylor_green\n  flipbook validate dam_break --schemes flip:0.99,apic --cells "
     "96,192\n"
     "  flipbook validate --all -o out/validate",
     make_validate},
    {"bench", "Measure how fast it is: named workloads, phase by phase",
     "Examples:\n  flipbook bench W2\n  flipbook bench W3-64 --schemes apic --scaling --csv run.csv\n"
     "  flipbook bench --compare before.csv after.csv",
     make_bench},
    {"new", "Write a scene, a study or a scheme to start from",
     "Examples:\n  flipbook new scene splash\n  flipbook new study splash_study --scene splash.toml\n"
     "  flipbook new scheme mine",
     make_new},
    {"import", "Turn the input of the fluid notes' program into a scene",
     "Examples:\n  flipbook import fluid.json\n  flipbook import fluid.json --preset tutorial --study", make_import},
    {"list", "List every name: scenes, schemes, shapes, parameters, ...",
     "Examples:\n  flipbook list scenes\n  flipbook list parameters", make_list},
    {"info", "Show what a picture says about itself",
     "Examples:\n  flipbook info frame_000012.png\n  flipbook info frame_000012.png --study -o study.toml", make_info},
    {"completion", "Print a script that completes command lines in a shell",
     "Examples:\n  source <(flipbook completion bash)", make_completion},
    {"man", "Print the manual page", "Examples:\n  flipbook man | man -l -", make_man},
});

void print_help(std::ostream& out) {
  out << program_summary << ".\n\nUsage: flipbook COMMAND [OPTIONS]\n\nCommands:\n";
  std::size_t width = 0;
  for (const CommandEntry& c : table) width = std::max(width, c.name.size());
  for (const CommandEntry& c : table)
    out << "  " << c.name << std::string(width + 2 - c.name.size(), ' ') << c.summary << '\n';
  out << "\nOptions:\n  -h,--help   This text; flipbook COMMAND --help tells more\n"
         "  --version   Version and instruction set in use\n\nStart with: flipbook compare dam_break\n";
}

int run(std::vector<std::string> arguments) {
  if (arguments.empty() || arguments[0] == "--help" || arguments[0] == "-h" || arguments[0] == "help") {
    print_help(arguments.empty() ? std::cerr : std::cout);
    return arguments.empty() ? 2 : 0;
  }
  if (arguments[0] == "complete") { // not for people: the scripts of `flipbook completion` ask
    print_offer(std::cout, complete({arguments.begin() + 1, arguments.end()}));
    return 0;
  }
  if (std::find(arguments.begin(), arguments.end(), "--version") != arguments.end()) {
    std::cout << "flipbook " << version() << " (" << instruction_set() << ")\n";
    return 0;
  }
  const std::string name = arguments[0];
  arguments.erase(arguments.begin());
  std::vector<std::string> names{"--help", "--version"};
  for (const CommandEntry& c : table) {
    names.push_back(c.name);
    if (c.name != name) continue;
    const auto command = c.make();
    return parse_arguments(c, *command, std::move(arguments)) ? command->run() : 0;
  }
  throw UserError((name.starts_with("-") ? "unknown option " : "unknown command ") + ("\"" + name + "\""), {},
                  nearest_name(name, names));
}

/// A result that did not arrive is no result.
void flush_output() {
  errno = 0;
  std::cout.flush();
  const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
  if (!written)
    throw MachineError("cannot write to standard output" +
                       (errno == 0 ? std::string() : ": " + std::generic_category().message(errno)));
}

/// Prints what went wrong in one line and says which exit code that is.
int explain(const std::exception_ptr& failure) {
  const auto say = [](const char* what) { std::cerr << "flipbook: " << what << '\n'; };
  try {
    std::rethrow_exception(failure);
  } catch (const UserError& e) {
    return say(e.what()), 2;
  } catch (const MachineError& e) {
    return say(e.what()), 3;
  } catch (const NonFiniteError& e) {
    return say(e.what()), 4;
  } catch (const Interrupted& e) { // everything is tidied up: end as the signal would have ended us
    std::signal(e.signal, SIG_DFL);
    return std::raise(e.signal);
  } catch (const std::bad_alloc&) {
    return say("out of memory"), 3;
  } catch (const std::exception& e) {
    return say(e.what()), 3;
  }
}

/// Steps and pictures free what the next one allocates again, much of it large. glibc gives large pieces back to the
/// system at once, and every page that comes back costs a fault and is cleared: more than half of the time of encoding
/// a picture. So freed memory is kept.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int largest_threshold = 32 << 20; // that glibc takes
  mallopt(M_MMAP_THRESHOLD, largest_threshold);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

} // namespace

std::span<const CommandEntry> commands() {
  return table;
}

} // namespace flipbook::app

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN); // a closed pipe or a file size limit shows as a failed write, with a message
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    flipbook::app::keep_freed_memory();
    const int code = flipbook::app::run({argv + 1, argv + argc});
    flipbook::app::flush_output();
    return code;
  } catch (...) {
    return flipbook::app::explain(std::current_exception());
  }
}
