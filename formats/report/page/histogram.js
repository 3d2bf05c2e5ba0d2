// histogram.js: how many elements have which value; a bar highlights its elements. The strip under it is the colour
// bar.

// Round numbers within the range, about `most` of them.
function roundTicks(low, high, most) {
  const rough = (high - low) / most;
  if (!(rough > 0) || !Number.isFinite(rough)) return [low];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((each) => each >= rough * 0.999);
  const list = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++)
    list.push(Number((k * step).toPrecision(12)));
  return list;
}

// {low, high, counts, binOf(value)} as the report has it: the last bin holds its upper end, too.
function makeBins(values, low, high, size) {
  const half = high / 2 - low / 2;
  const binOf = (value) => {
    if (!Number.isFinite(value)) return -1;
    const s = half > 0 ? (value / 2 - low / 2) / half : 0;
    return Math.min(size - 1, Math.floor(Math.max(0, Math.min(1, s)) * size));
  };
  const counts = new Array(size).fill(0);
  for (const value of values)
    if (Number.isFinite(value)) counts[binOf(value)]++;
  return {low, high, counts, binOf};
}

const plotWidth = 352, plotHeight = 96;

// choose(bin or -1) when a bar is clicked, point(bin or -1) when it is hovered.
function drawHistogram(svg, bins, range, palette, {choose, point}) {
  const size = bins.counts.length, most = Math.max(1, ...bins.counts), step = plotWidth / size;
  const width = bins.high - bins.low;
  svg.replaceChildren();
  svg.setAttribute('viewBox', `0 0 ${plotWidth} ${plotHeight + 30}`);
  const place = (value) => (width > 0 ? (value - bins.low) / width : 0.5) * plotWidth;
  const colorAt = (value) => palette.text[codeOf(value, range[0], range[1])];
  bins.counts.forEach((number, bin) => {
    // A single element shows, however many are elsewhere.
    const height = number > 0 ? Math.max(2.5, (number / most) * (plotHeight - 4)) : 0;
    const low = bins.low + (width * bin) / size, high = bins.low + (width * (bin + 1)) / size;
    const words = `${plural(number, 'element')} from ${short(low, 4, width)} to ${short(high, 4, width)}`;
    const bar = makeSvg(
        'g', {
          class: 'bar',
          tabindex: number > 0 ? 0 : -1,
          role: 'button',
          'data-bin': bin,
          'data-count': number,
          'aria-label': words,
          'aria-pressed': 'false'
        },
        makeSvg('title', {}, words),
        makeSvg('rect', {class: 'hit', x: bin * step, y: 0, width: step, height: plotHeight}), makeSvg('rect', {
          x: bin * step + 0.5,
          y: plotHeight - height,
          width: Math.max(0.5, step - 1),
          height,
          rx: Math.min(1.5, height / 2),
          fill: colorAt((low + high) / 2),
          stroke: 'var(--soft)',
          'stroke-width': number > 0 ? 0.4 : 0
        }));
    if (number > 0) {
      bar.addEventListener('click', () => choose(bin));
      bar.addEventListener('pointerenter', () => point(bin));
      bar.addEventListener('pointerleave', () => point(-1));
      bar.addEventListener('keydown', (event) => {
        if (event.key !== 'Enter' && event.key !== ' ') return;
        event.preventDefault();
        choose(bin);
      });
    }
    svg.append(bar);
  });
  drawColorStrip(svg, bins, colorAt);
  for (const value of roundTicks(bins.low, bins.high, 5)) {
    const x = Math.max(0, Math.min(plotWidth, place(value)));
    const anchor = x < 12 ? 'start' : x > plotWidth - 12 ? 'end' : 'middle';
    svg.append(
        makeSvg('path', {class: 'tick', d: `M${x} ${plotHeight + 9}v4`}),
        makeSvg('text', {x, y: plotHeight + 25, 'text-anchor': anchor}, short(value, 5, width)));
  }
}

function drawColorStrip(svg, bins, colorAt) {
  const pieces = 88;
  const stops = Array.from(
      {length: pieces + 1},
      (_, k) => makeSvg(
          'stop', {offset: k / pieces, 'stop-color': colorAt(bins.low + ((bins.high - bins.low) * k) / pieces)}));
  svg.append(
      makeSvg('defs', {}, makeSvg('linearGradient', {id: 'strip'}, ...stops)),
      makeSvg('rect', {x: 0, y: plotHeight + 1, width: plotWidth, height: 8, fill: 'url(#strip)'}));
}

// A little triangle under the value of the chosen element.
function markValue(svg, bins, value) {
  svg.querySelector('.place')?.remove();
  if (!bins || !Number.isFinite(value)) return;
  const s = bins.high > bins.low ? (value - bins.low) / (bins.high - bins.low) : 0.5;
  const x = Math.max(0, Math.min(1, s)) * plotWidth;
  svg.append(makeSvg('path', {class: 'place', d: `M${x} ${plotHeight + 1}l-5 9h10z`, stroke: 'var(--panel)'}));
}
