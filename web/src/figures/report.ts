// The modules that the report's scripts use. The bundle is one global, `figures`.
/*! Drawn with D3 (https://d3js.org), copyright 2010-2023 Mike Bostock. Permission to use, copy, modify, and/or
distribute this software for any purpose with or without fee is hereby granted, provided that the above copyright
notice and this permission notice appear in all copies. THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL
WARRANTIES WITH REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS. IN NO EVENT
SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT, INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER
RESULTING FROM LOSS OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER TORTIOUS ACTION,
ARISING OUT OF OR IN CONNECTION WITH THE USE OR PERFORMANCE OF THIS SOFTWARE. */

export * from './boxes';
export * from './cumulative';
export * as d3 from './d3';
export * from './energy';
export * from './envelope';
export * from './files';
export * from '../units/numbers';
export * from './histogram';
export { endsAround } from './oneValue';
export { axes, extentOf, legend, pointIn, sign } from './plot';
export * from './sideView';
export * from './tip';
export * from './tornado';
export { hasEffect } from '../settings/conditions';
export { displayedIn } from '../units/units';
