// The sections of the model's outline.

import type { Path, TableName } from './names';

export interface Section {
  name: TableName;
  title: string;
  /// The tables whose forms are in the section.
  tables: (TableName | '')[];
  /// Repeated tables; each entry is an item of the section.
  lists: { key: TableName; one: string; only3d?: boolean }[];
}

export const sections: Section[] = [
  { name: 'analysis', title: 'Project and analysis', tables: ['', 'analysis'], lists: [] },
  { name: 'terrain', title: 'Terrain', tables: ['terrain'], lists: [] },
  { name: 'material', title: 'Materials', tables: [], lists: [{ key: 'material', one: 'material' }] },
  {
    name: 'ground',
    title: 'Ground',
    tables: ['ground'],
    lists: [
      { key: 'area', one: 'area', only3d: true },
      { key: 'forest', one: 'forest', only3d: true },
    ],
  },
  { name: 'seeder', title: 'Seeders', tables: [], lists: [{ key: 'seeder', one: 'seeder' }] },
  {
    name: 'barrier',
    title: 'Barriers and collectors',
    tables: [],
    lists: [
      { key: 'barrier', one: 'barrier' },
      { key: 'collector', one: 'collector' },
    ],
  },
  { name: 'layer', title: 'Reference layers', tables: [], lists: [{ key: 'layer', one: 'layer', only3d: true }] },
  { name: 'sampling', title: 'Sampling', tables: ['sampling'], lists: [] },
  { name: 'output', title: 'Output', tables: ['output'], lists: [] },
  { name: 'report', title: 'Title block of the report', tables: ['report'], lists: [] },
  { name: 'design', title: 'Barrier design', tables: ['design'], lists: [{ key: 'kit', one: 'kit' }] },
];

/// The section with the form of a path.
export function sectionOf(path: Path): Section | undefined {
  const key = path[0] ?? '';
  return (
    sections.find(({ tables, lists }) => tables.some((table) => table === key) || lists.some((list) => list.key === key)) ?? sections[0]
  );
}
