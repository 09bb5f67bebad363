// The parts of D3 that the report's own scripts use.

export { bisectRight, extent, max, mean, quantile, sum, ticks } from 'd3-array';
export { rgb } from 'd3-color';
export { contours } from 'd3-contour';
export { scaleLinear } from 'd3-scale';
export { select } from 'd3-selection';
export { line } from 'd3-shape';
