// SPDX-License-Identifier: MIT
#include <viz/panels/app/lost_display.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <utility>

#include <X11/Xlib.h>
#include <fmt/format.h>

namespace lightcuts::viz {
namespace {

constexpr int bad_input = 3;

std::function<void()>& last_words_of_process() {
  static std::function<void()> words;
  return words;
}

int end_process(Display*) {
  std::fputs("lightcuts-viz: the connection to the screen is lost\n", stderr);
  try {
    last_words_of_process()();
  } catch (const std::exception& error) {
    fmt::print(stderr, "lightcuts-viz: {}\n", error.what());
  }
  std::_Exit(bad_input); // threads are at work: nothing may be destroyed
}

} // namespace

LostDisplayGuard::LostDisplayGuard(std::function<void()> last_words) {
  last_words_of_process() = std::move(last_words);
  XSetIOErrorHandler(end_process);
}

LostDisplayGuard::~LostDisplayGuard() { XSetIOErrorHandler(nullptr); }

} // namespace lightcuts::viz
