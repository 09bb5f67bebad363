// Fits tables to the width of a column on paper. The print style is applied once to measure them: a table that is too
// wide is printed in a smaller font, down to a readable size, and beyond that its words and numbers are broken.

const paper = { width: '184mm', least: 0.7 }; // of A4 between the margins of style.css, and of each column of A3

const mediaOf = (rule: CSSRule) => (rule instanceof CSSMediaRule || rule instanceof CSSImportRule ? rule.media : null);

/// Calls `measure` while the page has its style and width on paper.
export function onPaper(measure: () => void, width = paper.width) {
  const rules = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules]);
  const printed = rules.map(mediaOf).filter((media) => media !== null && media.mediaText === 'print') as MediaList[];
  for (const media of printed) media.mediaText = 'all';
  document.body.style.width = width;
  measure();
  document.body.style.width = '';
  for (const media of printed) media.mediaText = 'print';
}

export function fitTablesToPaper() {
  const columns = document.body.className;
  document.body.className = ''; // a page as wide as a column
  onPaper(() => {
    for (const node of document.querySelectorAll<HTMLElement>('.scroll > table')) {
      const room = () => node.parentElement!.clientWidth / node.offsetWidth;
      let size = 1;
      while (room() < 1 && size > paper.least) {
        size = Math.max(paper.least, size - 0.05);
        node.style.setProperty('--on-paper', String(size));
      }
      if (room() < 1) node.classList.add('broken');
    }
  });
  document.body.className = columns;
}
