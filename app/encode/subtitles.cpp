// SPDX-License-Identifier: MIT
#include "app/encode/subtitles.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace flipbook::app {

namespace {

/// 00:01:02.500
std::string clock(double seconds) {
  const long long ms = std::llround(seconds * 1000);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%02lld:%02lld:%02lld.%03lld", ms / 3'600'000, ms / 60'000 % 60,
                ms / 1000 % 60, ms % 1000);
  return text.data();
}

std::string escaped(const std::string& line) {
  std::string text;
  for (const char c : line) {
    if (c == '<')
      text += "&lt;";
    else if (c == '>')
      text += "&gt;";
    else if (c == '&')
      text += "&amp;";
    else
      text += c == '\r' || c == '\n' || c == '\0' ? ' ' : c;
  }
  return text;
}

} // namespace

std::string to_vtt(std::span<const Cue> cues) {
  std::string text = "WEBVTT\n";
  for (const Cue& cue : cues) {
    text += "\n" + clock(cue.from) + " --> " + clock(cue.to) + "\n";
    for (const std::string& line : cue.lines)
      if (line.find_first_not_of(" \t\r\n") != std::string::npos) text += escaped(line) + "\n";
  }
  return text;
}

} // namespace flipbook::app
