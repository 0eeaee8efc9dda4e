// SPDX-License-Identifier: MIT
#include "render/theme.h"

namespace flipbook::render {
namespace {

// The variants begin with the colours of Okabe and Ito's set for colour-blind readers, lightened for the dark theme and
// darkened for the light one until each stands out from its background; from the seventh on curves are dashed as well.
constexpr Palette dark{
    .page = Colour::hex(0x0f1216),
    .pane = Colour::hex(0x161a20),
    .text = Colour::hex(0xe9ecef),
    .muted = Colour::hex(0x9aa4af),
    .line = Colour::hex(0x2c333c),
    .grid = Colour::hex(0x262d36),
    .wall = Colour::hex(0x39424d),
    .track = Colour::hex(0x2a313a),
    .accent = Colour::hex(0x7d8996),
    .grip = Colour::hex(0xe9ecef),
    .floor = Colour::hex(0x2a313a),
    .floor_grid = Colour::hex(0x38414c),
    .far_wall = Colour::hex(0x1b2027),
    .far_edge = Colour::hex(0x4a5563),
    .near_edge = Colour::hex(0x9aa4af).alpha(0.45),
    .shadow = Colour::hex(0x05070a).alpha(0.75),
    .water = Colour::hex(0x1f7fbf),
    .drop = Colour::hex(0xb9dcf2),
    .horizon = Colour::hex(0x8fb4cc),
    .zenith = Colour::hex(0xdcecf7),
    .solid = Colour::hex(0x8d97a3),
    .outline = Colour::hex(0x6b7682),
    .liquid = Colour::hex(0x2a78bd),
    .liquid_edge = Colour::hex(0x9fd0f7),
    .cell_liquid = Colour::hex(0x3f9be8).alpha(0.35),
    .cell_air = Colour::hex(0xffffff).alpha(0.07),
    .cell_solid = Colour::hex(0xd08c54).alpha(0.5),
    .arrow = Colour::hex(0xf4f6f8),
    .warning = Colour::hex(0xf2b33d),
    .holds = Colour::hex(0x5fbf8a),
    .fails = Colour::hex(0xff6f61),
    .variants = {Colour::hex(0x56b4e9), Colour::hex(0xe69f00), Colour::hex(0x44ab74), Colour::hex(0xe96ab8),
                 Colour::hex(0xd2e549), Colour::hex(0xe7551b), Colour::hex(0x8f9cf5), Colour::hex(0xb8c0c8),
                 Colour::hex(0xb5e07a), Colour::hex(0xc79a6b), Colour::hex(0x7fe0d6), Colour::hex(0xf3b6a8)},
};

constexpr Palette light{
    .page = Colour::hex(0xffffff),
    .pane = Colour::hex(0xf6f7f9),
    .text = Colour::hex(0x1a1f25),
    .muted = Colour::hex(0x5b6671),
    .line = Colour::hex(0xd9dee3),
    .grid = Colour::hex(0xdfe3e8),
    .wall = Colour::hex(0xc3cad2),
    .track = Colour::hex(0xe0e4e9),
    .accent = Colour::hex(0x8a95a1),
    .grip = Colour::hex(0x3a434d),
    .floor = Colour::hex(0xe3e7ec),
    .floor_grid = Colour::hex(0xcfd5dc),
    .far_wall = Colour::hex(0xeff1f4),
    .far_edge = Colour::hex(0xaab3bd),
    .near_edge = Colour::hex(0x5b6671).alpha(0.45),
    .shadow = Colour::hex(0x1a2733).alpha(0.45),
    .water = Colour::hex(0x2f8fca),
    .drop = Colour::hex(0x7fb9de),
    .horizon = Colour::hex(0x8cb4cf),
    .zenith = Colour::hex(0xffffff),
    .solid = Colour::hex(0xa3adb8),
    .outline = Colour::hex(0x8a95a1),
    .liquid = Colour::hex(0x8fc4ec),
    .liquid_edge = Colour::hex(0x17609f),
    .cell_liquid = Colour::hex(0x2b86d1).alpha(0.30),
    .cell_air = Colour::hex(0x000000).alpha(0.06),
    .cell_solid = Colour::hex(0x8a5a2b).alpha(0.40),
    .arrow = Colour::hex(0x11151a),
    .warning = Colour::hex(0xa86200),
    .holds = Colour::hex(0x1e8a4f),
    .fails = Colour::hex(0xc62f23),
    .variants = {Colour::hex(0x0072b2), Colour::hex(0xd98200), Colour::hex(0x009761), Colour::hex(0xbe6c95),
                 Colour::hex(0x937903), Colour::hex(0xab483a), Colour::hex(0x4a52c4), Colour::hex(0x5f6871),
                 Colour::hex(0x5c8f1f), Colour::hex(0x8a5a2b), Colour::hex(0x12949a), Colour::hex(0xd0706a)},
};

} // namespace

const Palette& palette(Theme theme) {
  return theme == Theme::dark ? dark : light;
}

} // namespace flipbook::render
