// The documentation of Talus: the text of each file in docs/, loaded when it is read.

const files = import.meta.glob<string>('../../../docs/*.md', { query: '?raw', import: 'default' });

/// The names of all documents.
export const documents = Object.keys(files).map((path) => path.slice(path.lastIndexOf('/') + 1));

/// The text of a document, such as `laws.md`. Rejects if there is none of that name.
export async function textOf(document: string): Promise<string> {
  const load = files[`../../../docs/${document}`];
  if (!load) throw new Error(`there is no document ${document}`);
  return load();
}
