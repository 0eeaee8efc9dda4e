// SPDX-License-Identifier: MIT
// The fluid notes' input as a scene and as a study, in TOML that is meant to be read and changed.
#pragma once

#include "app/import/notes_json.h"
#include "sim/files/particle_rows.h"

#include <filesystem>
#include <string>

namespace flipbook::app {

/// Particles along an axis of a cell, by what most cells with particles hold.
[[nodiscard]] int particles_per_axis(const NotesJson& notes, const ParticleRows& rows);

/// The scene; `particles` is their file as the scene shall call it. With `preset` the notes' own algorithm on their
/// domain, else Flipbook's method on its inside: the outer layer of cells is solid there.
[[nodiscard]] std::string notes_scene(const NotesJson& notes, const std::string& particles, int per_axis, bool preset);

/// The schemes side by side; `scene` is the name or path of the scene as the study shall call it.
[[nodiscard]] std::string notes_study(const NotesJson& notes, const std::string& scene, bool preset);

} // namespace flipbook::app
