// Colours that are told apart by the colour-blind and in print: viridis for lines, lightness for depth.

export const VIRIDIS = [
  "#440154",
  "#482475",
  "#414487",
  "#355f8d",
  "#2a788e",
  "#21918c",
  "#22a884",
  "#44bf70",
  "#7ad151",
  "#bddf26",
  "#fde725",
];
export const DEPTH = ["#f0e7d0", "#ccd3c6", "#9dbcc6", "#6f9dbb", "#4a7ba6", "#335d8a"]; // shallow to deep
export const STATES = ["#f6f7f8", "#e69f00", "#7a2e00"]; // clear of the seabed, on it, held by friction
export const ENDS = ["#D55E00", "#0072B2"]; // Okabe and Ito's
export const INK = "#1d2733";

function rgb(hex) {
  return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
}

/** Colour of a palette at a share from 0 to 1, as [r, g, b] of 0 to 255. */
export function colourAt(palette, share) {
  const at = Math.min(Math.max(share, 0), 1) * (palette.length - 1);
  const k = Math.min(Math.floor(at), palette.length - 2);
  const [a, b] = [rgb(palette[k]), rgb(palette[k + 1])];
  return a.map((v, i) => Math.round(v + (at - k) * (b[i] - v)));
}

/** A strip of 256 colours for shaders; `states` colours stand beside each other without a mix. */
export function strip(palette, states = 0) {
  const pixels = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; i++) {
    const colour = states
      ? rgb(palette[Math.min(Math.floor((i / 256) * states), states - 1)])
      : colourAt(palette, i / 255);
    pixels.set([...colour, 255], 4 * i);
  }
  const texture = new THREE.DataTexture(pixels, 256, 1);
  if (!states) texture.magFilter = texture.minFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
