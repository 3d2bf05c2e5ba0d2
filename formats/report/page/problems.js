// problems.js: what is wrong with the mesh, and where: elements that are not valid, overlaps, faults.

const mostChips = 120;

function problem(title, mark, text, ...content) {
  const swatches = mark ? [make('span', {class: `swatch ${mark}`})] : [];
  return make(
      'div', {class: 'problem'}, make('h2', {}, ...swatches, title), text ? make('p', {class: 'note'}, text) : '',
      ...content);
}

function notValid(mesh, kind, text, actions) {
  const word = validityWords[kind], list = mesh.bad.filter((t) => mesh.validity[t] === kind);
  if (list.length === 0) return [];
  const button = (t) => elementButton(
      mesh, t, {class: word, 'aria-label': `${word} element ${mesh.triangles[t]}`}, actions, String(mesh.triangles[t]));
  const rest =
      list.length > mostChips ? [make('span', {class: 'note'}, `and ${count(list.length - mostChips)} more`)] : [];
  const chips = make('div', {class: 'chips'}, ...list.slice(0, mostChips).map(button), ...rest);
  return [problem(`${count(list.length)} ${word}`, word, text, chips)];
}

// The elements that lie over each other, as far as the report names them.
function overlaps(mesh, frame, actions) {
  if (frame.report.overlaps === 0) return [];
  const rows = frame.overlaps.map((overlap) => {
    const at = overlap.at ? `at (${overlap.at.map((each) => short(each, 5, mesh.size)).join(', ')}) ` : '';
    return make('li', {}, at, ...overlap.triangles.map((triangle) => showButton(mesh, triangle, actions)));
  });
  return [problem(
      plural(frame.report.overlaps, 'overlap'), '', 'The mesh lies over itself, or its boundary crosses itself.',
      make('ul', {class: 'faults'}, ...rows))];
}

function showButton(mesh, triangle, actions) {
  const t = mesh.indexOfTriangle.get(triangle);
  return t === undefined ? `element ${triangle} ` :
                           elementButton(mesh, t, {class: 'link'}, actions, `element ${triangle}`);
}

// The number of an element that the fault's place names or touches. Places are JSON pointers into flat arrays.
function elementOfFault(mesh, fault) {
  const [, array, index] = /^\/(triangles|points)\/(\d+)/.exec(fault.place) ?? [];
  if (array === 'triangles') return Math.floor(Number(index) / mesh.netSize);
  if (array !== 'points') return undefined;
  const entry = mesh.nets.indexOf(Math.floor(Number(index) / 2));
  return entry < 0 ? undefined : mesh.triangles[Math.floor(entry / mesh.netSize)];
}

function faults(mesh, list, actions) {
  if (list.length === 0) return [];
  const rows = list.map((fault) => {
    const triangle = elementOfFault(mesh, fault);
    return make(
        'li', {}, make('b', {}, fault.invariant), ` ${fault.place}: ${fault.text} `,
        triangle === undefined ? '' : showButton(mesh, triangle, actions));
  });
  return [problem(
      plural(list.length, 'fault'), '', 'Invariants of a mesh document that this one breaks.',
      make('ul', {class: 'faults'}, ...rows))];
}

function showProblems(panel, mesh, frame, actions) {
  panel.replaceChildren(
      ...notValid(mesh, 2, 'det J < 0 somewhere inside: a proof for the numbers as stored.', actions),
      ...notValid(mesh, 1, 'det J touches 0.', actions), ...overlaps(mesh, frame, actions),
      ...faults(mesh, frame.report.faults, actions));
  panel.hidden = panel.childElementCount === 0;
}
