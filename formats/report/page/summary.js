// summary.js: the figures of the whole mesh, its faces, fields and metrics, from the report.

function showVerdict(report) {
  const parts = [];
  if (report.invalid > 0) parts.push(`${count(report.invalid)} invalid`);
  if (report.degenerate > 0) parts.push(`${count(report.degenerate)} degenerate`);
  if (report.overlaps > 0) parts.push(plural(report.overlaps, 'overlap'));
  if (report.faults.length > 0) parts.push(plural(report.faults.length, 'fault'));
  const verdict = byId('verdict');
  verdict.className = report.invalid + report.overlaps + report.faults.length > 0 ? 'bad' :
      parts.length > 0                                                            ? 'warn' :
                                                                                    '';
  verdict.textContent = parts.join(' \u00b7 ') ||
      (report.triangles > 0 ? `all ${count(report.triangles)} elements valid` : 'no elements');
}

function plainTable(heads, rows) {
  return make(
      'div', {class: 'scroll'},
      make(
          'table', {},
          make(
              'thead', {}, make('tr', {}, ...heads.map((head, i) => make('th', {class: i > 0 ? 'number' : ''}, head)))),
          make(
              'tbody', {},
              ...rows.map(
                  (row) => make(
                      'tr', {}, make('th', {class: 'name', scope: 'row'}, row[0]),
                      ...row.slice(1).map((cell) => make('td', {}, cell)))))));
}

function showSummary(panel, frame) {
  const {report, source} = frame;
  const figures = [
    ['elements', count(report.triangles)], ['vertices', count(report.vertices)],
    ['control points', count(report.control_points)], ['degree', report.degree], ['time', short(report.time, 9)],
    ['area', short(report.area, 9)], ['invalid', count(report.invalid)], ['degenerate', count(report.degenerate)],
    ['overlaps', count(report.overlaps)], ['faults', count(report.faults.length)],
    ['duplicate points', count(frame.duplicate_points)], ['unused points', count(frame.unused_points)],
    ['tangent jump', report.tangent_jump === null ? '\u2013' : `${short(report.tangent_jump)} rad`], ['source', source]
  ];
  const metrics = Object.keys(report)
                      .filter((name) => report[name]?.worst)
                      .map(
                          (name) =>
                              [metricTitle(name) + (metricUnit(name) ? ' (\u00b0)' : ''), short(report[name].min),
                               short(report[name].mean), short(report[name].max)]);
  const section = (title, isOpen, ...content) =>
      make('details', {open: isOpen}, make('summary', {}, title), ...content);
  const open =
      [...panel.querySelectorAll('details')].filter((node) => !node.open).map((node) => node.firstChild.textContent);
  const children = [section('Summary', true, plainTable(['', ''], figures))];
  if (frame.history)
    children.push(section(
        'Made by', true,
        plainTable(['tool', 'options'], frame.history.map((step) => [`${step.tool} ${step.version}`, step.options]))));
  children.push(section('Metrics', true, plainTable(['metric', 'min', 'mean', 'max'], metrics)));
  children.push(section(
      'Faces', true,
      plainTable(
          ['face', 'elements', 'area', 'perimeter'],
          report.faces.map((face) => [face.name, count(face.triangles), short(face.area), short(face.perimeter)]))));
  if (report.fields.length > 0)
    children.push(section(
        'Fields', true,
        plainTable(
            ['field', 'min', 'max', 'integral'],
            report.fields.flatMap(
                (field) => field.min.map(
                    (least, c) =>
                        [field.min.length > 1 ? `${field.name}.${c}` : field.name, short(least), short(field.max[c]),
                         short(field.integral[c])])))));
  for (const child of children)
    if (open.includes(child.firstChild.textContent)) child.open = false;
  panel.replaceChildren(...children);
}
