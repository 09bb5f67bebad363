// Histograms and box plots, made from the summary's counts and quartiles. Two runs are counted in the same bins, and
// shown side by side as shares of each.

// `of(run)` gives {low, width, counts}; `per` turns the file's unit into the one shown, `thing` is what is counted.
function histogramFigure(parent, {title, quantity, unit, per = 1, of, thing = 'rocks', width = drawing.half, tall = 200}) {
  const shown = runs.filter((run) => of(run) && of(run).counts.some((n) => n > 0));
  if (!shown.length) return false;
  const series = shown.map((run) => {
    const {low, width: step, counts} = of(run);
    const total = d3.sum(counts);
    const bars = counts.map((n, i) => ({run, n, share: 100 * n / total, low: (low + i * step) / per, high: (low + (i + 1) * step) / per}));
    const used = bars.filter((bar) => bar.n > 0);
    return {run, total, step: step / per, bars: bars.filter((bar) => bar.low >= used[0].low && bar.high <= used[used.length - 1].high)};
  });
  const measure = single ? (bar) => bar.n : (bar) => bar.share;
  const yLabel = single ? `Number of ${thing}` : `Share of each run's ${thing} [%]`;
  const all = series.flatMap((s) => s.bars);
  figure(parent, {
    title, label: `${title}: histogram of ${quantity} in ${unit}`,
    caption: series.map((s) => `${single ? '' : s.run.label + ': '}${count(s.total, thing.replace(/s$/, ''), thing)}, ${areEqual(s.step, 0) ? 'all of one value' : `bins of ${number(s.step, 4)} ${unit}`}`).join('; ') + '.',
    width,
    draw(svg) {
      const side = {left: 62, right: width - 12, top: 12, bottom: 12 + tall};
      const toX = d3.scaleLinear().domain(extentOf(all.flatMap((bar) => [bar.low, bar.high]), 0.03)).range([side.left, side.right]);
      const toY = d3.scaleLinear().domain([0, d3.max(all, measure) * 1.06]).range([side.bottom, side.top]);
      axes(svg, toX, toY, side, {xLabel: `${quantity} [${unit}]`, yLabel});
      series.forEach((s, k) => {
        // Its part of the bin.
        const left = (bar) => toX(bar.low + (bar.high - bar.low) * k / series.length);
        const width = (bar) => (toX(bar.high) - toX(bar.low)) / series.length;
        tip(svg.append('g').style('--run', s.run.colour).selectAll('rect').data(s.bars.filter((bar) => bar.n > 0)).enter().append('rect')
          .attr('class', 'bar').attr('x', left).attr('width', (bar) => Math.max(width(bar) - 0.5, 1.5))
          .attr('y', (bar) => toY(measure(bar))).attr('height', (bar) => side.bottom - toY(measure(bar))),
        (bar) => (single ? '' : bar.run.label + '\n') + `${number(bar.low, 5)} to ${number(bar.high, 5)} ${unit}\n${number(bar.n)} of ${count(s.total, thing.replace(/s$/, ''), thing)} (${number(bar.share, 3)} %)`);
      });
      if (single) return side.bottom + 42;
      return legend(svg, series.map((s) => ({text: s.run.label, draw: sign.box('bar', s.run.colour)})), side.left, side.bottom + 54, side.right) + 12;
    },
    rows: () => [['run', `from_${unit}`, `to_${unit}`, thing, 'share_percent'], ...all.map((bar) => [bar.run.label, bar.low, bar.high, bar.n, bar.share])],
  });
  return true;
}

// `of(run)` gives statistics with quartiles, minimum, maximum and mean.
function boxFigure(parent, {title, quantity, unit, per = 1, of, width = drawing.half}) {
  const shown = runs.filter((run) => {
    const s = of(run);
    return s && Array.isArray(s.quartiles) && s.quartiles.length === 3 && s.quartiles.every(isNumber) && isNumber(s.minimum) && isNumber(s.maximum);
  });
  if (!shown.length) return false;
  const boxes = shown.map((run) => {
    const s = of(run);
    const [q1, q2, q3] = s.quartiles.map((q) => q / per);
    return {run, low: s.minimum / per, q1, q2, q3, high: s.maximum / per, mean: isNumber(s.mean) ? s.mean / per : null};
  });
  figure(parent, {
    title, label: `${title}: box and whiskers of ${quantity} in ${unit}`,
    caption: '',
    width,
    draw(svg) {
      const tall = 56;
      const side = {left: 24, right: width - 12, top: 8, bottom: 8 + boxes.length * tall};
      const toX = d3.scaleLinear().domain(extentOf(boxes.flatMap((b) => [b.low, b.high]), 0.05)).range([side.left, side.right]);
      axes(svg, toX, {}, side, {xLabel: `${quantity} [${unit}]`});
      boxes.forEach((b, i) => {
        const middle = side.top + (i + 0.5) * tall + (single ? 0 : 7);
        const half = single ? 18 : 14;
        const g = svg.append('g').style('--run', b.run.colour);
        if (!single) g.append('text').attr('class', 'halo').attr('x', side.left + 4).attr('y', middle - half - 5).text(b.run.label);
        const line = (x1, x2, y1, y2, name) => g.append('line').attr('class', name).attr('x1', toX(x1)).attr('x2', toX(x2)).attr('y1', y1).attr('y2', y2);
        line(b.low, b.q1, middle, middle, 'whisker');
        line(b.q3, b.high, middle, middle, 'whisker');
        line(b.low, b.low, middle - half / 2, middle + half / 2, 'whisker');
        line(b.high, b.high, middle - half / 2, middle + half / 2, 'whisker');
        g.append('rect').attr('class', 'box').attr('x', toX(b.q1)).attr('width', Math.max(toX(b.q3) - toX(b.q1), 0.5)).attr('y', middle - half).attr('height', 2 * half);
        line(b.q2, b.q2, middle - half, middle + half, 'median');
        if (b.mean !== null) g.append('path').attr('class', 'mean').attr('d', `M${toX(b.mean) - 5},${middle - 5}l10,10m0,-10l-10,10`);
        tip(g, () => (single ? '' : b.run.label + '\n') + [['greatest', b.high], ['upper quartile', b.q3], ['median', b.q2], ['lower quartile', b.q1], ['least', b.low], ['mean', b.mean]]
          .map(([word, value]) => `${word} ${number(value, 6)} ${unit}`).join('\n'));
      });
      return side.bottom + 42;
    },
    rows: () => [['run', 'minimum', 'quartile_1', 'median', 'quartile_3', 'maximum', 'mean', 'unit'], ...boxes.map((b) => [b.run.label, b.low, b.q1, b.q2, b.q3, b.high, b.mean, unit])],
  });
  return true;
}

function distributionFigures(parent) {
  const endX = {quantity: 'x of the end point', unit: 'm'}, runout = {quantity: 'Runout on plan', unit: 'm'};
  const inSection = (of) => (run) => run.isSection ? of(run) : null;  // in space x says nothing of how far a rock came
  const box = element(parent, 'div', null, {class: 'columns'});
  const hasEnds = histogramFigure(box, {...endX, title: 'End points of the rocks', of: inSection((run) => run.histograms.end_x_m)});
  // Boxes stand beneath the histograms of a section, and beside the only one of a terrain.
  const hasRunout = histogramFigure(box, {...runout, title: 'Runout', tall: hasEnds ? 200 : 330, of: (run) => run.histograms.runout_xy_m});
  const boxes = hasEnds ? box : element(box, 'div');
  const hasBoxes = [
    boxFigure(boxes, {...endX, title: 'Box plot of end points', of: inSection((run) => run.statistics.end_x_m)}),
    boxFigure(boxes, {...runout, title: 'Box plot of runout', of: (run) => run.statistics.runout_xy_m}),
    boxFigure(boxes, {title: 'Box plot of greatest energy', quantity: 'Greatest total kinetic energy of each rock', unit: 'kJ', per: 1000, of: (run) => run.statistics.max_ke_J}),
    boxFigure(boxes, {title: 'Box plot of greatest bounce height', quantity: 'Greatest bounce height of each rock', unit: 'm', of: (run) => run.statistics.max_bounce_m}),
  ].some(Boolean);
  if (!hasEnds && !hasRunout && !hasBoxes) element(parent, 'p', 'The summary holds no histograms.', {class: 'quiet'});
}
