// Common parts of the maps: a round scale on paper, coordinates, relief, scale bar and north arrow.

// The smallest usual denominator of map scales, such as 2,500, that is at least `minimum`.
function roundScale(minimum) {
  const power = 10 ** Math.floor(Math.log10(minimum));
  return power * [1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 7.5, 10].find((times) => times * power >= minimum * (1 - 1e-9));
}
const unitsPerMetre = (denominator) => 1000 / denominator / drawing.mmOnPaper;

// A tall map takes half the width, so that two fit side by side.
const mapWidth = ({x: [x0, x1], y: [y0, y1]}) => (x1 - x0) / (y1 - y0) < 1.25 ? drawing.half : drawing.wide;

// The room for a map: `across` and `tallest` are those of its frame, which `fills` it if there is ground to show; its
// notes stand beside the legend, or below it.
const mapRoom = (width, tallest = 430, fills = false) => ({width, left: 74, across: width - 74 - 12, tallest, fills, isBeside: width >= drawing.wide});

// The minimum number of metres per drawing unit for the view to fit.
function metresPerUnit({across, tallest}, {x: [x0, x1], y: [y0, y1]}) {
  return Math.max((x1 - x0) / across, (y1 - y0) / tallest);
}

const mapScaleIn = (room, view) => roundScale(metresPerUnit(room, view) * unitsPerMetre(1));

// Extends the interval [a, b] into [low, high] about its centre, up to a length.
function extend([a, b], length, [low, high]) {
  const [first, last] = [Math.min(a, low), Math.max(b, high)];
  if (last - first <= length) return [first, last];
  const from = Math.min(Math.max((a + b - length) / 2, first), last - length);
  return [from, from + length];
}

// The extent of the view and of the terrain of some runs.
function groundOf(shown, view) {
  const bounds = shown.map((run) => run.terrain.bounds).filter(Array.isArray);
  const along = (axis, name) => d3.extent([...view[name], ...bounds.flatMap((corners) => corners.map((corner) => corner[axis]))]);
  return {x: along(0, 'x'), y: along(1, 'y')};
}

// The frame of a map: the view and as much of the surrounding ground as fits; x and y have the same scale.
function mapFrame(room, view, ground) {
  const {left, across, tallest, fills} = room;
  const denominator = mapScaleIn(room, view);
  const scale = unitsPerMetre(denominator);
  const x = extend(view.x, across / scale, ground.x);
  const y = extend(view.y, Math.max(view.y[1] - view.y[0], (fills ? tallest : 0.3 * across) / scale), ground.y);
  const side = {left, top: 12, right: left + (x[1] - x[0]) * scale, bottom: 12 + (y[1] - y[0]) * scale};
  const toX = d3.scaleLinear().domain(x).range([side.left, side.right]), toY = d3.scaleLinear().domain(y).range([side.bottom, side.top]);
  return {side, scale, denominator, shown: {x, y}, toX, toY};
}

// Draws the axes. Returns a group clipped to the frame.
function openMap(svg, id, {side, toX, toY}) {
  axes(svg, toX, toY, side, {xLabel: 'x [m]', yLabel: 'y [m]'});
  svg.append('clipPath').attr('id', id).append('rect').attr('x', side.left).attr('y', side.top).attr('width', side.right - side.left).attr('height', side.bottom - side.top);
  return svg.append('g').attr('clip-path', `url(#${id})`);
}

// Places an image of `size` metres with its south-western corner at `low`.
const layPicture = (group, {toX, toY, scale}, href, name, low, size) => group.append('image').attr('class', name).attr('href', href)
  .attr('preserveAspectRatio', 'none').attr('x', toX(low[0])).attr('y', toY(low[1] + size[1])).attr('width', size[0] * scale).attr('height', size[1] * scale);

function layRelief(group, frame, relief, picture) {
  const half = relief.cell_m / 2;
  layPicture(group, frame, picture, 'relief', [relief.x0 - half, relief.y0 - half], [relief.columns * relief.cell_m, relief.rows * relief.cell_m]);
}

const systemText = (run) => {
  if (run.terrain.crs_wkt) return crsText(run.terrain.crs_wkt);
  return (run.project.terrain || {}).crs === 'local' ? 'Local coordinates' : 'Coordinate system unknown';
};

const scaleText = (denominator) => `Scale 1:${number(denominator)} on ${paperName}`;

// Writes scale and coordinate system: at the right below a wide map, otherwise below everything else (`lowest`). Returns
// the y of their end.
function noteMap(svg, {width, isBeside}, frame, run, more, y, lowest) {
  const lines = [[scaleText(frame.denominator), ...more].join(', '), systemText(run)];
  const top = isBeside ? y : lowest + 16;
  lines.forEach((text, i) => svg.append('text').attr('class', 'map-note').attr('text-anchor', isBeside ? 'end' : 'start')
    .attr('x', isBeside ? width - 12 : frame.side.left).attr('y', top + 17 * i).text(text));
  return Math.max(lowest, top + 17) + 8;
}

// Shaded relief as an image, lit from the north-west at 45 degrees: one pixel per grid point, enlarged with smoothing
// because printers draw pixels as squares.
function hillshade(relief) {
  const {columns, rows, cell_m, z_m} = relief;
  const canvas = document.createElement('canvas');
  canvas.width = columns;
  canvas.height = rows;
  const context = canvas.getContext('2d');
  const image = context.createImageData(columns, rows);
  const at = (i, j) => z_m[Math.min(Math.max(j, 0), rows - 1) * columns + Math.min(Math.max(i, 0), columns - 1)];
  for (let j = 0; j < rows; ++j) {
    for (let i = 0; i < columns; ++i) {
      const z = at(i, j);
      const pixel = 4 * ((rows - 1 - j) * columns + i);
      if (!isNumber(z)) continue;
      const near = (a, b) => isNumber(at(a, b)) ? at(a, b) : z;
      const sx = (near(i + 1, j) - near(i - 1, j)) / (2 * cell_m), sy = (near(i, j + 1) - near(i, j - 1)) / (2 * cell_m);
      const lit = (sx * 0.5 - sy * 0.5 + Math.SQRT1_2) / Math.hypot(sx, sy, 1);
      const grey = Math.round(150 + 100 * Math.min(Math.max(lit, 0), 1));
      image.data.set([grey, grey, Math.max(grey - 6, 0), 255], pixel);
    }
  }
  context.putImageData(image, 0, 0);
  const times = Math.max(1, Math.ceil(800 / Math.max(columns, rows)));
  const large = document.createElement('canvas');
  large.width = columns * times;
  large.height = rows * times;
  const pen = large.getContext('2d');
  pen.imageSmoothingQuality = 'high';
  pen.drawImage(canvas, 0, 0, large.width, large.height);
  return large.toDataURL('image/png');
}

function drawBarrierOnPlan(group, barrier, toX, toY, side) {
  const line = barrierLine(barrier);
  if (line.length < 2) return;
  group.append('path').attr('class', 'barrier').attr('d', 'M' + line.map(([x, y]) => `${toX(x)},${toY(y)}`).join('L'));
  const [x, y] = line[line.length - 1];
  const atRight = toX(x) + 8 + 7.2 * barrier.name.length > side.right;
  group.append('text').attr('class', 'barrier-name halo').attr('x', toX(x) + (atRight ? -8 : 8)).attr('y', Math.max(toY(y) + 4, side.top + 14))
    .attr('text-anchor', atRight ? 'end' : 'start').text(barrier.name);
}

// The largest 1, 2 or 5 times a power of ten that is at most `maximum`.
function roundLength(maximum) {
  const power = 10 ** Math.floor(Math.log10(maximum));
  return power * [5, 2, 1].find((times) => times * power <= maximum);
}

function drawScaleBar(group, side, scale) {
  const length = roundLength((side.right - side.left) / scale / 3);
  const x = side.left + 12, y = side.bottom - 14;
  const bar = group.append('g').attr('class', 'scale-bar');
  bar.append('path').attr('class', 'halo').attr('d', `M${x},${y - 5}v5h${length * scale}v-5`);
  bar.append('path').attr('d', `M${x},${y - 5}v5h${length * scale}v-5`);
  bar.append('text').attr('class', 'halo').attr('x', x + length * scale / 2).attr('y', y - 5).attr('text-anchor', 'middle').text(`${number(length)} m`);
}

// The map's y axis points up; it is north if the terrain has map coordinates.
function drawNorthArrow(group, side, isNorth) {
  const arrow = group.append('g').attr('class', 'north').attr('transform', `translate(${side.left + 20},${side.top + 10})`);
  arrow.append('path').attr('class', 'halo').attr('d', 'M0,0l7,20l-7,-5l-7,5z');
  arrow.append('path').attr('class', 'arrow').attr('d', 'M0,0l7,20l-7,-5l-7,5z');
  arrow.append('text').attr('class', 'halo').attr('y', 33).attr('text-anchor', 'middle').text(isNorth ? 'N' : 'y');
}
