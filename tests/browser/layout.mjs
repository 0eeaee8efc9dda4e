// SPDX-License-Identifier: MIT
// Measures of how the page is laid out.

/// Pairs of controls, or of a control and the picture, of which one covers a part of the other.
export const overlaps = (tab) =>
  tab.evaluate(`(() => {
  const seen = [...document.querySelectorAll('.bar button, .bar select, .bar label, .clock, .connection, .role, .numbers, #stage')].filter((e) => e.checkVisibility());
  const boxes = seen.map((e) => ({ name: e.id || e.className || e.textContent.trim(), box: e.getBoundingClientRect(), e })).filter(({ box }) => box.width > 0);
  const covers = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1;
  return boxes.flatMap((a, i) => boxes.slice(i + 1).filter((b) => !a.e.contains(b.e) && !b.e.contains(a.e) && covers(a.box, b.box)).map((b) => a.name + ' | ' + b.name));
})()`);

/// Every text of an enabled part of the page, with the contrast to its background as WCAG 2 defines it.
export const contrasts = (tab) =>
  tab.evaluate(`(() => {
  const canvas = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
  const rgb = (colour) => { canvas.clearRect(0, 0, 1, 1); canvas.fillStyle = colour; canvas.fillRect(0, 0, 1, 1); return [...canvas.getImageData(0, 0, 1, 1).data]; };
  const channel = (c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4);
  const luminance = ([r, g, b]) => 0.2126 * channel(r) + 0.7152 * channel(g) + 0.0722 * channel(b);
  const behind = (e) => { for (; e; e = e.parentElement) { const c = rgb(getComputedStyle(e).backgroundColor); if (c[3] === 255) return c; } };
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), found = [];
  while (walker.nextNode()) {
    const text = walker.currentNode.textContent.trim(), e = walker.currentNode.parentElement;
    if (!text || !e.checkVisibility() || e.closest(':disabled, .unseen, svg, video, script, noscript, fieldset:disabled')) continue;
    const [a, b] = [luminance(rgb(getComputedStyle(e).color)), luminance(behind(e))];
    found.push({ text, ratio: (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05) });
  }
  return found;
})()`);
