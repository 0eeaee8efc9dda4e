#version 330 core
// SPDX-License-Identifier: MIT
// One triangle over everything; the scissor rectangle cuts out the area.

void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }
