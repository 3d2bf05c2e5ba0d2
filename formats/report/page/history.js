// history.js: for a series, how the metrics change over the frames; a click goes to the frame.

const chartWidth = 300, chartHeight = 100;

class History {
  // go(frame)
  constructor(go) {
    this.go = go;
    const times = frames.map((frame) => frame.report.time);
    // By time where it only grows, else by number.
    this.xs = times.every((time, i) => i === 0 || time > times[i - 1]) ? times : frames.map((_, i) => i);
    const names = Object.keys(frames[0].report).filter((name) => frames[0].report[name]?.worst);
    this.charts = [
      {name: 'triangles', title: 'elements', lines: [frames.map((frame) => frame.report.triangles)]}, {
        name: 'invalid',
        title: 'not valid',
        lines: [frames.map((frame) => frame.report.invalid + frame.report.degenerate)]
      },
      ...names.map((name) => ({
                     name,
                     title: metricTitle(name),
                     unit: metricUnit(name),
                     lines: ['min', 'mean', 'max'].map((which) => frames.map((frame) => frame.report[name][which]))
                   }))
    ];
    const box = byId('history');
    for (const chart of this.charts) box.append(this.draw(chart));
  }

  x(frame) {
    const first = this.xs[0], last = this.xs[this.xs.length - 1];
    return last > first ? ((this.xs[frame] - first) / (last - first)) * chartWidth : chartWidth / 2;
  }

  draw(chart) {
    const values = chart.lines.flat().filter((value) => Number.isFinite(value));
    const low = Math.min(...values), high = Math.max(...values);
    const y = (value) => (high > low ? 94 - (88 * (value - low)) / (high - low) : 50);
    const path = (line) =>
        line.map(
                (value, i) =>
                    (Number.isFinite(value) ? `${Number.isFinite(line[i - 1]) ? 'L' : 'M'}${this.x(i)} ${y(value)}` :
                                              ''))
            .join('');
    const svg = makeSvg('svg', {
      viewBox: `0 0 ${chartWidth} ${chartHeight}`,
      preserveAspectRatio: 'none',
      role: 'img',
      'aria-label': `${chart.title} over the frames, from ${short(low)} to ${short(high)}`
    });
    if (chart.lines.length === 3) {
      const known = frames.map((_, i) => i).filter((i) => chart.lines.every((line) => Number.isFinite(line[i])));
      const band = known.map((i) => `${this.x(i)} ${y(chart.lines[0][i])}`)
                       .concat(known.reverse().map((i) => `${this.x(i)} ${y(chart.lines[2][i])}`));
      if (band.length > 0) svg.append(makeSvg('path', {class: 'band', d: `M${band.join('L')}Z`}));
      ['least', 'mean', 'most'].forEach(
          (name, k) => svg.append(makeSvg('path', {class: name, d: path(chart.lines[k])})));
    } else {
      svg.append(makeSvg('path', {class: 'mean', d: path(chart.lines[0])}));
    }
    chart.now = makeSvg('path', {class: 'now'});
    svg.append(chart.now);
    chart.value = make('b');
    chart.node = make(
        'div', {class: 'chart', 'data-metric': chart.name},
        make('div', {class: 'name'}, make('span', {}, chart.title), chart.value),
        make(
            'div', {class: 'plot'}, svg, make('span', {class: 'high'}, short(high, 3)),
            make('span', {class: 'low'}, short(low, 3))));
    const goTo = (event) => {
      const box = svg.getBoundingClientRect();
      const at = ((event.clientX - box.left) / box.width) * chartWidth;
      let nearest = 0;
      for (let i = 1; i < frames.length; i++)
        if (Math.abs(this.x(i) - at) < Math.abs(this.x(nearest) - at)) nearest = i;
      this.go(nearest);
    };
    svg.addEventListener('pointerdown', goTo);
    svg.addEventListener('pointermove', (event) => {
      if (event.buttons & 1) goTo(event);
    });
    return chart.node;
  }

  // The values of this frame: all three in the wide chart, the one that matters in the others.
  valueText(chart, frame, isCurrent) {
    if (chart.lines.length === 1) return count(chart.lines[0][frame]);
    const words = ['least', 'mean', 'most'];
    const part = (k) => `${words[k]} ${short(chart.lines[k][frame], 3)}${chart.unit}`;
    return isCurrent ? [0, 1, 2].map(part).join(', ') :
                       part(['distortion', 'turning_angle'].includes(chart.name) ? 2 : 0);
  }

  // Marks the frame, and puts the chart of the metric first and wide.
  show(frame, metric) {
    for (const chart of this.charts) {
      const x = this.x(frame);
      chart.now.setAttribute('d', `M${x} 0V${chartHeight}`);
      const isCurrent = chart.name === metric;
      chart.value.textContent = this.valueText(chart, frame, isCurrent);
      chart.node.classList.toggle('current', isCurrent);
      chart.node.classList.toggle('wide', isCurrent);
      chart.node.style.order = isCurrent ? -1 : 0;
    }
  }
}
