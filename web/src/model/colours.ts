// The colour by which a material is known, in lists and in the view alike.

const palette = [
  '#8c7a6b',
  '#5f8a5b',
  '#c2a05a',
  '#6b86a6',
  '#a6675f',
  '#7d6ba0',
  '#4d9a97',
  '#b98a9f',
  '#9aa34f',
  '#5c6470',
];

export const materialColour = (index: number) => palette[index % palette.length]!;
