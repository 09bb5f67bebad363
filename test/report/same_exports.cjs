// Whether two bundles of the report's parts of D3 offer the same names, and their scales the same ticks.
const { readFileSync } = require('node:fs');
const { runInNewContext } = require('node:vm');

function offeredBy(file) {
  const d3 = runInNewContext(`${readFileSync(file, 'utf8')};d3`, {});
  const names = Object.keys(d3).sort();
  const ticks = [[0, 1], [-3, 2667000], [0.0012, 0.0019]].map((range) => d3.scaleLinear().domain(range).ticks(7));
  const cells = [0, 0, 0, 0, 0, 9, 9, 0, 0, 9, 9, 0, 0, 0, 0, 0];
  const lines = d3.contours().size([4, 4]).thresholds([3])(cells).map(({ value }) => value);
  return JSON.stringify({ names, ticks, lines, colour: d3.rgb(1, 2, 3).toString() });
}

const [one, other] = process.argv.slice(2).map(offeredBy);
if (one !== other) {
  console.error(`${one}\n${other}`);
  process.exit(1);
}
