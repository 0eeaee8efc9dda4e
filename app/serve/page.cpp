// SPDX-License-Identifier: MIT
#include "app/serve/page.h"

namespace flipbook::app::serve {

std::string_view PageFile::type() const {
  if (name.ends_with(".html")) return "text/html; charset=utf-8";
  if (name.ends_with(".css")) return "text/css; charset=utf-8";
  if (name.ends_with(".js")) return "text/javascript; charset=utf-8";
  if (name.ends_with(".svg")) return "image/svg+xml";
  return "application/octet-stream";
}

const PageFile* page_file(std::string_view path) {
  const std::string_view name = path == "/" ? "index.html" : path.substr(path.starts_with('/') ? 1 : 0);
  for (const PageFile& f : page_files())
    if (f.name == name) return &f;
  return nullptr;
}

} // namespace flipbook::app::serve
