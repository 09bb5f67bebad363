// A figure: heading, drawing, caption, buttons that save it, and the box that shows values under the pointer. All text
// is set as text, never as markup: names in it are the user's.

// Widths in the drawings' own units, about a pixel each on a screen. Two halves and the gap of .columns (style.css) make
// a wide one, which is as wide as A4 between its margins: a unit is as long in both.
const drawing = {wide: 900, half: 430, mmOnPaper: 184 / 900};

function element(parent, tag, text, attributes = {}) {
  const made = parent.append(tag);
  if (text !== undefined && text !== null) made.text(text);
  for (const [key, value] of Object.entries(attributes)) made.attr(key, value);
  return made;
}

// Returns {node, head, caption, redraw}. `draw(svg, width)` draws and returns the height it used; `rows()` gives the
// table that the CSV button saves, its first row the column names.
function figure(parent, {title, caption, label, width = drawing.half, draw, rows}) {
  const node = parent.append('figure').attr('class', width === drawing.wide ? 'wide' : '');
  const head = element(node, 'div', null, {class: 'figure-head'});
  element(head, 'h4', title);
  const tools = element(head, 'span', null, {class: 'save'});
  const svg = element(node, 'svg', null, {xmlns: 'http://www.w3.org/2000/svg', role: 'img', 'aria-label': label || title});
  const note = element(node, 'figcaption', caption);
  const redraw = () => {
    svg.attr('data-width', width).selectAll('*').remove();
    const height = draw(svg, width);
    svg.attr('viewBox', `0 0 ${width} ${height}`).attr('data-height', height);
  };
  redraw();
  const name = title.toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, '') || 'figure';
  const button = (text, what, action) =>
    element(tools, 'button', text, {type: 'button', title: `Save as ${text}`, 'aria-label': `Save "${title}" as ${what}`}).on('click', action);
  button('SVG', 'SVG drawing', () => save(name + '.svg', new Blob([svgText(svg.node())], {type: 'image/svg+xml'})));
  button('PNG', 'PNG picture', () => savePng(name + '.png', svg.node()));
  if (rows) button('CSV', 'table of values', () => save(name + '.csv', new Blob([csvText(rows())], {type: 'text/csv'})));
  return {node, head, caption: note, redraw};
}

function save(name, blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function csvText(rows) {
  const cell = (v) => {
    const text = v === null || v === undefined ? '' : String(v);
    return /[",\r\n]/.test(text) ? '"' + text.replace(/"/g, '""') + '"' : text;
  };
  return rows.map((row) => row.map(cell).join(',') + '\n').join('');
}

// The drawing alone, with the page's style written into every element, so that it looks the same anywhere.
function svgText(svg) {
  const kept = ['fill', 'fill-opacity', 'stroke', 'stroke-width', 'stroke-opacity', 'stroke-dasharray', 'stroke-linejoin',
    'stroke-linecap', 'paint-order', 'font-family', 'font-size', 'font-weight', 'text-anchor', 'opacity'];
  const copy = svg.cloneNode(true);
  const from = [svg, ...svg.querySelectorAll('*')];
  const to = [copy, ...copy.querySelectorAll('*')];
  from.forEach((source, i) => {
    const style = getComputedStyle(source);
    for (const property of kept) to[i].style.setProperty(property, style.getPropertyValue(property));
  });
  copy.setAttribute('width', svg.dataset.width);
  copy.setAttribute('height', svg.dataset.height);
  copy.style.background = getComputedStyle(document.body).backgroundColor;
  return new XMLSerializer().serializeToString(copy);
}

function savePng(name, svg) {
  const scale = 2;  // sharp on paper
  const picture = new Image();
  picture.onload = () => {
    const canvas = document.createElement('canvas');
    canvas.width = svg.dataset.width * scale;
    canvas.height = svg.dataset.height * scale;
    const context = canvas.getContext('2d');
    context.fillStyle = getComputedStyle(document.body).backgroundColor;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(picture, 0, 0, canvas.width, canvas.height);
    canvas.toBlob((blob) => save(name, blob), 'image/png');
  };
  picture.src = 'data:image/svg+xml;charset=utf-8,' + encodeURIComponent(svgText(svg));
}

// ---- values under the pointer

const tipBox = d3.select('#tip');

function tip(selection, textOf) {
  selection
    .on('mousemove', function (datum) {
      tipBox.property('hidden', false).text(textOf.call(this, datum));
      const box = tipBox.node().getBoundingClientRect();
      const left = d3.event.clientX + 14 + box.width > innerWidth ? d3.event.clientX - 14 - box.width : d3.event.clientX + 14;
      const top = d3.event.clientY + 16 + box.height > innerHeight ? d3.event.clientY - 12 - box.height : d3.event.clientY + 16;
      tipBox.style('left', left + 'px').style('top', top + 'px');
    })
    .on('mouseleave', () => tipBox.property('hidden', true));
  return selection;
}

// ---- axes

const areEqual = (a, b) => Math.abs(a - b) <= 1e-9 * Math.max(1, Math.abs(a), Math.abs(b));

// A range that holds all values, a little wider than they are; equal but for rounding, they get a metre or so to stand in.
function extentOf(values, margin = 0.04) {
  let [low, high] = d3.extent(values);
  if (low === undefined) [low, high] = [0, 1];
  if (areEqual(low, high)) [low, high] = [low - 0.5, high + 0.5];
  const more = (high - low) * margin;
  return [low - more, high + more];
}

// Draws grid, frame, axes and their labels into the rectangle given by its sides.
function axes(svg, x, y, {left, top, right, bottom}, {xLabel, yLabel, xTicks, yTicks}) {
  const widest = (scale, ticks) => 6.6 * d3.max(scale.ticks(ticks), (v) => tickText(scale, ticks)(v).length);
  const nx = xTicks || Math.max(2, Math.floor((right - left) / Math.max(80, widest(x, 8) + 30)));
  const ny = yTicks || Math.max(3, Math.round((bottom - top) / 45));
  const grid = svg.append('g').attr('class', 'grid');
  grid.append('g').attr('transform', `translate(0,${bottom})`).call(d3.axisBottom(x).ticks(nx).tickSize(top - bottom).tickFormat(''));
  if (y.ticks) grid.append('g').attr('transform', `translate(${left},0)`).call(d3.axisLeft(y).ticks(ny).tickSize(left - right).tickFormat(''));
  const below = svg.append('g').attr('class', 'axis').attr('transform', `translate(0,${bottom})`);
  below.call(d3.axisBottom(x).ticks(nx).tickSizeOuter(0).tickFormat(tickText(x, nx)));
  svg.append('text').attr('class', 'axis-label').attr('x', (left + right) / 2).attr('y', bottom + 34).attr('text-anchor', 'middle').text(xLabel);
  if (!y.ticks) return;
  const beside = svg.append('g').attr('class', 'axis').attr('transform', `translate(${left},0)`);
  beside.call(d3.axisLeft(y).ticks(ny).tickSizeOuter(0).tickFormat(tickText(y, ny)));
  svg.append('text').attr('class', 'axis-label').attr('transform', `translate(${left - widest(y, ny) - 22},${(top + bottom) / 2}) rotate(-90)`)
    .attr('text-anchor', 'middle').text(yLabel);
}

// A row of signs and words; each entry is {text, draw(group)} with a sign 22 wide around y = 0.
function legend(svg, entries, x, y, rightmost = Infinity) {
  let at = x;
  let line = y;
  for (const entry of entries) {
    const group = svg.append('g');
    entry.draw(group);
    const text = group.append('text').attr('x', 28).attr('y', 4).text(entry.text);
    const length = 28 + (text.node().getComputedTextLength() || entry.text.length * 6.5) + 20;
    if (at + length > rightmost && at > x) {
      at = x;
      line += 19;
    }
    group.attr('transform', `translate(${at},${line})`);
    at += length;
  }
  return line;
}

const sign = {
  line: (className, run) => (g) => g.append('line').attr('class', className).attr('x1', 0).attr('x2', 22).attr('fill', 'none').style('--run', run),
  box: (className, run) => (g) => g.append('rect').attr('class', className).attr('x', 2).attr('y', -6).attr('width', 18).attr('height', 12).style('--run', run),
  circle: (className, run) => (g) => g.append('circle').attr('class', className).attr('cx', 11).attr('r', 3.6).style('--run', run),
};
