// page.js: what the page shows, and what each action changes of it.

const state = {
  frame: -1,
  mesh: null,
  metric: 'shape',
  range: null,
  ownRange: null,
  codes: null,
  bins: null,
  selected: -1,
  pointed: -1,
  chosenBin: null,
  highlight: null,
  highlightWords: '',
  crosshair: false
};
let palette = new Palette();

const stage = new Stage(() => ({
                          mesh: state.mesh,
                          codes: state.codes,
                          palette,
                          edges: byId('show-edges').checked,
                          highlight: state.highlight,
                          field: state.mesh?.choice(state.metric),
                          range: state.range,
                          selected: state.selected,
                          pointed: state.pointed,
                          points: byId('show-points').checked,
                          crosshair: state.crosshair
                        }));

const report = () => frames[state.frame].report;
const isKind = () => state.metric === 'face' || state.metric === 'validity';
const listActions = {
  visit: (t) => {
    choose(t);
    stage.centreOn(state.mesh, t);
  },
  point: (t) => {
    state.pointed = t;
    stage.marksChanged();
  }
};

// Values that are equal but for rounding are one value: its noise is nothing to look at.
const isOneValue = (low, high) => !(high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high)));

// One scale for all frames, so that their colours can be compared.
function wholeRange(metric) {
  const known = frames.map((frame) => frame.ranges[metric]).filter(Boolean);
  if (known.length === 0) return null;
  const low = Math.min(...known.map((range) => range[0])), high = Math.max(...known.map((range) => range[1]));
  return isOneValue(low, high) ? [low, low] : [low, high];
}

function binRange(metric) {
  const histograms = frames.map((frame) => frame.report[metric]?.histogram).filter(Boolean);
  if (histograms.length === 0) return [...(wholeRange(metric) ?? [0, 1]), 20];
  const low = Math.min(...histograms.map((each) => each.low)), high = Math.max(...histograms.map((each) => each.high));
  return [low, isOneValue(low, high) ? low : high, histograms[0].counts.length];
}

function showFrame(number) {
  if (number === state.frame) return;
  const isFirst = state.frame < 0;
  Object.assign(state, {frame: number, mesh: meshOf(number), selected: -1, pointed: -1});
  if (isFirst) stage.fit(wholeBox());
  byId('subtitle').textContent = `${plural(report().triangles, 'element')} of degree ${report().degree}` +
      (report().time !== 0 || frames.length > 1 ? ` \u00b7 t = ${short(report().time, 6)}` : '');
  showVerdict(report());
  showProblems(byId('problems-panel'), state.mesh, frames[number], listActions);
  showSummary(byId('summary-panel'), frames[number]);
  player?.show(number);
  showMetric();
  select(-1);
}

// The box of all frames, so that what moves stays in sight.
function wholeBox() {
  const boxes = [...frames.map((frame) => frame.box).filter(Boolean), ...obstacleBoxes()];
  if (boxes.length === 0) return [0, 0, 1, 1];
  return [Math.min, Math.min, Math.max, Math.max].map((choose, k) => choose(...boxes.map((box) => box[k])));
}

function showMetric() {
  const {mesh, metric} = state;
  byId('metric').value = metric;
  byId('metric-words').textContent = metricText(metric);
  state.range = isKind() ? null : state.ownRange ?? wholeRange(metric);
  state.codes = colorCodes(mesh, metric, state.range);
  state.chosenBin = null;
  state.highlight = null;
  byId('range-row').hidden = isKind();
  showRange(state.range);
  byId('range-reset').disabled = state.ownRange === null;
  showDistribution();
  showWorst(byId('worst-panel'), mesh, metric, state.codes, palette, listActions);
  showCaption();
  historyCharts?.show(state.frame, metric);
  if (state.selected >= 0) select(state.selected);
  stage.changed();
}

// Five digits of the ends, more where the range is narrow beside them, but none below a millionth of it.
function showRange(range) {
  const size = range && range[1] - range[0];
  const text = (value) => (Math.abs(value) < 1e-6 * size ? 0 : rounded(value, 5, size));
  byId('range-low').value = range ? text(range[0]) : '';
  byId('range-high').value = range ? text(range[1]) : '';
}

const histogramNode = byId('histogram');
const kindsNode = make('div');
byId('histogram-figure').prepend(kindsNode);

function showDistribution() {
  const {mesh, metric} = state;
  histogramNode.toggleAttribute('hidden', isKind());
  kindsNode.hidden = !isKind();
  state.bins = null;
  if (isKind()) {
    showKinds(kindsNode, kindRows(), palette, chooseBin);
    return;
  }
  state.bins = makeBins(mesh.column(metric).values, ...binRange(metric));
  drawHistogram(histogramNode, state.bins, state.range ?? [0, 1], palette, {choose: chooseBin, point: pointBin});
}

function kindRows() {
  const {mesh} = state;
  const kinds = state.metric === 'face' ? mesh.faces : mesh.validity;
  const counts = new Map();
  for (const kind of kinds) counts.set(kind, (counts.get(kind) ?? 0) + 1);
  return [...counts]
      .sort((a, b) => a[0] - b[0])
      .map(([key, number]) => ({
             key,
             count: number,
             name: state.metric === 'face' ? mesh.faceNames[key] ?? `face ${key}` : validityWords[key],
             code: state.metric === 'face' ? faceCode + (key % settings.faces.length) :
                                             [validCode, degenerateCode, invalidCode][key]
           }));
}

function maskOf(bin) {
  const mask = new Uint8Array(state.mesh.count);
  const values = isKind() ? (state.metric === 'face' ? state.mesh.faces : state.mesh.validity) :
                            state.mesh.column(state.metric).values;
  for (let t = 0; t < mask.length; t++) mask[t] = (isKind() ? values[t] : state.bins.binOf(values[t])) === bin ? 1 : 0;
  return mask;
}

// A click keeps the elements of a bar highlighted; the same bar again lets go.
function chooseBin(bin) {
  state.chosenBin = state.chosenBin === bin ? null : bin;
  pointBin(-1);
}

function pointBin(bin) {
  const shown = bin >= 0 ? bin : state.chosenBin;
  state.highlight = shown === null ? null : maskOf(shown);
  for (const node of document.querySelectorAll('.bar, .kind')) {
    const isChosen = state.chosenBin !== null && Number(node.dataset.bin ?? node.dataset.key) === state.chosenBin;
    node.classList.toggle('chosen', isChosen);
    node.classList.toggle('current', isChosen);
    node.setAttribute('aria-pressed', String(isChosen));
  }
  showCaption(shown);
  stage.changed();
}

function showCaption(bin = null) {
  const caption = byId('histogram-caption');
  if (bin === null) {
    const missing = state.mesh.column(state.metric)?.values.filter((value) => !Number.isFinite(value)).length ?? 0;
    caption.textContent =
        missing > 0 ? `${plural(missing, 'element')} without a value` : 'Click a bar to see its elements.';
    if (isKind()) caption.textContent = 'Click a row to see its elements.';
    return;
  }
  const number = state.highlight.reduce((sum, each) => sum + each, 0);
  const {bins} = state;
  const size = bins && bins.high - bins.low, edge = (k) => short(bins.low + (size * k) / bins.counts.length, 4, size);
  caption.textContent = `${plural(number, 'element')} highlighted` + (bins ? `: ${edge(bin)} to ${edge(bin + 1)}` : '');
}

function setMetric(name) {
  state.metric = name;
  state.ownRange = null;
  showMetric();
  link.soon();
}

// A choice of the reader's, which the address keeps.
function choose(t) {
  select(t);
  link.step();
}

function select(t) {
  state.selected = t;
  showElement(
      byId('element-panel'), state.mesh, t, state.metric,
      {release: () => choose(-1), centre: () => stage.centreOn(state.mesh, t), metric: setMetric});
  for (const button of document.querySelectorAll('[data-element]'))
    button.classList.toggle('current', t >= 0 && Number(button.dataset.element) === state.mesh.triangles[t]);
  markValue(histogramNode, state.bins, t >= 0 && state.bins ? state.mesh.column(state.metric).values[t] : NaN);
  stage.marksChanged();
}

// A second click at the same place goes on to what lies below.
function pick(x, y) {
  const found = elementsAt(state.mesh, x, y);
  const at = found.indexOf(state.selected);
  choose(found.length === 0 || (found.length === 1 && at === 0) ? -1 : found[(at + 1) % found.length]);
}

// Where the pointer is, and what it would pick.
function pointAt(x, y) {
  if (x === undefined) {
    byId('pointer').textContent = '';
    return;
  }
  const {mesh, metric} = state, [t] = elementsAt(mesh, x, y), value = mesh.column(metric)?.values[t];
  const element = t === undefined ? '' : ` \u00b7 element ${mesh.triangles[t]}`;
  const field = mesh.choice(metric), here = field && t !== undefined ? valueAt(mesh, t, field, x, y) : value;
  const figure = value === undefined ? '' : `: ${metricTitle(metric)} ${short(here, 5)}${metricUnit(metric)}`;
  const size = stage.camera.width / stage.camera.scale;
  byId('pointer').textContent = `${short(x, 6, size)}, ${short(y, 6, size)}${element}${figure}`;
}

const goTo = (frame) => {
  showFrame(frame);
  link.soon();
};
const historyCharts = frames.length > 1 ? new History((frame) => {
  player.stop();
  goTo(frame);
}) :
                                          null;
const player = frames.length > 1 ? new Player(goTo) : null;

// A view of all is none of its own, unless an element is chosen, which would be looked at.
function viewNow() {
  const {x, y, scale, fitted, isHome} = stage.camera;
  return isHome && state.selected < 0 ? undefined : [x, y, Number((scale / fitted).toPrecision(6))];
}

function showWanted({frame, element, color, view}) {
  showFrame(frame < frames.length ? frame : 0);
  const metric =
      color !== undefined && [...byId('metric').options].some((option) => option.value === color) ? color : 'shape';
  if (metric !== state.metric) setMetric(metric);
  const t = state.mesh.indexOfTriangle.get(element) ?? -1;
  select(t);
  stage.stopGliding();
  stage.camera.fit(stage.box);
  if (view !== undefined)
    Object.assign(stage.camera, {x: view[0], y: view[1], scale: stage.camera.limited(stage.camera.fitted * view[2])});
  else if (t >= 0)
    stage.lookAt(state.mesh, t);
  stage.drawNow();
}

const link = new Link(
    () => ({
      frame: state.frame,
      element: state.selected >= 0 ? state.mesh.triangles[state.selected] : undefined,
      color: state.metric === 'shape' ? undefined : state.metric,
      view: viewNow()
    }),
    showWanted);

// Colours of the system's light or dark, or of paper.
function repaint() {
  palette = new Palette();
  showMetric();
  if (state.selected >= 0) select(state.selected);
  stage.drawNow();
}

function setPrinting(isPrinting) {
  if (document.documentElement.classList.contains('printing') === isPrinting) return;
  document.documentElement.classList.toggle('printing', isPrinting);
  stage.leastRatio = isPrinting ? 2 : 0;
  stage.resize();
  repaint();
}

function start() {
  byId('title').textContent = settings.title;
  byId('player').hidden = byId('history-panel').hidden = frames.length < 2;
  listenToGestures(stage, {
    pick,
    pointAt,
    release: () => choose(-1),
    focus: (isVisible) => {
      state.crosshair = isVisible;
      stage.marksChanged();
    }
  });
  const names = meshOf(0).columns.map((column) => column.name);
  const option = (name) => make('option', {value: name}, metricTitle(name));
  const fields = fieldNames();
  byId('metric').append(
      make('optgroup', {label: 'Measures'}, ...names.map(option)),
      ...(fields.length > 0 ? [make('optgroup', {label: 'Fields'}, ...fields.map(option))] : []),
      make('optgroup', {label: 'Kinds'}, ...['face', 'validity'].map(option)));
  byId('metric').onchange = (event) => setMetric(event.target.value);
  byId('show-edges').onchange = () => stage.changed();
  byId('show-points').onchange = () => stage.marksChanged();
  for (const id of ['range-low', 'range-high'])
    byId(id).onchange = () => {
      const range = [Number(byId('range-low').value), Number(byId('range-high').value)];
      state.ownRange = range.every(Number.isFinite) && range[0] < range[1] ? range : null;
      showMetric();
    };
  byId('range-reset').onclick = () => setMetric(state.metric);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', repaint);
  matchMedia('print').addEventListener('change', (event) => setPrinting(event.matches));
  addEventListener('beforeprint', () => setPrinting(true));
  addEventListener('afterprint', () => setPrinting(matchMedia('print').matches));
  stage.onMove = () => link.soon();
  link.follow();
  // Now, not in the next frame of the screen, so that the page is never seen without its drawing.
  stage.drawNow();
}

// For tests, and for those who look at a page from its console.
window.pliant = {
  state,
  stage,
  toScreen(x, y) {
    const box = stage.marksCanvas.getBoundingClientRect(), [sx, sy] = stage.camera.toScreen(x, y);
    return [box.left + sx, box.top + sy];
  },
  valueAt: (x, y) => valueAt(state.mesh, elementsAt(state.mesh, x, y)[0], state.mesh.choice(state.metric), x, y),
  highlighted: () => (state.highlight ? state.highlight.reduce((sum, each) => sum + each, 0) : 0),
  redraw() {
    stage.isStale = true;
    stage.isHasty = false;
    stage.draw();
    return stage.milliseconds;
  },
};

if (frames.length > 0) start();
