// SPDX-License-Identifier: BSD-3-Clause
// A colour map for magnitudes: from dark blue over green to light yellow, with the lightness of OKLab growing
// evenly, so that equal steps look equal, in grey too. OKLab: Björn Ottosson, 2020.

function srgb(linear) {
  const x = Math.min(1, Math.max(0, linear));
  return x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055;
}

/** OKLCh to sRGB in [0, 1]; hue in degrees. */
function fromOklch(lightness, chroma, hue) {
  const a = chroma * Math.cos((hue * Math.PI) / 180);
  const b = chroma * Math.sin((hue * Math.PI) / 180);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    srgb(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    srgb(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    srgb(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

/** The colour at t in [0, 1], as sRGB in [0, 1]. */
export function ramp(t) {
  return fromOklch(0.3 + 0.65 * t, 0.1 + 0.06 * t ** 3, 290 - 180 * t);
}

export const cssRamp = (steps = 16) =>
  Array.from({ length: steps + 1 }, (_, i) => `rgb(${ramp(i / steps).map((c) => Math.round(255 * c)).join(' ')})`);
