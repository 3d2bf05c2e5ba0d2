// colors.js: an element's colour is a code into a table of few colours, so that elements of one colour draw as one
// path.

const mapColors = 64;
const missingCode = mapColors, validCode = missingCode + 1, degenerateCode = validCode + 1,
      invalidCode = degenerateCode + 1;
const faceCode = invalidCode + 1;
const dimmed = 128;  // added to the code of elements that are not highlighted

const parseHex = (text) => [1, 3, 5].map((at) => parseInt(text.trim().slice(at, at + 2), 16));
const toHex = (rgb) => `#${rgb.map((part) => Math.round(part).toString(16).padStart(2, '0')).join('')}`;
const mix = (a, b, s) => a.map((part, i) => part + s * (b[i] - part));

function mapColor(s) {
  const stops = settings.viridis, place = Math.max(0, Math.min(1, s)) * (stops.length - 1);
  const i = Math.min(Math.floor(place), stops.length - 2);
  return mix(parseHex(stops[i]), parseHex(stops[i + 1]), place - i);
}

// The colours as text for canvases and as words for pixels; made anew when the page turns light or dark.
class Palette {
  constructor() {
    const style = getComputedStyle(document.documentElement);
    const named = (name) => style.getPropertyValue(name).trim();
    this.paper = named('--paper');
    this.meshLine = named('--mesh-line');
    this.curve = named('--curve');
    this.accent = named('--accent');
    this.ink = named('--ink');
    this.net = named('--net');
    this.soft = named('--soft');
    this.obstacle = named('--obstacle');
    const list = Array.from({length: mapColors}, (_, i) => mapColor((i + 0.5) / mapColors));
    list.push(
        parseHex(settings.missing), parseHex('#8fb9a8'), parseHex(settings.degenerate), parseHex(settings.invalid));
    list.push(...settings.faces.map(parseHex));
    const paper = parseHex(this.paper);
    this.text = new Array(2 * dimmed);
    this.pixel = new Uint32Array(2 * dimmed);
    list.forEach((color, code) => {
      for (const [at, rgb] of [[code, color], [code + dimmed, mix(color, paper, 0.84)]]) {
        this.text[at] = toHex(rgb);
        this.pixel[at] = (255 << 24 | Math.round(rgb[2]) << 16 | Math.round(rgb[1]) << 8 | Math.round(rgb[0])) >>> 0;
      }
    });
  }
}

// The code of a value; halves, since the difference of two doubles may overflow.
function codeOf(value, low, high) {
  if (!Number.isFinite(value)) return missingCode;
  const s = low < high ? (value / 2 - low / 2) / (high / 2 - low / 2) : 0.5;
  return Math.max(0, Math.min(mapColors - 1, Math.floor(s * mapColors)));
}

// The codes of all elements. `range` is [low, high] or null.
function colorCodes(mesh, metric, range) {
  const codes = new Uint8Array(mesh.count);
  const column = mesh.column(metric);
  for (let t = 0; t < mesh.count; t++) {
    if (metric === 'face')
      codes[t] = faceCode + (Math.max(0, mesh.faces[t]) % settings.faces.length);
    else if (metric === 'validity')
      codes[t] = validCode;
    else
      codes[t] = range ? codeOf(column.values[t], range[0], range[1]) : missingCode;
    if (mesh.validity[t] === 1) codes[t] = degenerateCode;
    if (mesh.validity[t] === 2) codes[t] = invalidCode;
  }
  return codes;
}
