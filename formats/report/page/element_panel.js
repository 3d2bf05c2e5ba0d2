// element_panel.js: the figures of the chosen element.

// 1 for the worst; ties share.
function rankOf(column, t) {
  const {values, worstIsLeast} = column, value = values[t];
  if (!Number.isFinite(value)) return undefined;
  let rank = 1;
  for (let k = 0; k < values.length; k++)
    if (worstIsLeast ? values[k] < value : values[k] > value) rank++;
  return rank;
}

function validityBadge(validity) {
  const word = validityWords[validity];
  return make('span', {class: `badge ${word}`}, word);
}

// actions: {release, centre, metric(name)}
function showElement(panel, mesh, t, metric, actions) {
  panel.hidden = t < 0;
  if (t < 0) return;
  const rows = mesh.columns.map((column) => {
    const value = column.values[t], rank = rankOf(column, t);
    const text = Number.isFinite(value) ? short(value, 9) + metricUnit(column.name) : '\u2013';
    return make(
        'tr', {
          class: column.name === metric ? 'choice current' : 'choice',
          title: `${metricText(column.name)} Click to colour by it.`,
          onclick: () => actions.metric(column.name)
        },
        make('th', {scope: 'row'}, metricTitle(column.name)),
        make('td', {'data-figure': column.name, 'data-value': value, title: String(value)}, text),
        make('td', {class: 'note', title: 'rank: 1 is the worst of all elements'}, rank ? `${count(rank)}.` : ''));
  });
  const [x, y] = mesh.centre(t);
  panel.replaceChildren(
      make(
          'div', {class: 'head'}, make('h2', {}, `Element ${mesh.triangles[t]}`), validityBadge(mesh.validity[t]),
          make('button', {type: 'button', onclick: actions.centre}, 'centre'),
          make('button', {type: 'button', 'aria-label': 'Let go of the element', onclick: actions.release}, '\u00d7')),
      make(
          'p', {class: 'note'},
          `face ${mesh.faceNames[mesh.faces[t]] ?? mesh.faces[t]} \u00b7 barycentre (${short(x, 7, mesh.size)}, ${
              short(y, 7, mesh.size)})`),
      make(
          'table', {},
          make(
              'thead', {},
              make(
                  'tr', {}, make('th', {}, 'measure'), make('th', {class: 'number'}, 'value'),
                  make('th', {class: 'number'}, 'rank'))),
          make('tbody', {}, ...rows)),
      controlPointTable(mesh, t));
}

function controlPointTable(mesh, t) {
  const exponents = netExponents(mesh.degree);
  const rows = exponents.map((entry, n) => {
    const point = mesh.nets[t * mesh.netSize + n];
    return make(
        'tr', {}, make('th', {scope: 'row'}, `b${entry.join(mesh.degree > 9 ? ',' : '')}`), make('td', {}, point),
        make('td', {}, String(mesh.points[2 * point])), make('td', {}, String(mesh.points[2 * point + 1])));
  });
  return make(
      'details', {}, make('summary', {}, 'Control points'),
      make(
          'div', {class: 'scroll'},
          make(
              'table', {},
              make(
                  'thead', {},
                  make(
                      'tr', {}, make('th', {}, ''), make('th', {class: 'number'}, 'point'),
                      make('th', {class: 'number'}, 'x'), make('th', {class: 'number'}, 'y'))),
              make('tbody', {}, ...rows))));
}
