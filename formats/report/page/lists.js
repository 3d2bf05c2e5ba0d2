// lists.js: elements as buttons that lead to them: the worst of the metric; and the kinds of elements.

// The worst first; equal values by number, as in the other reports.
function worstElements(mesh, column, most) {
  const {values, worstIsLeast} = column;
  const isWorse = (a, b) => {
    if (values[a] !== values[b]) return worstIsLeast ? values[a] < values[b] : values[a] > values[b];
    return mesh.triangles[a] < mesh.triangles[b];
  };
  const list = [];
  for (let t = 0; t < mesh.count; t++) {
    if (!Number.isFinite(values[t])) continue;
    if (list.length === most && !isWorse(t, list[most - 1])) continue;
    let at = list.length < most ? list.length : most - 1;
    for (; at > 0 && isWorse(t, list[at - 1]); at--) list[at] = list[at - 1];
    list[at] = t;
  }
  return list;
}

// actions: {visit(t), point(t or -1)}
function elementButton(mesh, t, attributes, actions, ...children) {
  return make(
      'button', {
        type: 'button',
        'data-element': mesh.triangles[t],
        onclick: () => actions.visit(t),
        onpointerenter: () => actions.point(t),
        onpointerleave: () => actions.point(-1),
        onfocus: () => actions.point(t),
        onblur: () => actions.point(-1),
        ...attributes
      },
      ...children);
}

// A swatch of the element's colour, or marked as the element is.
function swatch(code, palette) {
  if (code === invalidCode || code === degenerateCode)
    return make('span', {class: `swatch ${code === invalidCode ? 'invalid' : 'degenerate'}`});
  return make('span', {class: 'swatch', style: `background:${palette.text[code]}`});
}

function showWorst(panel, mesh, metric, codes, palette, actions) {
  const column = mesh.column(metric);
  panel.hidden = !column || column.isField || mesh.count === 0 || settings.worst === 0;
  if (panel.hidden) return;
  const list = worstElements(mesh, column, settings.worst);
  panel.replaceChildren(
      make('h2', {}, `Worst by ${metricTitle(metric)}`),
      make(
          'ol', {class: 'elements'},
          ...list.map(
              (t, place) => make(
                  'li', {},
                  elementButton(
                      mesh, t, {}, actions, make('span', {class: 'rank'}, `${place + 1}.`), swatch(codes[t], palette),
                      `element ${mesh.triangles[t]}`,
                      make('span', {class: 'value'}, short(column.values[t], 6) + metricUnit(metric)))))));
}

// In place of a histogram where elements are coloured by kind. choose(key or -1)
function showKinds(figure, rows, palette, choose) {
  figure.replaceChildren(make(
      'div', {class: 'scroll'},
      make(
          'table', {},
          make(
              'tbody', {},
              ...rows.map(
                  (row) => make(
                      'tr', {
                        class: 'choice kind',
                        'data-key': row.key,
                        tabindex: 0,
                        role: 'button',
                        onclick: () => choose(row.key),
                        onkeydown: (event) => {
                          if (event.key !== 'Enter' && event.key !== ' ') return;
                          event.preventDefault();
                          choose(row.key);
                        }
                      },
                      make('th', {class: 'name', scope: 'row'}, swatch(row.code, palette), row.name),
                      make('td', {}, count(row.count))))))));
}
